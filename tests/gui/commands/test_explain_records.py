"""explain on long records, as a user calls it."""

import json
from pathlib import Path

import numpy as np

from core.records.run_file import write_run
from gui.commands.table import run_command
from tests.core.discrepancy.recorded import hour_run


def cvgcom(path: Path) -> Path:
    """A file of CVGCom whose output jumps."""
    run = hour_run(lambda hour: 4e-4 * (hour.t > 1500.0), seed=31)
    head = "FileVersion = 1\nSamplingTime[seconds] = 1\nScaleFactor = 1\nCanalCount = 2\n"
    rows = np.column_stack([run.y[:, 0], run.temperature_c])
    lines = ["\t".join(f"{value:1.9f}" for value in row) for row in rows]
    names = "CanalNames = GyroOut\tTemperature\n\n"
    path.write_text(head + names + "\n".join(lines), encoding="utf-8")
    return path


def test_a_run_file_of_a_record_is_explained(tmp_path: Path):
    path, out = tmp_path / "hour.run.csv", tmp_path / "out.json"
    write_run(hour_run(lambda hour: 4e-4 * (hour.t > 1500.0), seed=30), path)
    assert run_command("explain", [str(path), "--json", str(out)]) == 0
    document = json.loads(out.read_text("utf-8"))
    assert document["steps"][0]["effect"] == "bias_jump"


def test_a_file_of_cvgcom_is_explained_by_its_output(tmp_path: Path):
    path, out = cvgcom(tmp_path / "CVG.txt"), tmp_path / "out.json"
    arguments = [str(path), "--channel", "GyroOut", "--json", str(out)]
    assert run_command("explain", arguments) == 0
    document = json.loads(out.read_text("utf-8"))
    assert document["steps"][0]["effect"] == "bias_jump"


def test_an_output_that_is_not_there_is_an_error(tmp_path: Path):
    assert run_command("explain", [str(cvgcom(tmp_path / "CVG.txt")), "--channel", "w"]) == 2
