"""The practicum's own tables: what the rows really tell, and what they cannot."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.discrepancy.ladder import explain
from core.discrepancy.result import Explanation
from core.records.open import read_any
from core.samples.run import Run

DATA = Path(__file__).parents[2] / "data" / "legacy"
TABLE_1_2 = "OpticalDividingHead_202405131405.txt"
TABLE_2_2 = "OpticalDividingHead_202405140930.txt"
TABLE_2_4 = "Accuracy_202405141110.txt"
TABLE_3_2 = "RotationTable_202405151000.txt"
TABLE_3_3 = "OpticalDividingHead_202405151045.txt"


def story(name: str, *, y_se: float = np.nan, **conditions: float) -> Explanation:
    run = read_any(DATA / name)
    conditions = {"g_mps2": 9.8106, **conditions}
    run = replace(run, conditions=replace(run.conditions, **conditions))
    return explain(replace(run, y_se=np.full(run.y.shape, y_se)))


def test_table_3_2_on_a_good_table_is_bent_and_eleven_rates_cannot_say_how():
    """1.32 codes rms from the line; 6.5 mdps of noise are 0.52 codes."""
    found = story(TABLE_3_2, y_se=0.52, rate_u_ppm=50.0)
    assert found.verdict == "ambiguous"
    step = found.steps[0]
    tied = {step.effect, *step.indistinguishable_from}
    assert {"scale_factor_asymmetry", "second_order_nonlinearity"} <= tied
    assert found.before.gap > 1.3
    assert found.next_measurements


def test_table_3_2_on_a_worn_table_is_adequate():
    found = story(TABLE_3_2, y_se=0.52, rate_u_ppm=500.0)
    assert found.verdict == "adequate"


def test_table_3_3_cannot_tell():
    assert story(TABLE_3_3).verdict == "not_enough_data"


def one_after_another(base: Run, later: Run, stated: float) -> Run:
    """The positions of an accuracy check (pitch 0, 30, 60 deg) behind those of a calibration."""
    old, new = len(base), len(later)

    def with_nan(column: np.ndarray) -> np.ndarray:
        return np.concatenate([column, np.full(new, np.nan)])

    return replace(
        base,
        y=np.vstack([base.y, later.y]),
        y_se=np.full((old + new, 3), stated),
        run=np.repeat([1, 2], [old, new]),
        order=np.arange(old + new),
        mount=(*base.mount, *("X_from",) * new),
        head_deg=np.concatenate([base.head_deg, [0.0, 330.0, 300.0]]),
        set_rate_dps=with_nan(base.set_rate_dps),
        temperature_c=with_nan(base.temperature_c),
        t_s=with_nan(base.t_s),
        conditions=replace(base.conditions, g_mps2=9.8106, head_u_arcsec=5.0),
        extra={},
    )


@pytest.mark.parametrize("y_se", [np.nan, 50e-6 * 9.8106 * 1335.0])
def test_table_1_2_disagrees_and_four_positions_cannot_say_why(y_se: float):
    """14.8 mg between the two pairs of positions, far beyond any noise; one degree of freedom."""
    found = story(TABLE_1_2, y_se=y_se)
    assert found.verdict == "ambiguous"
    (step,) = found.steps
    listed = {step.effect, *step.indistinguishable_from}
    assert {"second_order_nonlinearity", "scale_factor_asymmetry", "head_eccentricity"} <= listed
    assert {"bias_drift", "hysteresis", "settling_lag"} <= listed
    assert found.before.dof == 1
    assert found.next_measurements


def test_four_positions_that_agree_within_noise_are_not_enough():
    run = read_any(DATA / TABLE_1_2)
    kept = np.array(run.y)
    pairs = np.array([1.0, -1.0, 1.0, -1.0])[:, None]
    kept -= 0.9 * pairs * (pairs * kept).mean(axis=0)
    run = replace(run, y=kept, conditions=replace(run.conditions, g_mps2=9.8106))
    assert explain(run).verdict == "not_enough_data"


def test_table_2_4_does_not_follow_from_table_2_2():
    """Z lies 17 to 22 codes (1.3 to 1.7 mg) below what 2.2 predicts: another session."""
    base, later = read_any(DATA / TABLE_2_2), read_any(DATA / TABLE_2_4)
    found = explain(one_after_another(base, later, 50e-6 * 9.8106 * 1335.0))
    named = {n for s in found.steps for n in (s.effect, *s.indistinguishable_from)}
    assert {"run_bias", "bias_jump"} & named
    second = (found.channel == 2) & (np.arange(len(found.measured)) % 11 >= 8)
    off = (found.measured - found.predicted_before)[second]
    assert off.mean() < -8.0


def test_table_2_2_has_something_that_eight_positions_cannot_name():
    """50 ug, 3 and 5 arcsec, 30 ug: chi-square 65, 98 and 18 on four degrees of freedom each."""
    found = story(TABLE_2_2, y_se=50e-6 * 9.8106 * 1335.0, head_u_arcsec=5.0)
    assert found.before.dof == 12
    assert found.before.gap > 2.0
    assert found.verdict in ("ambiguous", "unexplained_structure")
    named = {n for s in found.steps for n in (s.effect, *s.indistinguishable_from)}
    assert {"remount_bias", "shaft_tilt"} & named


@pytest.mark.parametrize("name", [TABLE_2_2, TABLE_3_2])
def test_without_any_statement_of_noise_nothing_is_accused(name: str):
    found = story(name)
    assert found.verdict in ("adequate", "ambiguous")
    assert all(step.indistinguishable_from for step in found.steps)
