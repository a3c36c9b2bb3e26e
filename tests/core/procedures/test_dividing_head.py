"""The practicum's tables, one injected error at a time, contradictions, and coverage."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.fit.quantiles import student_t
from core.plans.plan import Plan, load_plans
from core.procedures.dividing_head import calibrate
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

G = 9.8106
KYIV = Conditions(g_mps2=G)
STEADY = Conditions(g_mps2=G, repeatability=0.0)
PLANS = load_plans()

# Practicum, Table 1.2 (MS9002.D about X) and Table 2.2 (PW09 about X and Y).
TABLE_1_2 = np.array([[13185.47], [521.57], [-12872.84], [-595.04]])
TABLE_2_2 = np.array(
    [
        [-1092.89, -77.13, 12866.30],
        [-252.76, 12942.89, -370.99],
        [334.90, -308.34, -13329.13],
        [-504.34, -13326.64, -88.55],
        [-1086.04, -82.90, 12867.33],
        [-13478.3, 152.03, -214.92],
        [333.63, -311.28, -13324.92],
        [12715.78, -548.21, -243.23],
    ]
)
K_2_2 = np.array(
    [
        [-1334.9887, -12.821846, -72.560802],
        [35.687929, -1338.834, 11.711567],
        [1.4428271, 14.394634, 1334.9765],
    ]
)
Q_2_2 = np.array(
    [
        [-0.00074893406, 6.7341434e-06, -4.0766354e-05],
        [-1.9954607e-05, -0.00074666871, 5.4658181e-06],
        [1.0246036e-06, 8.0438174e-06, 0.00074906201],
    ]
)


def run_of(plan: Plan, y: np.ndarray, axes: tuple[str, ...], se: np.ndarray | None = None) -> Run:
    n, c = y.shape
    steps = (plan.steps * (n // len(plan.steps) + 1))[:n]
    return plain_run(
        channels=tuple(f"U{i + 1}" for i in range(c)),
        axes=axes,
        y=y,
        y_se=np.full((n, c), np.nan) if se is None else se,
        run=np.arange(n) // len(plan.steps),
        mount=tuple(step.mount for step in steps),
        head_deg=np.array([step.head_deg for step in steps]),
    )


def naive_output(plan: Plan, k: np.ndarray, bias: np.ndarray) -> np.ndarray:
    """The practicum's Table 2.1 written out by hand, in no way through the model."""
    rows = []
    for step in plan.steps:
        s, c = np.sin(np.radians(step.head_deg)), np.cos(np.radians(step.head_deg))
        a = {"X_from": (0.0, -s, c), "Y_from": (s, 0.0, c)}[step.mount]
        rows.append(k @ (G * np.array(a)) + bias)
    return np.array(rows)


def test_table_2_2_gives_the_golden_matrices() -> None:
    calibration = calibrate(run_of(PLANS["pointer_8"], TABLE_2_2, ("x", "y", "z")), KYIV)
    triad = calibration.triad()
    np.testing.assert_allclose(triad.k, K_2_2, rtol=5e-8)
    np.testing.assert_allclose(triad.bias, [-378.7525, -194.9475, -229.76375], rtol=1e-9)
    np.testing.assert_allclose(triad.q, Q_2_2, rtol=5e-8)
    assert triad.determinant == pytest.approx(2.3866994e9, rel=1e-7)
    assert triad.condition == pytest.approx(1.0600012, rel=1e-7)
    sds = [np.sqrt(np.sum(fit.residuals**2) / 4) for fit in calibration.fits]
    np.testing.assert_allclose(sds, [3.2495327, 3.8601902, 1.6437106], rtol=1e-7)
    pure = [fit.lack_of_fit.pure_sd for fit in calibration.fits if fit.lack_of_fit]
    np.testing.assert_allclose(pure, [3.4833676, 3.2379199, 2.1670833], rtol=1e-7)
    np.testing.assert_allclose(triad.u_bias(), [1.1488833, 1.3647834, 0.58113944], rtol=1e-7)
    np.testing.assert_allclose(
        np.diag(triad.u_k()), [0.23421265, 0.27822628, 0.083772172], rtol=1e-7
    )
    np.testing.assert_allclose(triad.u_k()[:2, 2], [0.16561335, 0.19673569], rtol=1e-7)
    biases = [calibration.bias_in_input(c)[0] for c in range(3)]
    np.testing.assert_allclose(np.abs(biases), np.abs(triad.bias / np.diag(triad.k)), rtol=1e-12)
    assert {fit.sigma_source for fit in calibration.fits} == {"residual"}
    assert not any(fit.notes for fit in calibration.fits)
    assert [note.subject for note in calibration.notes] == ["negative_scale_factor"]


def test_table_2_2_decomposes() -> None:
    triad = calibrate(run_of(PLANS["pointer_8"], TABLE_2_2, ("x", "y", "z")), KYIV).triad()
    split = triad.decompose()
    np.testing.assert_allclose(split.sensitivity, [1337.0207, 1339.3608, 1335.0548], rtol=1e-7)
    np.testing.assert_allclose(split.skew_deg, [-1.0023523, -3.1786705, -0.11490015], rtol=1e-6)
    np.testing.assert_allclose(
        split.input_axes[0], [-0.99848022, -0.0095898636, -0.054270516], rtol=1e-6
    )


def test_table_1_2_gives_the_golden_numbers_and_says_that_they_contradict() -> None:
    calibration = calibrate(run_of(PLANS["accelerometer_4"], TABLE_1_2, ("",)), KYIV)
    (fit,) = calibration.fits
    assert calibration.axes == ("z",)
    assert fit.value("scale_factor") == pytest.approx(1328.0691, rel=1e-7)
    assert fit.value("cross_axis_y") == pytest.approx(-56.908344, rel=1e-7)
    assert fit.value("bias") == pytest.approx(59.79, rel=1e-9)
    np.testing.assert_allclose(fit.residuals, [96.525, -96.525, 96.525, -96.525], rtol=1e-9)
    assert fit.dof == 1
    assert calibration.bias_in_input(0)[0] == pytest.approx(0.045020247, rel=1e-7)
    assert calibration.misalignment(0)[0] == pytest.approx([-0.042850438], rel=1e-7)
    subjects = {note.subject: note.text for note in fit.notes}
    assert subjects.keys() == {"left_out", "bias_pairs_differ"}
    assert "k_zx" in subjects["left_out"]
    assert "193.05 code" in subjects["bias_pairs_differ"]
    assert "14.8 mg" in subjects["bias_pairs_differ"]


@pytest.mark.parametrize("place", range(12))
def test_one_injected_error_moves_only_its_parameter(place: int) -> None:
    plan = PLANS["accelerometer_8"]
    k, bias = np.diag([1300.0, -1310.0, 1320.0]), np.zeros(3)
    clean = calibrate(run_of(plan, naive_output(plan, k, bias), ("x", "y", "z")), KYIV).triad()
    if place < 9:
        k = k.copy()
        k[place // 3, place % 3] += 7.0
    else:
        bias[place - 9] += 50.0
    bent = calibrate(run_of(plan, naive_output(plan, k, bias), ("x", "y", "z")), KYIV).triad()
    moved = np.r_[(bent.k - clean.k).ravel(), bent.bias - clean.bias]
    expected = np.zeros(12)
    expected[place] = 7.0 if place < 9 else 50.0
    np.testing.assert_allclose(moved, expected, atol=1e-8)


def test_more_positions_and_free_angles_serve_as_well() -> None:
    plan = PLANS["clbacc_24"]
    k = K_2_2
    bias = np.array([10.0, -20.0, 30.0])
    triad = calibrate(run_of(plan, naive_output(plan, k, bias), ("x", "y", "z")), KYIV).triad()
    np.testing.assert_allclose(triad.k, k, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(triad.bias, bias, rtol=1e-9)


def test_a_tilter_is_taken_into_account() -> None:
    plan, bias, pitch = PLANS["pointer_8"], np.array([10.0, -20.0, 30.0]), np.radians(12.0)
    # A positive pitch lifts Y (2.8): worked by hand from Table 2.1.
    lifted = np.array(
        [
            [1.0, 0.0, 0.0],
            [0.0, np.cos(pitch), np.sin(pitch)],
            [0.0, -np.sin(pitch), np.cos(pitch)],
        ]
    )
    run = run_of(plan, naive_output(plan, K_2_2 @ lifted, bias), ("x", "y", "z"))
    triad = calibrate(run, STEADY, tilter_deg=(0.0, 12.0, 0.0)).triad()
    np.testing.assert_allclose(triad.k, K_2_2, atol=1e-8)
    np.testing.assert_allclose(triad.bias, bias, atol=1e-7)


def test_a_calibration_names_the_file_that_it_came_from() -> None:
    run = run_of(PLANS["pointer_8"], TABLE_2_2, ("x", "y", "z"))
    assert calibrate(run, KYIV).provenance.records == ()
    named = replace(run, meta={"source": "a.txt", "source_sha256": "ab12", "plan": "pointer_8"})
    provenance = calibrate(named, KYIV).provenance
    assert provenance.records == (("a.txt", "ab12"),)
    assert provenance.plan == "pointer_8"


def test_standard_errors_that_not_all_rows_have_are_said_to_be_unused() -> None:
    se = np.full(TABLE_2_2.shape, 2.0)
    se[3, 1] = np.nan
    fits = calibrate(run_of(PLANS["pointer_8"], TABLE_2_2, ("x", "y", "z"), se), STEADY).fits
    told = [[note.subject for note in fit.notes] for fit in fits]
    assert "standard_errors_unused" in told[1]
    assert "standard_errors_unused" not in told[0]
    assert fits[1].sigma_source == "residual"


def test_a_stated_head_does_not_move_the_pair_formulas() -> None:
    run = run_of(PLANS["pointer_8"], TABLE_2_2, ("x", "y", "z"))
    stated = replace(KYIV, head_u_arcsec=10.0)
    plain, with_head = calibrate(run, KYIV).triad(), calibrate(run, stated).triad()
    np.testing.assert_array_equal(with_head.k, plain.k)
    assert calibrate(run, stated).conditions.head_u_arcsec == 10.0


def test_permuted_channels_are_suspected() -> None:
    run = run_of(PLANS["pointer_8"], TABLE_2_2[:, [1, 0, 2]], ("x", "y", "z"))
    assert "wrong_axis" in {note.subject for note in calibrate(run, KYIV).notes}


def test_quiet_pairs_of_a_known_noise_are_not_accused() -> None:
    plan = PLANS["accelerometer_8"]
    y = naive_output(plan, K_2_2, np.zeros(3))
    y[[0, 2], 2] += 40.0
    quiet = calibrate(run_of(plan, y, ("x", "y", "z"), np.full(y.shape, 30.0)), STEADY)
    loud = calibrate(run_of(plan, y, ("x", "y", "z"), np.full(y.shape, 2.0)), STEADY)
    assert "bias_pairs_differ" not in {note.subject for note in quiet.fits[2].notes}
    assert {"bias_pairs_differ", "model_rejected"} <= {n.subject for n in loud.fits[2].notes}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"y": np.full((4, 1), np.nan)}, "row 1: the output is not a number"),
        ({"head_deg": np.array([0.0, np.nan, 180.0, 270.0])}, "row 2: the head angle is missing"),
        ({"mount": ("X_from", "X_from", "Q", "X_from")}, "row 3: unknown mount 'Q'"),
    ],
)
def test_bad_rows_are_named(change: dict[str, object], words: str) -> None:
    run = replace(run_of(PLANS["accelerometer_4"], TABLE_1_2, ("z",)), **change)
    with pytest.raises(FitError, match=words):
        calibrate(run, KYIV)


def test_gravity_is_never_assumed() -> None:
    run = run_of(PLANS["accelerometer_4"], TABLE_1_2, ("z",))
    with pytest.raises(FitError, match="local gravity is missing"):
        calibrate(run, Conditions())
    with pytest.raises(FitError, match="no rows"):
        calibrate(run.rows([]), KYIV)


def test_one_position_repeated_determines_nothing() -> None:
    run = run_of(PLANS["accelerometer_4"], TABLE_1_2, ("z",)).rows([0, 0, 0])
    with pytest.raises(FitError, match="k_z"):
        calibrate(run, KYIV)


def test_upside_down_fits_with_the_sign_that_it_has() -> None:
    plan = PLANS["accelerometer_8"]
    calibration = calibrate(
        run_of(
            plan, -naive_output(plan, np.diag([1.0e3, 1.1e3, 1.2e3]), np.zeros(3)), tuple("xyz")
        ),
        KYIV,
    )
    assert np.all(np.diag(calibration.triad().k) < 0)
    assert "negative_scale_factor" in {note.subject for note in calibration.notes}


def test_three_columns_on_one_axis_are_no_triad() -> None:
    run = run_of(PLANS["pointer_8"], TABLE_2_2, ("x", "z", "z"))
    calibration = calibrate(run, KYIV)
    assert not calibration.is_triad
    with pytest.raises(FitError, match="three sensors"):
        calibration.triad()


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["residual", "worn head", "known", "setting", "drifting"])
def test_intervals_cover_the_truth(mode: str) -> None:
    """1200 sessions of 8 positions, hidden truth, noise as stated."""
    rng = np.random.default_rng(77)
    plan = PLANS["accelerometer_8"]
    bias = np.array([-378.0, -195.0, 130.0])
    sigma, head_arcsec = 2.0, 60.0
    conditions = Conditions(
        g_mps2=G,
        head_u_arcsec=head_arcsec if mode in ("setting", "worn head") else np.nan,
        repeatability=np.nan if mode == "drifting" else 0.0,
    )
    hits = np.zeros((3, 4))
    trials = 1200
    for _ in range(trials):
        y = naive_output(plan, K_2_2, bias)
        if mode in ("setting", "worn head"):
            off = rng.normal(0.0, head_arcsec / 3600.0, len(plan.steps))
            steps = [
                replace(s, head_deg=s.head_deg + d) for s, d in zip(plan.steps, off, strict=True)
            ]
            y = naive_output(plan.with_steps(tuple(steps)), K_2_2, bias)
        y = y + rng.normal(0.0, sigma, y.shape)
        se = None if mode in ("residual", "worn head") else np.full(y.shape, sigma)
        if mode == "drifting":  # as much again from one accumulation to the next, not stated
            y = y + rng.normal(0.0, sigma, y.shape)
        calibration = calibrate(run_of(plan, y, ("x", "y", "z"), se), conditions)
        triad = calibration.triad()
        truth = np.column_stack([bias, K_2_2])
        estimate = np.column_stack([triad.bias, triad.k])
        u = np.column_stack([triad.u_bias(), triad.u_k()])
        factor = np.array([student_t(0.95, float(dof)) for dof in triad.t_dof])[:, None]
        hits += np.abs(estimate - truth) < factor * u
    coverage = hits / trials
    if mode == "worn head":
        # Four residuals cannot tell the noise from the settings: never too narrow, often too wide.
        assert np.all(coverage > 0.93), coverage
        return
    assert np.all((coverage > 0.93) & (coverage < 0.97)), coverage
    assert 0.94 < coverage.mean() < 0.96
