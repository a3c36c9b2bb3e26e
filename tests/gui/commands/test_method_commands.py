"""tumble, six-position, thermal, drift, gyrocompass and predict, as a user calls them."""

import gzip
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from core.plans.plan import load_plans
from core.procedures.drift.simulated import turn_on
from core.procedures.fourier.readings import run_of_angles
from core.procedures.gyrocompass import run_of_headings
from core.records.run_file import write_run
from gui.main import main
from tests.plain_run import plain_run

G = 9.8106
RECORD = Path(__file__).parents[2] / "data" / "tofupilot_imu_thermal" / "imu_thermal.csv.gz"


def answer(arguments: list[str], out: Path) -> Any:
    assert main([*arguments, "--json", str(out)]) == 0
    return json.loads(out.read_text(encoding="utf-8"))


def tumble_file(path: Path, noise: float = 1e-5, flipped: bool = False) -> Path:
    head = np.arange(5.0, 401.0, 5.0)
    alpha = np.radians(head + 0.1121)
    rng = np.random.default_rng(3)
    u = 2.5 - 1.0 * np.sin(alpha) - 0.0098 * np.cos(alpha) + 0.001 * np.sin(alpha) * np.cos(alpha)
    readings = u[:, None] + noise * rng.standard_normal((80, 5))
    write_run(run_of_angles(head, readings, "V", flipped=flipped, device="DXL203"), path)
    return path


def positions(path: Path, temperatures: tuple[float, ...] = (27.0,), noise: float = 0.5) -> Path:
    """A triad with mounting, at each temperature of a cycle."""
    steps = load_plans()["thermal_8"].steps * len(temperatures)
    force = np.array([step.specific_force(G) for step in steps])
    t = np.repeat(temperatures, 8)
    k = np.diag([800.0, 810.0, 790.0]) + np.array([[0, 9, -4], [-8, 0, 3], [5, -2, 0]])
    y = force @ k.T + np.array([30.0, -20.0, 10.0]) + 0.5 * (t - 27.0)[:, None]
    y = y + noise * np.random.default_rng(4).standard_normal(y.shape)
    n = len(y)
    write_run(
        plain_run(
            channels=("X", "Y", "Z"),
            y=y,
            y_se=np.full_like(y, noise),
            run=np.arange(n) // 8 + 1,
            mount=tuple(step.mount for step in steps),
            head_deg=np.array([step.head_deg for step in steps]),
            temperature_c=t,
        ),
        path,
    )
    return path


def turn_on_files(folder: Path, count: int, seed: int = 0) -> list[str]:
    """One run file a temperature, its turn-ons by number."""
    rng = np.random.default_rng(seed)
    paths = []
    for ambient in (-20.0, 0.0, 20.0):
        made = [turn_on(rng, ambient, 0, rate=10.0) for _ in range(count)]
        y = np.concatenate([one for one, _ in made])
        n = len(y)
        path = folder / f"at_{ambient:g}_{seed}.run.csv"
        write_run(
            plain_run(
                test="record",
                sensor="gyro",
                device="GIB",
                channels=("x",),
                axes=("x",),
                unit="deg/s",
                y=y,
                run=np.repeat(np.arange(1, count + 1), n // count),
                temperature_c=np.concatenate([chip for _, chip in made]),
                t_s=np.tile((np.arange(n // count) + 0.5) / 10.0, count),
                extra={"ambient_c": np.full(n, ambient)},
            ),
            path,
        )
        paths.append(str(path))
    return paths


def test_tumble(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    path = tumble_file(tmp_path / "t.run.csv")
    arguments = ["tumble", str(path), "--g", "1", "--gravity-projection"]
    found = answer(arguments, tmp_path / "o.json")
    result = found["tumbles"][0]
    assert result["misalignment"]["value"] == pytest.approx(0.67358, abs=1e-3)
    assert found["split"]["separable"]
    assert found["split"]["k_xy"]["value"] == pytest.approx(0.001, rel=0.05)
    text = capsys.readouterr().out
    assert "    k_xy" in text
    assert "40 angles twice" in text
    assert "assumed" not in text


def test_tumble_says_when_nothing_can_be_split(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    path = tumble_file(tmp_path / "t.run.csv", 5e-3)
    assert main(["tumble", str(path), "--harmonics", "3"]) == 0
    text = capsys.readouterr().out
    assert "not separable" in text
    assert "    k_xy" not in text
    assert "sin 3a" in text
    assert main(["tumble", str(path), "--channel", "2"]) == 2
    assert "no output 2; there are: u" in capsys.readouterr().err


def test_tumble_of_two_mounts_tells_fixture_from_sensor(tmp_path: Path):
    path = tmp_path / "both.run.csv"
    tumble_file(path)
    lines = path.read_text("utf-8").splitlines()
    other = tumble_file(tmp_path / "f.run.csv", flipped=True).read_text("utf-8").splitlines()
    rows = [line for line in other if line[:1].isdigit()]
    path.write_text("\n".join([*lines, *rows]) + "\n", encoding="utf-8")
    found = answer(["tumble", str(path), "--g", "1", "--pairs"], tmp_path / "o.json")
    assert [one["sense"] for one in found["tumbles"]] == [1, -1]
    # The same readings in both mounts mean: all of it is the fixture.
    assert found["flip"]["fixture"]["value"] == pytest.approx(0.67358, abs=1e-3)
    assert found["flip"]["misalignment"]["value"] == pytest.approx(0.0, abs=1e-3)
    assert {pair["axis"] for pair in found["pairs"]} == {"x", "y"}


def test_six_position(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    path = positions(tmp_path / "p.run.csv")
    found = answer(["six-position", str(path), "--repeatability", "0"], tmp_path / "o.json")
    assert found["scale"][0]["value"] == pytest.approx(800.0, abs=0.5)
    assert found["K"][1][0] == pytest.approx(-8.0, abs=0.2)
    assert max(found["nine_parameters"]["residual_mg"]) > 10.0 * max(found["residual_mg"])
    assert "was assumed (Kyiv)" in capsys.readouterr().out


def test_thermal_cycle_with_a_check(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    cycle = positions(
        tmp_path / "c.run.csv", (27.0, -10.0, -40.0, -10.0, 27.0, 50.0, 70.0, 50.0, 27.0)
    )
    hot = positions(tmp_path / "h.run.csv", (65.0,))
    found = answer(["thermal", str(cycle), "--check", str(hot)], tmp_path / "o.json")
    x = found["thermal"]["channels"][0]
    assert (x["bias_order"], x["scale_order"]) == (1, 0)
    worst = {
        name: np.nanmax(np.abs(np.array(found["check"][name]["pitch_error_deg"], dtype=float)))
        for name in ("before", "after")
    }
    assert worst["before"] > 10.0 * worst["after"]
    text = capsys.readouterr().out
    assert "heating less cooling at 50 degC" in text
    assert main(["thermal", str(hot)]) == 2
    assert "all rows were measured at 65.0 degC" in capsys.readouterr().err


def test_thermal_record(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    path = tmp_path / "imu.csv"
    path.write_bytes(gzip.decompress(RECORD.read_bytes()))
    arguments = ["thermal", str(path), "--record", "--order", "3", "--channel", "rate_y"]
    found = answer(arguments, tmp_path / "o.json")
    assert found["trends"][0]["explained"] == pytest.approx(0.997, abs=1e-3)
    assert "R^2 = 0.997" in capsys.readouterr().out


def test_drift(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    files, unseen = turn_on_files(tmp_path, 5), turn_on_files(tmp_path, 2, seed=9)
    header = tmp_path / "gyro.h"
    arguments = ["drift", *files, "--knots", "10", "--c-header", str(header), "--unseen", *unseen]
    found = answer(arguments, tmp_path / "o.json")
    assert found["format"] == "calrig-drift"
    assert len(found["times_s"]) == 10
    left = {score["method"]: score["rms"] for score in found["methods"]}
    assert left["table"] < 0.5 * left["quartic"]
    assert found["unseen_rms"] < 0.5 * left["quartic"]
    assert "gyro_correction(uint32_t time" in header.read_text("utf-8")
    text = capsys.readouterr().out
    assert "quartic in time" in text
    assert "on 6 other turn-ons" in text


def test_drift_of_single_records(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    rng = np.random.default_rng(5)
    paths = []
    for number in range(4):
        y, chip = turn_on(rng, 20.0, 1, rate=10.0)
        path = tmp_path / f"on{number}.csv"
        t = np.arange(len(y)) / 10.0
        np.savetxt(
            path,
            np.column_stack([t, y, chip]),
            delimiter=",",
            header="t_s,gyro_x_dps,temp_degC",
            comments="",
        )
        paths.append(str(path))
    found = answer(["drift", *paths, *(["--ambient", "20"] * 4)], tmp_path / "o.json")
    assert found["unit"] == "deg/s"
    assert len(found["temperatures_c"]) == 1
    assert main(["drift", *paths, "--ambient", "20"]) == 2
    assert "1 temperatures for 4 files" in capsys.readouterr().err


def test_gyrocompass(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    headings = np.array([0.0, 90.0, 180.0, 270.0])
    level = 15.041067 * np.cos(np.radians(50.45))
    rates = level * np.cos(np.radians(headings + 33.0)) + 0.7
    path = tmp_path / "n.run.csv"
    write_run(run_of_headings(headings, rates, "deg/h", se=np.full(4, 0.02)), path)
    noise = ["--noise-n", "2e-5", "--latitude", "50.45", "--target", "0.1"]
    found = answer(["gyrocompass", str(path), *noise, "--repeatability", "0"], tmp_path / "o.json")
    assert found["gyrocompass"]["heading"]["value"] == pytest.approx(33.0, abs=1e-3)
    assert found["gyrocompass"]["drift"]["value"] == pytest.approx(0.7, abs=1e-3)
    assert found["advice"]["u_deg"] == pytest.approx(0.097, abs=0.01)
    assert "0.1 deg: 10 s are enough" in capsys.readouterr().out


def test_gyrocompass_asks_for_what_it_needs(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["gyrocompass"]) == 2
    assert "state the noise" in capsys.readouterr().err
    assert main(["gyrocompass", "--noise-n", "1e-5"]) == 2
    assert "state the latitude" in capsys.readouterr().err
    assert main(["gyrocompass", "--noise-n", "1e-5", "--latitude", "-90"]) == 2
    assert "finds no heading" in capsys.readouterr().err
    assert main(["gyrocompass", "--noise-n", "1", "--latitude", "0", "--target", "0.01"]) == 0
    assert "cannot be reached" in capsys.readouterr().out


def test_predict_compares_what_the_rig_allows(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    arguments = ["predict", "accelerometer", "--noise-n", "3e-3", "--want", "bias=3e-4"]
    found = answer([*arguments, "--tool", "dividing head"], tmp_path / "o.json")
    assert found["proposals"][0]["plan"] == "pointer_16"
    assert found["proposals"][0]["reaches"]
    assert {one["method"] for one in found["proposals"]} == {"positions"}
    text = capsys.readouterr().out
    assert "<- good enough" in text
    assert "needs g; four positions" in text
    assert main(["predict", "gyro", "--noise-n", "1e-3", "--tool", "climate chamber"]) == 1
    assert "Drift after switching on" in capsys.readouterr().out


def test_predict_shows_what_positions_are_worth(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    arguments = ["predict", "accelerometer", "--noise-n", "3e-3", "--plan", "accelerometer_8"]
    found = answer([*arguments, "--drop", "5", "7", "--add", "X_from:45"], tmp_path / "o.json")
    assert found["predictions"][0]["prediction"]["rows"] == 7
    assert "against the whole plan: U0 1." in capsys.readouterr().out
    table = ["predict", "gyro", "--noise-n", "1e-3", "--plan", "rate_table_cvg40"]
    assert main([*table, "--add", "Z_from:60", "--method", "rate_table"]) == 0
    assert "6 accumulations" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["accelerometer"], "state the white noise"),
        (["accelerometer", "--noise-n", "1", "--want", "bias"], "expected NAME=U"),
        (["accelerometer", "--noise-n", "1", "--plan", "none"], "there is no plan 'none'"),
        (["accelerometer", "--noise-n", "1", "--drop", "1"], "name the plan by --plan"),
        (["gyro", "--noise-n", "1", "--plan", "pointer_8"], "no method measures a gyro along z"),
        (
            ["gyro", "--noise-n", "1", "--plan", "rate_table_100", "--add", "up:1"],
            "expected MOUNT:NUMBER",
        ),
    ],
)
def test_predict_refuses_in_words(
    arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]
):
    assert main(["predict", *arguments]) == 2
    assert words in capsys.readouterr().err
