"""(3.10) and whether its two files are of one unit: Tables 3.2 and 3.3 are not."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError, Severity
from core.procedures.g_sensitivity import GSensor, fit_g_sensitivity
from core.procedures.rate_table import RateSensor, calibrate_rate_table
from core.procedures.two_files import calibrated_by_3_10, compare_runs
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

GOLDEN = json.loads((Path(__file__).parents[2] / "data" / "golden.json").read_text("utf-8"))[
    "source001"
]
G = 9.8106
CONDITIONS = Conditions(g_mps2=G)
RATES = np.arange(-100.0, 101.0, 20.0)
TEMPERATURES = np.array(
    [24803.0, 24798, 24795, 24795, 24797, 24791, 24788, 24795, 24797, 24798, 24799]
)


def run_of(test: str, y: np.ndarray, device: str, **changes) -> Run:
    n = len(y)
    unknown = np.full(n, np.nan)
    run = plain_run(
        test=test,
        sensor="gyro",
        device=device,
        channels=("gyro_1",),
        axes=("z",),
        y=y,
        mount=("",) * n if test == "rate_table" else ("X_from",) * n,
        head_deg=unknown if test == "rate_table" else np.array([0.0, 90.0, 180.0, 270.0]),
        set_rate_dps=RATES if test == "rate_table" else unknown,
    )
    return replace(run, **changes)


def table(device: str = "A", zero: float = -718.0, **changes) -> Run:
    y = zero - 79.4 * RATES + np.random.default_rng(1).normal(0.0, 1.0, 11)
    return run_of("rate_table", y, device, **changes)


def head(device: str = "A", zero: float = -718.0, **changes) -> Run:
    y = zero + np.array([0.1, -10.0, -0.1, 11.0])
    return run_of("static_positions", y, device, **changes)


def both(one: Run, other: Run) -> tuple[Run, RateSensor, Run, GSensor]:
    on_table = calibrate_rate_table(one, CONDITIONS).sensors[0]
    on_head = fit_g_sensitivity(other, CONDITIONS).sensors[0]
    return one, on_table, other, on_head


@pytest.fixture
def practicum() -> tuple[Run, RateSensor, Run, GSensor]:
    of_table = np.array(GOLDEN["table_3_2"]["input"]["U"])
    of_head = np.array(GOLDEN["table_3_3"]["input"]["U"])
    return both(
        run_of("rate_table", of_table, "ADXRS610", extra={"temp_1": TEMPERATURES}),
        run_of("static_positions", of_head, "Gyro31", extra={"temp_1": TEMPERATURES[:4]}),
    )


def test_tables_3_2_and_3_3_are_refused_by_name_zero_and_temperature(practicum):
    with pytest.raises(FitError) as raised:
        calibrated_by_3_10(*practicum)
    text = str(raised.value)
    assert "'ADXRS610'" in text
    assert "'Gyro31'" in text
    assert "-438.08 code on the table" in text
    assert "-718.13" in text
    assert "-3.53 deg/s into every rate" in text
    assert "digit for digit" in text


def test_the_operators_word_gives_table_3_7(practicum):
    found = calibrated_by_3_10(*practicum, same_unit=True)
    golden = GOLDEN["table_3_3"]["with_k_z_from_table_3_2"]
    assert np.allclose(found.measured, golden["omega_cal_eq_3_10"], rtol=1e-7)
    assert np.allclose(found.error, golden["error_eq_3_10"], rtol=1e-6)
    assert np.array_equal(found.set_rate, RATES)
    assert found.pair.refused
    assert found.pair.in_rate.value == pytest.approx(np.mean(found.error), rel=1e-9)


def test_one_unit_on_one_day_is_accepted_without_a_word():
    found = calibrated_by_3_10(*both(table(), head()))
    assert found.pair.notes == ()
    assert not found.pair.refused
    assert np.abs(found.error).max() < 0.05


def test_a_zero_that_moved_is_said_with_its_size():
    pair = compare_runs(*both(table(zero=-700.0), head()))
    (note,) = pair.notes
    assert note.subject == "zero_differs"
    assert note.severity is Severity.WARNING
    assert "another day" in note.text
    assert pair.in_rate.value == pytest.approx(18.0 / -79.4, rel=0.05)


def test_gravity_on_the_table_is_counted():
    # 5 code/(m/s^2) along Z: upright on the table the zero is 49 codes higher than the bias.
    with_g = head()
    with_g = replace(with_g, y=with_g.y + 5.0 * G * np.array([1.0, 0, -1, 0])[:, None])
    upright = compare_runs(*both(table(zero=-718.0 + 5.0 * G), with_g))
    assert upright.notes == ()
    hanging = table(zero=-718.0 - 5.0 * G, mount=("Z_to",) * 11)
    assert compare_runs(*both(hanging, with_g)).notes == ()


def test_temperatures_that_differ_are_said():
    cold = head(temperature_c=np.full(4, 20.0))
    warm = table(temperature_c=np.full(11, 26.0))
    (note,) = compare_runs(*both(warm, cold)).notes
    assert note.subject == "temperature_differs"
    assert "26.0 degC" in note.text


@pytest.mark.parametrize(
    ("of_head", "subject"),
    [
        (TEMPERATURES[:4] + 400.0, "temperature_differs"),
        (TEMPERATURES[:4], "temperature_copied"),
        (TEMPERATURES[4:8], None),
    ],
)
def test_temperatures_in_codes_are_compared(of_head: np.ndarray, subject: str | None):
    pair = compare_runs(
        *both(table(extra={"temp_1": TEMPERATURES}), head(extra={"temp_1": of_head}))
    )
    assert [note.subject for note in pair.notes] == ([subject] if subject else [])
