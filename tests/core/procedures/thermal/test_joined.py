"""Sessions of one cycle put together."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.thermal.cycle import calibrate_thermal
from core.procedures.thermal.joined import joined
from core.samples.run import Conditions

CASE = Conditions(g_mps2=9.8106)


def test_parts_of_a_cycle_give_the_cycle(make_chamber):
    whole = make_chamber()
    parts = []
    for place in range(9):
        part = whole.rows(range(8 * place, 8 * place + 8))
        meta = {"measured_utc": f"2026-01-{place + 1:02d}T10:00:00+00:00"}
        parts.append(replace(part, order=np.arange(8), meta=meta))
    put = joined([parts[place] for place in (3, 0, 8, 1, 2, 4, 7, 6, 5)])
    assert put.y.tolist() == whole.y.tolist()
    assert put.order.tolist() == list(range(72))
    found, expected = (calibrate_thermal(run, CASE).channels[0] for run in (put, whole))
    assert found.fit.values.tolist() == expected.fit.values.tolist()
    assert len(found.hysteresis) == len(expected.hysteresis)


def test_without_times_the_order_given_holds(make_chamber):
    run = make_chamber()
    put = joined([run.rows(range(8, 16)), run.rows(range(8))])
    assert put.temperature_c[0] == run.temperature_c[8]
    assert joined([run]) is run


def test_what_does_not_belong_together(make_chamber):
    run = make_chamber()
    with pytest.raises(FitError, match="differ in unit: 'V' and 'code'"):
        joined([run, replace(run, unit="V")])
    with pytest.raises(FitError, match="no run"):
        joined([])
    doubts = [
        note.subject
        for note in joined(
            [
                replace(run, conditions=CASE),
                replace(run, device="PW10", conditions=Conditions(g_mps2=9.80)),
            ]
        ).notes
    ]
    assert doubts == ["several_devices", "several_g"]
