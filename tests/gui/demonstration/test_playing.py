"""The whole way of a session through the real window, on the simulated rig."""

import json
from pathlib import Path

import pytest

from gui.main import main


@pytest.mark.timeout(240)
def test_the_window_measures_eight_positions_by_itself(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "demo"
    assert (
        main(["demo", "--part", "head", "--out", str(out), "--json", str(tmp_path / "o.json")]) == 0
    )
    outcome = json.loads((tmp_path / "o.json").read_text(encoding="utf-8"))
    (head,) = outcome["parts"]
    assert len(head["parameters"]) == 12
    # 95 % intervals: fewer than 9 of 12 is a chance of some 1e-4.
    assert sum(row["covered"] for row in head["parameters"]) >= 9
    names = {Path(name).name for name in outcome["files"]}
    assert {"dividing-head-measuring-dark.png", "dividing-head-results-light.png"} <= names
    assert all(Path(name).stat().st_size for name in outcome["files"])
    session = Path(head["session"])
    assert (session / "session.json").is_file()
    assert len((session / "positions.jsonl").read_text(encoding="utf-8").splitlines()) >= 8
    assert list(session.glob("OpticalDividingHead_*.txt"))
    told = capsys.readouterr().out.splitlines()
    assert "dividing-head-results-light.png" in told
    assert f"session: {session.relative_to(out)}" in told
    assert [line for line in told if str(out) in line] == [f"all in {out}"]
