"""The parts Live and Allan of the demonstration: an hour of each of two gyros, compared."""

import json
from pathlib import Path

import pytest

from gui.main import main


@pytest.mark.slow
@pytest.mark.timeout(300)
def test_an_hour_of_two_gyros_is_recorded_averaged_and_compared(tmp_path: Path) -> None:
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
