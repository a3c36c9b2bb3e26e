"""The practicum's own tables: what the rows really tell, and what they cannot."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.discrepancy.ladder import explain
from core.discrepancy.result import Explanation
from core.records.open import read_any

DATA = Path(__file__).parents[2] / "data" / "legacy"
TABLE_1_2 = "OpticalDividingHead_202405131405.txt"
TABLE_2_2 = "OpticalDividingHead_202405140930.txt"
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


def test_table_1_2_cannot_tell():
    """Four positions of one sensor leave one degree of freedom."""
    assert story(TABLE_1_2).verdict == "not_enough_data"


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
