"""The demonstrations of the Drift and the Thermal tab, in the real window."""

from pathlib import Path

import pytest

from gui.demonstration.playing import demonstrate


@pytest.mark.timeout(240)
def test_both_are_played(tmp_path: Path) -> None:
    outcome = demonstrate(tmp_path, ("drift", "thermal"), 1)
    assert [part.title for part in outcome.parts] == ["Drift", "Thermal"]
    assert sum(row.covered for row in outcome.parameters) >= 5
    names = {path.name for path in outcome.files}
    assert {"drift-all-dark.png", "drift-dragged-light.png", "thermal-tilt-light.png"} <= names
    assert {"simulated_gyro_drift.h", "simulated_triad_thermal.h"} <= names
    assert all(path.stat().st_size > 200 for path in outcome.files)
