"""The parts Live and Allan of the demonstration: records of two gyros, compared."""

import json
from pathlib import Path

import pytest

import gui.live.demo as live_demo
from gui.main import main


@pytest.mark.slow
@pytest.mark.timeout(300)
def test_records_of_two_gyros_are_made_averaged_and_compared(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A quarter of the hour that the demonstration takes; test_one_hour.py has the whole."""
    monkeypatch.setattr(live_demo, "HOUR_S", 900.0)
    out, told = tmp_path / "demo", tmp_path / "o.json"
    parts = ["--part", "live", "--part", "allan"]
    assert main(["demo", *parts, "--out", str(out), "--json", str(told)]) == 0
    outcome = json.loads(told.read_text(encoding="utf-8"))
    live, allan = outcome["parts"]
    for part, symbol in ((live, "σ"), (allan, "N")):
        assert [row["symbol"] for row in part["parameters"]] == [symbol, symbol]
        for row in part["parameters"]:
            assert abs(row["estimate"] - row["truth"]) < 2.0 * row["expanded"]
    names = [Path(name).name for name in outcome["files"]]
    assert {"live-record-light.png", "live-means-dark.png", "allan-comparison-light.png"} <= {
        *names
    }
    assert [name for name in names if name.endswith(".calrec")] == [
        "25-143.exp(001)_s_pr1.calrec",
        "25-144.exp(001)_s_pr1.calrec",
    ]
    assert all(Path(name).stat().st_size for name in outcome["files"])
