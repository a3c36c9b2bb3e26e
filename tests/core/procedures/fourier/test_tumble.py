"""The source's golden coefficients, well-conditioned quantities first, and what is refused."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError, RankDeficient
from core.fit.quantiles import student_t
from core.plans.plan import load_plans
from core.procedures.fourier.readings import run_of_angles
from core.procedures.fourier.tumble import calibrate_tumble
from core.samples.run import Conditions

GOLDEN = json.loads((Path(__file__).parents[3] / "data" / "golden.json").read_text("utf-8"))
UNIT_G = Conditions(g_mps2=1.0)


def test_the_coefficients_of_the_source(paper, angles_400):
    golden = GOLDEN["source000_simulated"]
    noise = 1e-9 * np.random.default_rng(0).standard_normal((80, 5))
    run = run_of_angles(angles_400, paper(angles_400)[:, None] + noise, "V")
    result = calibrate_tumble(run, UNIT_G)
    assert result.fit.values == pytest.approx(golden["C"], abs=2e-9)
    assert result.misalignment.value == pytest.approx(0.67358067, abs=1e-7)
    assert result.bias.value == pytest.approx(2.5, abs=1e-9)
    # The output falls when Ox rises: k_x = +1 V/g of the source is a projection of gravity.
    assert result.sensitivity.value == pytest.approx(-np.hypot(1.0, 0.0098), abs=1e-9)
    assert result.fit.condition == pytest.approx(1.523, abs=0.3)


def test_the_plan_is_the_arrangement_of_the_source(paper, angles_400):
    plan = load_plans()["fourier_400"]
    assert [step.head_deg for step in plan.steps] == angles_400.tolist()
    run = run_of_angles(angles_400, paper(angles_400), "V")
    assert {step.mount for step in plan.steps} == set(run.mount)
    force = np.array([step.specific_force(1.0) for step in plan.steps])
    assert -force[:, 0] == pytest.approx(-np.sin(np.radians(angles_400)), abs=1e-12)
    assert -force[:, 1] == pytest.approx(-np.cos(np.radians(angles_400)), abs=1e-12)


def test_another_mount_and_axis_give_the_same(paper):
    """A Z sensor about X: its elevation starts at 90 degrees and falls."""
    head = np.arange(0.0, 360.0, 7.5)
    elevation = 90.0 - head
    run = run_of_angles(head, paper(elevation), "V")
    turned = replace(run, axes=("z",), mount=("X_from",) * len(run))
    result = calibrate_tumble(turned, UNIT_G)
    # Y, the other axis of the plane, points down where the source's Oy points up.
    expected = np.array([2.5, -0.9999789122, 0.01175649409, -0.0004999961721, 1.956509e-06])
    assert result.fit.values == pytest.approx(expected, abs=1e-9)
    assert (result.axis, result.cross, result.sense) == ("z", "y", 1)
    assert result.misalignment.value == pytest.approx(-0.67358067, abs=1e-7)


def test_each_effect_moves_its_own_harmonics_only(paper, angles_400):
    def found(harmonics: int = 3, **changed) -> np.ndarray:
        run = run_of_angles(angles_400, paper(angles_400, alpha0=0.0, **changed), "V")
        return calibrate_tumble(run, UNIT_G, harmonics=harmonics).fit.values

    plain = found()
    assert found(u0=3.0) - plain == pytest.approx([0.5, 0, 0, 0, 0, 0, 0], abs=1e-12)
    assert found(kx=1.1) - plain == pytest.approx([0, -0.1, 0, 0, 0, 0, 0], abs=1e-12)
    assert found(ky=0.0198) - plain == pytest.approx([0, 0, -0.01, 0, 0, 0, 0], abs=1e-12)
    assert found(kxy=0.003) - plain == pytest.approx([0, 0, 0, 0.001, 0, 0, 0], abs=1e-12)
    assert found(k2=0.004) - plain == pytest.approx([0.002, 0, 0, 0, -0.002, 0, 0], abs=1e-12)
    assert found(k3=0.004) - plain == pytest.approx([0, -0.003, 0, 0, 0, 0.001, 0], abs=1e-12)


def test_g_scales_the_sensitivity_and_adds_its_uncertainty(paper, angles_400):
    u = paper(angles_400)[:, None] + 1e-4 * np.random.default_rng(1).standard_normal((80, 3))
    run = run_of_angles(angles_400, u, "V")
    exact = calibrate_tumble(run, Conditions(g_mps2=9.81))
    unsure = calibrate_tumble(run, Conditions(g_mps2=9.81, u_g_mps2=0.01))
    assert exact.sensitivity.value == pytest.approx(-1.0 / 9.81, rel=1e-3)
    expected = np.hypot(exact.sensitivity.u, 0.01 / 9.81**2)
    assert unsure.sensitivity.u == pytest.approx(expected, rel=1e-3)
    assert unsure.misalignment.u == exact.misalignment.u


def test_the_error_of_the_head_is_in_the_uncertainty(paper, angles_400):
    run = run_of_angles(angles_400, paper(angles_400), "V", u_se=np.full(80, 1e-7))
    result = calibrate_tumble(run, Conditions(g_mps2=1.0, head_u_arcsec=10.0))
    # Equal weights would give u_a sqrt(3/2n): the error acts where the output is steep, and there
    # it has less weight.
    equal = 10.0 / 3600.0 * np.sqrt(1.5 / 80)
    assert 0.75 * equal < result.misalignment.u < equal


def test_the_overlap_shows_drift(paper, angles_400):
    rng = np.random.default_rng(2)
    drift = np.linspace(0.0, 2e-3, 80)
    u = paper(angles_400)[:, None] + drift[:, None] + 1e-5 * rng.standard_normal((80, 5))
    run = run_of_angles(angles_400, u, "V")
    result = calibrate_tumble(run, UNIT_G)
    assert result.overlap is not None
    assert result.overlap.pairs == 40
    assert result.overlap.drift.value == pytest.approx(2e-3 * 72 / 79, rel=0.02)
    assert "drift" in [note.subject for note in result.notes]
    still = run_of_angles(angles_400, u - drift[:, None], "V")
    quiet = calibrate_tumble(still, UNIT_G)
    assert quiet.overlap is not None
    assert not quiet.overlap.significant
    assert "drift" not in [note.subject for note in quiet.notes]


def test_a_steady_drift_is_fitted_along(paper, angles_400):
    drift = np.linspace(-1e-3, 1e-3, 80)
    run = run_of_angles(angles_400, paper(angles_400) + drift, "V")
    result = calibrate_tumble(run, UNIT_G, remove_drift=True)
    assert result.fit.value("drift") == pytest.approx(2e-3, abs=1e-12)
    assert result.misalignment.value == pytest.approx(0.67358067, abs=1e-7)
    assert abs(calibrate_tumble(run, UNIT_G).misalignment.value - 0.67358067) > 0.01


def test_without_overlap_there_is_no_drift_check(paper):
    head = np.arange(0.0, 360.0, 15.0)
    assert calibrate_tumble(run_of_angles(head, paper(head), "V"), UNIT_G).overlap is None


def test_an_arc_is_used_with_a_warning(paper):
    head = np.arange(0.0, 200.0, 5.0)
    result = calibrate_tumble(run_of_angles(head, paper(head), "V"), UNIT_G)
    assert "partial_turn" in [note.subject for note in result.notes]


def test_replicates_reject_a_model_without_the_third_harmonic(paper, angles_400):
    u = paper(angles_400, k3=0.01)[:, None] + 1e-5 * np.random.default_rng(3).normal(size=(80, 5))
    run = run_of_angles(angles_400, u, "V")
    second, third = (calibrate_tumble(run, UNIT_G, harmonics=n) for n in (2, 3))
    assert "lack_of_fit" in [note.subject for note in second.notes]
    assert "lack_of_fit" not in [note.subject for note in third.notes]
    assert third.harmonics[2].sine.value == pytest.approx(0.0025, rel=1e-3)
    assert third.harmonics[2].amplitude > 10.0 * third.harmonics[2].sine.u


def test_bad_input_is_refused_in_words(paper):
    few = np.array([0.0, 50.0, 100.0, 200.0])
    with pytest.raises(FitError, match="4 different angles for 5 coefficients"):
        calibrate_tumble(run_of_angles(few, paper(few), "V"), UNIT_G)
    six = np.arange(0.0, 360.0, 60.0)
    with pytest.raises(FitError, match="6 different angles for 7"):
        calibrate_tumble(run_of_angles(six, paper(six), "V"), UNIT_G, harmonics=3)
    again = np.array([0.0, 360.0, 50.0, 410.0, 100.0, 200.0])
    with pytest.raises(FitError, match="4 different angles"):
        calibrate_tumble(run_of_angles(again, paper(again), "V"), UNIT_G)
    square = np.arange(0.0, 720.0, 90.0)
    with pytest.raises(RankDeficient, match="second harmonic is invisible"):
        calibrate_tumble(run_of_angles(square, paper(square), "V"), UNIT_G)
    full = np.arange(0.0, 360.0, 10.0)
    run = run_of_angles(full, paper(full), "V")
    with pytest.raises(FitError, match="gravity"):
        calibrate_tumble(run, Conditions(g_mps2=-9.8))
    with pytest.raises(FitError, match="not a number"):
        calibrate_tumble(replace(run, y=np.where(run.order[:, None] == 3, np.nan, run.y)), UNIT_G)
    lost = np.where(run.order == 5, np.nan, run.head_deg)
    with pytest.raises(FitError, match="row 6: the head angle is missing"):
        calibrate_tumble(replace(run, head_deg=lost), UNIT_G)
    with pytest.raises(FitError, match="saturated"):
        calibrate_tumble(replace(run, y=np.minimum(run.y, 3.3)), UNIT_G)
    noise = 1e-3 * np.random.default_rng(4).standard_normal((36, 1))
    with pytest.raises(FitError, match="does not follow the head"):
        calibrate_tumble(replace(run, y=2.5 + noise), UNIT_G)
    with pytest.raises(FitError, match="lies along the shaft"):
        calibrate_tumble(replace(run, axes=("z",)), UNIT_G)
    with pytest.raises(FitError, match="state the case axis"):
        calibrate_tumble(replace(run, axes=("",)), UNIT_G)
    with pytest.raises(FitError, match="X_from, Z_to@-90"):
        calibrate_tumble(replace(run, mount=("X_from", *run.mount[1:])), UNIT_G)
    with pytest.raises(FitError, match="4 harmonics"):
        calibrate_tumble(run, UNIT_G, harmonics=4)
    near = np.linspace(0.0, 20.0, 40)
    with pytest.raises(FitError, match="condition"):
        calibrate_tumble(run_of_angles(near, paper(near), "V"), UNIT_G)


@pytest.mark.slow
@pytest.mark.parametrize("known", [True, False])
def test_intervals_hold_the_truth(paper, known: bool):
    head = np.arange(0.0, 360.0, 15.0)
    exact, noise, trials = paper(head), 2e-4, 1000
    truth = (2.5, -np.hypot(1.0, 0.0098), 0.67358067, 4.99996172e-4, 1.9565e-6)
    rng = np.random.default_rng(77)
    hits = np.zeros(5)
    se = np.full((24, 2), noise) if known else None
    for _ in range(trials):
        u = exact[:, None] + noise * rng.standard_normal((24, 2))
        result = calibrate_tumble(run_of_angles(head, u, "V", u_se=se), UNIT_G)
        second = result.harmonics[1]
        found = (result.bias, result.sensitivity, result.misalignment, second.sine, second.cosine)
        hits += [
            abs(one.value - true) < one.expanded() for one, true in zip(found, truth, strict=True)
        ]
    assert np.all((hits / trials > 0.93) & (hits / trials < 0.97))
    assert student_t(0.95, result.bias.dof) > (1.95 if known else 2.0)
