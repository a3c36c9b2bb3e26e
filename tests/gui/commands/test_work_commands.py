"""fit, export, convert, simulate, record and scan, as a user calls them."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from core.records.open import read_any
from gui.main import main

LEGACY = Path(__file__).parents[2] / "data" / "legacy"
TABLE_1_2 = LEGACY / "OpticalDividingHead_202405131405.txt"
TABLE_2_2 = LEGACY / "OpticalDividingHead_202405140930.txt"
TABLE_3_2 = LEGACY / "RotationTable_202405151000.txt"
TABLE_3_3 = LEGACY / "OpticalDividingHead_202405151045.txt"
TABLE_2_4 = LEGACY / "Accuracy_202405141110.txt"


def answer(arguments: list[str], out: Path) -> Any:
    assert main([*arguments, "--json", str(out)]) == 0
    return json.loads(out.read_text(encoding="utf-8"))


def test_fit_gives_the_practicums_tables(tmp_path: Path) -> None:
    found = answer(["fit", str(TABLE_2_2), str(TABLE_2_4)], tmp_path / "o.json")
    positions, accuracy = found["results"]
    triad = positions["calibration"]["triad"]
    np.testing.assert_allclose(triad["K"][0], [-1334.9887, -12.821846, -72.560802], rtol=5e-8)
    np.testing.assert_allclose(triad["U0"], [-378.7525, -194.9475, -229.76375], rtol=1e-9)
    np.testing.assert_allclose(positions["det_K"], 2386699400.0, rtol=1e-7)
    np.testing.assert_allclose(
        positions["bias_mps2"], [0.29171447, 0.15186321, -0.17406349], rtol=1e-7
    )
    np.testing.assert_allclose(
        accuracy["attitude"]["pitch"], [-0.011550499, 30.026704, 60.058997], rtol=1e-7
    )
    np.testing.assert_allclose(
        accuracy["attitude"]["roll"], [-0.0060860658, -0.019482743, -0.054146359], rtol=1e-7
    )
    np.testing.assert_allclose(accuracy["norm"], [9.7943233, 9.7979442, 9.8026881], atol=6e-8)


def test_fit_says_what_contradicts_and_what_was_assumed(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["fit", str(TABLE_1_2)]) == 0
    text = capsys.readouterr().out
    assert "1328.0691" in text
    assert "14.8 mg apart" in text
    assert "g = 9.8106 m/s^2 was assumed" in text
    assert main(["fit", str(TABLE_1_2), "--g", "9.81"]) == 0
    assert "assumed" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["fit", "nowhere.txt"], "nowhere.txt: cannot be read"),
        (["fit", str(TABLE_2_4)], "name a file of positions before it"),
        (["export", str(TABLE_2_2)], "state it by --g"),
        (["convert", str(TABLE_2_2), "x.dat"], "name a legacy layout"),
        (["simulate", "pointer", "s", "--plan", "none"], "there is no such plan"),
        (["simulate", "pointer", "s", "--effects", "ghost=1"], "no effect 'ghost'"),
        (["simulate", "cvg25", "s"], "--plan or --seconds"),
        (["simulate", "cvg25", "s", "--seconds", "0"], "longer than nothing"),
        (["record", "sim://cvg25", "--profile", "none"], "there is no such profile"),
    ],
)
def test_refusals_are_one_line_and_exit_code_2(
    arguments: list[str],
    words: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert words in line


def test_fit_gives_the_gyro_tables_and_refuses_to_mix_two_units(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = answer(["fit", str(TABLE_3_2), str(TABLE_3_3)], tmp_path / "o.json")
    text = capsys.readouterr().out
    rates, head = found["results"]
    (sensor,) = rates["rate_table"]["sensors"]
    np.testing.assert_allclose(sensor["line"]["fit"]["values"], [-438.08364, -79.378668], rtol=1e-7)
    assert rates["bias"]["gyro_1"]["value"] == pytest.approx(5.5189089, rel=1e-7)
    assert rates["residuals_dps"]["gyro_1"][0] == pytest.approx(0.02523577, rel=1e-6)
    assert "the straight line is rejected (p = 0.0011)" in text
    (gyro,) = head["g_sensitivity"]["sensors"]
    np.testing.assert_allclose(gyro["fit"]["values"], [-718.04, 1.167105, -0.0091737508], rtol=1e-6)
    assert "scale factor and zero of two units do not belong together" in text
    assert "measured" not in head["table_3_7"]["gyro_1"]
    forced = answer(["fit", str(TABLE_3_2), str(TABLE_3_3), "--same-unit"], tmp_path / "p.json")
    error = forced["results"][1]["table_3_7"]["gyro_1"]["error"]
    np.testing.assert_allclose(error[:3], [-3.5027444, -3.5141248, -3.5372212], atol=2e-3)
    assert head["joint"] is None
    (joint,) = forced["results"][1]["joint"]["sensors"]
    assert {"bias", "scale_factor"} <= {p["name"] for p in joint["fit"]["parameters"]}


def test_accuracy_stands_beside_the_units_own_and_judges(tmp_path: Path) -> None:
    arguments = ["accuracy", str(TABLE_2_4), "--calibration", str(TABLE_2_2)]
    found = answer([*arguments, "--limit", "0.1"], tmp_path / "o.json")
    traces = {trace["source"]: trace for trace in found["traces"]}
    np.testing.assert_allclose(
        traces["own"]["error"], [-0.011550499, 0.026703779, 0.058997], atol=6e-7
    )
    assert main([*arguments, "--limit", "0.05"]) == 1
    assert main([*arguments, "--limit", "0.1", "--angle", "0"]) == 2


def test_convert_there_and_back_loses_nothing_that_counts(tmp_path: Path) -> None:
    run, back = tmp_path / "a.run.csv", tmp_path / "back.txt"
    assert main(["convert", str(TABLE_2_2), str(run)]) == 0
    assert main(["convert", str(run), str(back), "--to", "pointer"]) == 0
    first = answer(["fit", str(TABLE_2_2)], tmp_path / "1.json")
    second = answer(["fit", str(back)], tmp_path / "2.json")
    triads = [item["results"][0]["calibration"]["triad"]["K"] for item in (first, second)]
    np.testing.assert_array_equal(*triads)


def test_a_simulated_session_is_measured_fitted_and_exported(tmp_path: Path) -> None:
    session = tmp_path / "session"
    found = answer(
        ["simulate", "pointer", str(session), "--accumulation", "2", "--head-u", "5"],
        tmp_path / "s.json",
    )
    assert len(found["parameters"]) == 12
    assert found["covered"] >= 9  # 12 intervals of 95 %: fewer happens once in some 1e4 sessions
    assert "truth" not in "".join(path.name for path in session.iterdir())
    written = answer(
        ["export", str(session), "--out", str(tmp_path), "--g", "9.8106"], tmp_path / "e.json"
    )
    assert all(Path(name).stat().st_size for name in written["written"])
    again = answer(
        ["export", written["written"][0], "--format", "c", "--out", str(tmp_path / "two")],
        tmp_path / "f.json",
    )
    assert Path(again["written"][0]).suffix == ".h"


def test_record_and_scan_find_the_simulated_device(tmp_path: Path) -> None:
    record = answer(
        [
            "record",
            "sim://cvg25?speed=20&name=cmd",
            "--seconds",
            "0.5",
            "--profile",
            "cvgx48",
            "--out",
            str(tmp_path / "r.calrec"),
        ],
        tmp_path / "r.json",
    )
    # How many come in half a second depends on how busy the machine is.
    assert record["counters"]["frames"] > 100
    assert record["counters"]["bad_checksum"] == 0
    found = answer(
        ["scan", "sim://pointer?speed=20&name=cmd", "--listen", "0.3"], tmp_path / "s.json"
    )
    assert found["found"][0]["profile"] == "pw09_raw"


def test_rates_and_records_are_simulated_too(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table, still = tmp_path / "table", tmp_path / "still"
    arguments = ["clbdus", str(table), "--accumulation", "0.5", "--rate-u-ppm", "100"]
    assert main(["simulate", *arguments]) == 0
    assert "9 of 9 intervals" in capsys.readouterr().out
    assert read_any(table).test == "rate_table"
    effects = ["--effects", "bias_temperature=0.02"]
    assert main(["simulate", "cvg25", str(still), "--seconds", "20", *effects]) == 0
    assert (still / "raw.calrec").stat().st_size > 10000
    assert main(["simulate", "cvg25", str(still), "--seconds", "20"]) == 2
    assert "already holds a recording" in capsys.readouterr().err
