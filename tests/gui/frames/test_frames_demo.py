"""The demonstration teaches a board and finds every number where it stands."""

from pathlib import Path

from drivers.profile import load_profile
from gui.demonstration import demonstrate


def test_the_demonstration_finds_all_that_it_hid(tmp_path: Path):
    outcome = demonstrate(tmp_path, ("gui.frames.demo",), 1)
    assert [row.symbol for row in outcome.parameters if not row.covered] == []
    assert len(outcome.parameters) == 5
    names = [path.name for path in outcome.files]
    assert names[:2] == ["teach-found-dark.png", "teach-found-light.png"]
    profile = load_profile(outcome.files[-1])
    assert (profile.name, profile.nominal_hz) == ("Invented board", 200.0)
