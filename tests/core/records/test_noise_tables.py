"""Coefficients in every convention, and devices side by side."""

import numpy as np
import pytest

from core.records.noise_study import NoiseStudy, StudyRequest, study
from core.records.noise_tables import by_method, comparison, in_conventions, terms_of
from core.records.series import Series
from core.samples.block import Channel
from tests.core.records.noise_records import gyro_noise


def found(unit: str = "deg/s", seed: int = 1) -> NoiseStudy:
    values = gyro_noise(20_000, 20.0, (0.02, 0.0125, 3e-4), seed)
    channel = Channel("y", unit, "rate.z")
    return study(Series("r", "G", (channel,), (values,), 20_000, rate=20.0), StudyRequest())


def test_one_coefficient_in_all_conventions() -> None:
    one = found().published
    quotes = {quote.unit: quote for quote in in_conventions(one, "random_walk")}
    n = one.row("random_walk").value
    assert quotes["deg/sqrt(h)"].value == pytest.approx(60.0 * n)
    assert quotes["deg/s/sqrt(Hz)"].value == pytest.approx(np.sqrt(2.0) * n)
    floor = [q for q in in_conventions(one, "bias_instability") if "0.664" in q.text]
    assert floor[0].value == pytest.approx(0.66428 * one.row("bias_instability").value, rel=1e-4)


def test_methods_stand_side_by_side() -> None:
    one = found().published
    assert terms_of(one)[:3] == ("random_walk", "bias_instability", "rate_random_walk")
    quotes = by_method(one, "random_walk")
    assert [q.method for q in quotes if q is not None] == [
        "likelihood",
        "least_squares",
        "graphical",
    ]


def test_devices_in_other_units_are_compared_only_among_themselves() -> None:
    rows = comparison([found(), found("m/s^2", 2)])
    by_unit = {(row.label, row.unit): row.quotes for row in rows}
    first = next(value for (label, unit), value in by_unit.items() if unit == "deg/sqrt(h)")
    assert first[0] is not None
    assert first[1] is None
    assert any(unit == "ug" and quotes[0] is None for (_, unit), quotes in by_unit.items())
