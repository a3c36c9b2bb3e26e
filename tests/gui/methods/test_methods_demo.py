"""The part of the tab Methods plays from the question to the evaluated turn."""

from pathlib import Path

import pytest

from core.plans.plan import load_plan
from gui.demonstration.playing import demonstrate


@pytest.mark.slow
def test_a_plan_is_chosen_thinned_out_measured_and_evaluated(tmp_path: Path):
    outcome = demonstrate(tmp_path, ("methods",), 1)
    (told,) = outcome.parts
    assert len(outcome.files) == 6
    plan = load_plan(tmp_path / "CalRig" / "plans" / "fourier_400_own1.toml")
    assert len(plan.steps) == 20
    assert told.session.name.endswith("fourier_400_own1")
