"""The accuracy check: Table 2.4 by the calibration of Table 2.2, and a unit simulated by hand."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError, Severity
from core.procedures.accuracy import TITLES, Accuracy, Limit, check_accuracy
from core.procedures.calibration import Calibration
from core.procedures.conformity import RULES, Verdict
from core.procedures.dividing_head import calibrate
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

GOLDEN = json.loads((Path(__file__).parents[2] / "data" / "golden.json").read_text("utf-8"))[
    "source001"
]
G = 9.8106
CONDITIONS = Conditions(g_mps2=G)
HEAD = Conditions(g_mps2=G, head_u_arcsec=10.0)
ANGLES = np.array([0, 30, 60, 80, 100, 120, 150, 180, 210, 240, 260, 280, 300, 330, 360], float)
K = np.array([[-1335.0, -13.0, -73.0], [36.0, -1339.0, 12.0], [1.0, 14.0, 1335.0]])
U0 = np.array([-379.0, -195.0, -230.0])


def run_of(test: str, y: np.ndarray, mounts: tuple[str, ...], head: np.ndarray, **changes) -> Run:
    run = plain_run(
        test=test,
        y=y,
        mount=mounts,
        head_deg=head,
    )
    return replace(run, **changes)


def calibration_of(y: np.ndarray, se: float = np.nan) -> Calibration:
    head = np.tile([0.0, 90.0, 180.0, 270.0], 2)
    mounts = ("X_from",) * 4 + ("Y_from",) * 4
    run = run_of("dividing_head", y, mounts, head, y_se=np.full((8, 3), se))
    return calibrate(run, CONDITIONS)


@pytest.fixture(scope="module")
def by_table_2_2() -> Calibration:
    given = GOLDEN["table_2_2"]["input"]
    return calibration_of(np.column_stack([given[f"U_a{axis}"] for axis in "xyz"]))


@pytest.fixture(scope="module")
def by_truth() -> Calibration:
    table_2_1 = np.array(GOLDEN["table_2_2"]["input"]["a_over_g"])
    noise = np.random.default_rng(1).normal(0.0, 0.05, (8, 3))
    return calibration_of(G * table_2_1 @ K.T + U0 + noise, se=0.05)


def table_2_4() -> Run:
    rows = GOLDEN["table_2_4"]
    n = len(rows)
    headings = np.array([248.45, 293.7, 320.5])
    extra = {
        "step": np.arange(1.0, n + 1),
        "unit_heading_deg": headings,
        "unit_pitch_deg": np.array([row["ahrs_pitch_deg"] for row in rows]),
        "unit_roll_deg": np.array([row["ahrs_roll_deg"] for row in rows]),
        "mag_pitch_deg": np.array([row["unit_accel_mag_pitch_deg"] for row in rows]),
        "mag_roll_deg": np.array([row["unit_accel_mag_roll_deg"] for row in rows]),
    }
    y = np.array([row["U"] for row in rows])
    return run_of("accuracy", y, ("",) * n, np.full(n, np.nan), extra=extra)


def simulated(kind: str, noise: float = 0.0, seed: int = 2, **changes) -> Run:
    """A unit turned through the list of angles by its own geometry, with what it answers."""
    theta = np.deg2rad(ANGLES)
    zero, s, c = np.zeros_like(theta), np.sin(theta), np.cos(theta)
    a = G * np.column_stack([zero, s, c] if kind == "pitch" else [-s, zero, c])
    y = a @ K.T + U0 + np.random.default_rng(seed).normal(0.0, noise, (15, 3))
    over = np.abs((ANGLES + 180.0) % 360.0 - 180.0) > 90.0
    if kind == "pitch":
        unit_pitch, unit_roll = np.rad2deg(np.arcsin(s)), np.where(over, 180.0, 0.0)
    else:
        unit_pitch, unit_roll = zero, (ANGLES + 180.0) % 360.0 - 180.0
    extra = {
        "unit_pitch_deg": np.round(unit_pitch, 2),
        "unit_roll_deg": np.round(unit_roll, 2),
        "unit_heading_deg": np.where(over & (kind == "pitch"), 190.0, 10.0),
    }
    mount = "X_from" if kind == "pitch" else "Y_from"
    return run_of("accuracy", y, (mount,) * 15, (-ANGLES) % 360.0, extra=extra, **changes)


def subjects(found: Accuracy) -> set[str]:
    return {note.subject for note in found.notes}


def test_table_2_4(by_table_2_2: Calibration):
    found = check_accuracy(table_2_4(), CONDITIONS, calibration=by_table_2_2)
    rows = GOLDEN["table_2_4"]
    own, inter = found.trace("own"), found.trace("inter")
    assert found.kind == "pitch"
    assert not found.full_turn
    assert np.array_equal(found.set_deg, [0.0, 30.0, 60.0])
    assert np.allclose(own.pitch, [row["pitch_deg"] for row in rows], rtol=1e-6)
    assert np.allclose(own.roll, [row["roll_deg"] for row in rows], rtol=1e-6)
    assert np.allclose(own.error, [row["pitch_error_deg"] for row in rows], rtol=1e-6)
    assert np.allclose(found.force, [row["a"] for row in rows], atol=1e-7)
    assert np.allclose(found.force_error, [row["norm_minus_g"] for row in rows], rtol=1e-6)
    assert np.allclose(inter.error, [row["ahrs_pitch_error_deg"] for row in rows], atol=1e-9)
    assert np.allclose(inter.cross_error, [row["ahrs_roll_deg"] for row in rows], atol=1e-9)
    assert found.trace("mags_accels").pitch[2] == 60.01
    # Resolution of 0.01 deg as reported.
    assert np.allclose(inter.u_error, 0.01 / np.sqrt(12.0))


def test_table_2_4_shows_that_the_sensors_changed_since(by_table_2_2: Calibration):
    found = check_accuracy(table_2_4(), CONDITIONS, calibration=by_table_2_2)
    note = next(n for n in found.notes if n.subject == "force_differs")
    assert "row 1" in note.text
    assert "-1.66 mg" in note.text
    assert "calibration_exceeded" in subjects(found)


@pytest.mark.parametrize("kind", ["pitch", "roll"])
def test_a_right_unit_is_right_over_the_full_turn(kind: str, by_truth: Calibration):
    found = check_accuracy(simulated(kind, 0.05), HEAD, calibration=by_truth)
    assert found.kind == kind
    assert found.full_turn is (kind == "pitch")
    assert np.allclose(found.set_deg % 360.0, ANGLES % 360.0, atol=1e-12)
    for trace in found.traces:
        assert trace.statistics.rms < 0.02, trace.source
        assert np.nanmax(np.abs(trace.cross_error)) < 0.02
    assert np.nanmax(np.abs(found.trace("inter").heading_error)) == 0.0
    assert np.all(np.isnan(found.trace("own").heading))
    assert subjects(found) == set()


def test_sources_stand_in_the_order_of_their_titles(by_truth: Calibration):
    run = simulated("pitch")
    extra = {**run.extra, "mag_pitch_deg": run.extra["unit_pitch_deg"] + 0.5}
    extra["mag_roll_deg"] = run.extra["unit_roll_deg"]
    found = check_accuracy(replace(run, extra=extra), HEAD, calibration=by_truth)
    assert [trace.source for trace in found.traces] == list(TITLES)
    with pytest.raises(KeyError):
        found.trace("compass")


def test_the_mounting_on_the_head_is_taken_out_of_the_aligned_errors(by_truth: Calibration):
    run = simulated("pitch")
    theta = np.deg2rad(ANGLES + 0.4)
    a = G * np.column_stack([0.0 * theta, np.sin(theta), np.cos(theta)])
    found = check_accuracy(replace(run, y=a @ K.T + U0), HEAD, calibration=by_truth)
    assert np.allclose(found.trace("own").error, 0.4, atol=0.02)
    assert found.trace("aligned").statistics.rms < 0.02
    assert "calibration_exceeded" in subjects(found)


def test_a_unit_without_raw_codes_is_judged_by_its_own_angles(by_truth: Calibration):
    run = simulated("roll")
    bare = replace(run, y=run.y[:, :0], y_se=run.y_se[:, :0], channels=(), axes=())
    found = check_accuracy(bare, HEAD, calibration=by_truth)
    assert [trace.source for trace in found.traces] == ["inter", "aligned"]
    assert subjects(found) == {"no_raw_codes"}
    assert found.codes.shape == (15, 0)
    assert np.all(np.isnan(found.force_error))


def test_codes_without_a_calibration_are_not_judged():
    found = check_accuracy(simulated("roll"), HEAD)
    assert [trace.source for trace in found.traces] == ["inter", "aligned"]
    assert subjects(found) == {"no_calibration"}
    assert found.codes.shape == (15, 3)


def test_codes_may_stand_beside_the_outputs(by_truth: Calibration):
    run = simulated("pitch")
    extra = {**run.extra, **{f"acc_{axis}": run.y[:, i] for i, axis in enumerate("xyz")}}
    beside = replace(
        run,
        sensor="gyro",
        channels=("gyro_x",),
        axes=("x",),
        y=run.y[:, :1] * 0.0 + 1.0,
        y_se=run.y_se[:, :1],
        extra=extra,
    )
    found = check_accuracy(beside, HEAD, calibration=by_truth)
    assert found.trace("own").statistics.rms < 0.02


def test_limits_give_verdicts_with_the_uncertainty_of_the_head(by_truth: Calibration):
    run = simulated("roll")
    extra = dict(run.extra)
    extra["unit_roll_deg"] = run.extra["unit_roll_deg"] + 0.05
    run = replace(run, extra=extra)
    u = np.hypot(10.0 / 3600.0, 0.01 / np.sqrt(12.0))
    for limit, expected in ((0.05 + 1.97 * u, "pass"), (0.05, "undecided"), (0.04, "fail")):
        found = check_accuracy(run, HEAD, limit=Limit(limit))
        assert np.allclose(found.trace("inter").u_error, u)
        assert found.trace("inter").verdict is Verdict(expected)
    simple = check_accuracy(run, HEAD, limit=Limit(0.0501, RULES["simple"]))
    assert simple.trace("inter").verdict is Verdict.PASS
    assert simple.limit is not None
    assert "ILAC" in simple.limit.rule.text
    assert check_accuracy(run, HEAD).trace("inter").verdict is None
    blind = check_accuracy(run, CONDITIONS, limit=Limit(0.1))
    assert "head_u_missing" in subjects(blind)
    assert "head_u_missing" not in subjects(check_accuracy(run, HEAD, limit=Limit(0.1)))


def test_the_noise_of_the_mean_and_of_single_samples(by_truth: Calibration):
    se, std = 0.5, 20.0
    run = simulated("pitch", y_se=np.full((15, 3), se))
    extra = {**run.extra, **{f"std_acc_{axis}": np.full(15, std) for axis in "xyz"}}
    extra["std_unit_pitch_deg"] = np.full(15, 0.07)
    found = check_accuracy(replace(run, extra=extra), HEAD, calibration=by_truth)
    own = found.trace("own")
    # One code is 1/1337 of a m/s^2, turned into an angle by 1/g.
    per_code = np.rad2deg(1.0 / 1337.0 / G)
    assert np.allclose(own.u_error, np.hypot(se * per_code, 10.0 / 3600.0), rtol=0.01)
    assert own.statistics.noise_std == pytest.approx(std * per_code, rel=0.01)
    assert found.trace("inter").statistics.noise_std == pytest.approx(0.07)


def test_another_unit_is_named(by_truth: Calibration):
    found = check_accuracy(simulated("pitch", device="PW10"), HEAD, calibration=by_truth)
    (note,) = [n for n in found.notes if n.subject == "other_unit"]
    assert "'PW09'" in note.text
    assert "'PW10'" in note.text


def test_a_reversed_mount_is_named(by_truth: Calibration):
    reversed_ = simulated("pitch", mount=("X_to",) * 15)
    found = check_accuracy(reversed_, HEAD, calibration=by_truth)
    (note,) = [n for n in found.notes if n.subject == "sign_reversed"]
    assert note.severity is Severity.ERROR


def test_another_list_of_angles_is_named(by_truth: Calibration):
    shifted = simulated("pitch", head_deg=(-ANGLES + 45.0) % 360.0)
    assert "wrong_angles" in subjects(check_accuracy(shifted, HEAD, calibration=by_truth))


def test_given_angles_stand_before_inferred_ones(by_table_2_2: Calibration):
    run = table_2_4()
    found = check_accuracy(
        run, CONDITIONS, calibration=by_table_2_2, kind="pitch", angles_deg=[0.0, 30.0, 60.1]
    )
    assert found.trace("own").error[2] == pytest.approx(0.0589965 - 0.1, abs=1e-6)
    assert "angles_inferred" not in subjects(found)
    assert "angles_inferred" in subjects(check_accuracy(run, CONDITIONS, calibration=by_table_2_2))


def test_inferred_angles_tell_pitch_from_roll_by_the_data(by_truth: Calibration):
    for kind in ("pitch", "roll"):
        run = simulated(kind)
        legacy = replace(
            run,
            mount=("",) * 15,
            head_deg=np.full(15, np.nan),
            extra={**run.extra, "step": np.arange(1.0, 16.0)},
        )
        found = check_accuracy(legacy, HEAD, calibration=by_truth)
        assert found.kind == kind
        assert found.trace("own").statistics.rms < 0.02


@pytest.mark.slow
def test_the_own_uncertainty_covers_the_errors():
    rng = np.random.default_rng(5)
    table_2_1 = np.array(GOLDEN["table_2_2"]["input"]["a_over_g"])
    inside = total = 0
    run = simulated("roll")
    for _ in range(300):
        noise = rng.normal(0.0, 2.0, (8, 3))
        calibration = calibration_of(G * table_2_1 @ K.T + U0 + noise, se=2.0)
        y = run.y + rng.normal(0.0, 2.0, (15, 3))
        found = check_accuracy(
            replace(run, y=y, y_se=np.full((15, 3), 2.0)), CONDITIONS, calibration=calibration
        )
        own = found.trace("own")
        u = np.hypot(own.u_error, found.u_calibration)
        inside += np.count_nonzero(np.abs(own.error) < 1.96 * u)
        total += len(u)
    assert 0.93 < inside / total < 0.97


@pytest.mark.parametrize(
    ("changes", "arguments", "says"),
    [
        ({"mount": ("Z_from",) * 15}, {}, "X along the shaft, roll with Y"),
        ({"mount": ("",) * 15, "head_deg": np.full(15, np.nan)}, {}, "give them, e.g. 0,30,60"),
        ({}, {"angles_deg": [0.0, 30.0]}, "2 set angles were given for 15 rows"),
        ({"extra": {}}, {}, "neither angles of the unit nor raw codes with a calibration"),
    ],
)
def test_what_cannot_be_checked_is_refused_in_words(changes, arguments, says: str):
    with pytest.raises(FitError, match=says):
        check_accuracy(replace(simulated("pitch"), **changes), HEAD, **arguments)


def test_a_calibration_that_does_not_fit_is_refused(by_truth: Calibration):
    with pytest.raises(FitError, match="takes code, the codes are in V"):
        check_accuracy(simulated("pitch", unit="V"), HEAD, calibration=by_truth)
    with pytest.raises(FitError, match="this one is of gyros"):
        check_accuracy(simulated("pitch"), HEAD, calibration=replace(by_truth, sensor="gyro"))
    with pytest.raises(FitError, match="no rows"):
        check_accuracy(simulated("pitch").rows([]), HEAD)
