"""``calrig allan`` as a user calls it."""

import json
from pathlib import Path

import numpy as np
import pytest

from gui.main import main
from tests.core.records.noise_records import gyro_noise

TRUTH = (0.02, 0.0125, 3e-4)


@pytest.fixture(scope="module")
def records(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """Two devices at 20 Hz for 50 minutes; the second drifts with its temperature."""
    folder = tmp_path_factory.mktemp("records")
    n = 60_000
    temperature = 25.0 + 4.0 * np.sin(np.arange(n) / n * 3.0)
    paths: list[str] = []
    for seed, slope in ((1, 0.0), (2, 0.05)):
        path = folder / f"unit{seed}.csv"
        rate = gyro_noise(n, 20.0, TRUTH, seed) + slope * temperature
        table = np.column_stack([np.arange(n) / 20.0, rate, temperature])
        np.savetxt(path, table, "%.9g", ",", header="t_s,rate_z_dps,temp_degC", comments="")
        paths.append(str(path))
    return paths


def test_coefficients_with_intervals_and_conventions(
    records: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "o.json"
    assert main(["allan", records[0], "--json", str(out)]) == 0
    text = capsys.readouterr().out
    for words in ("0.664 B", "deg/sqrt(h)", "deg/s/sqrt(Hz)", "one-sided", "two-sided"):
        assert words in text
    for method in ("likelihood", "least squares", "graphical"):
        assert method in text
    found = json.loads(out.read_text(encoding="utf-8"))["records"][0]
    published = {
        row["symbol"]: row for row in found["coefficients"] if row["method"] == "likelihood"
    }
    for symbol, true in zip("NBK", TRUTH, strict=True):
        assert published[symbol]["lower"] < true < published[symbol]["upper"]
    assert found["rate_hz"] == pytest.approx(20.0)
    assert len(found["curve"]["taus"]) == len(found["curve"]["edf"])


def test_what_is_not_detected_is_a_limit(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "white.txt"
    np.savetxt(path, np.random.default_rng(4).normal(size=20_000), "%.9g")
    assert main(["allan", str(path), "--rate", "100", "--unit", "deg/s"]) == 0
    line = next(x for x in capsys.readouterr().out.splitlines() if "bias instability" in x)
    assert "<" in line


def test_regression_shows_before_and_after(
    records: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["allan", records[1], "--regress", "temp"]) == 0
    text = capsys.readouterr().out
    assert text.index("Before the regression") < text.index("After it")
    assert "deg/s/degC" in text


def test_several_devices_are_compared(
    records: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    yaml = tmp_path / "imu.yaml"
    assert main(["allan", *records, "--export", "kalibr", str(yaml)]) == 0
    text = capsys.readouterr().out
    head = text[text.index("Comparison of the devices") :].splitlines()[1]
    assert "unit1 rate_z" in head
    assert "unit2 rate_z" in head
    assert "gyroscope_noise_density" in yaml.read_text(encoding="utf-8")


def test_increments_of_angle_have_quantisation(
    records: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["allan", records[0], "--angle-increments"]) == 0
    assert "quantisation" in capsys.readouterr().out


def test_where_no_noise_model_fits_the_curve_is_still_given(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "short.txt"
    np.savetxt(path, np.random.default_rng(4).normal(size=100), "%.9g")
    assert main(["allan", str(path), "--rate", "10", "--unit", "deg/s"]) == 0
    text = capsys.readouterr().out
    assert "error: only the curve is given: 100 samples" in text
    assert "tau, s" in text


@pytest.mark.parametrize(
    ("content", "extra", "words"),
    [
        ("1\n2\n3\n1\n2\n", ["--rate", "10"], "5 usable samples"),
        ("5\n" * 500, ["--rate", "10"], "stuck or not connected"),
        ("1\n2\n3\n" * 200, [], "state the samples per second"),
        ("words\n", [], "no row of numbers"),
        ("t,g\n" + "".join(f"{t},1\n" for t in (0, 1, 2, 2, 3, 4, 5, 6, 7, 8)), [], "not increase"),
    ],
)
def test_a_record_that_cannot_be_used_is_said_in_words(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    content: str,
    extra: list[str],
    words: str,
) -> None:
    path = tmp_path / "bad.csv"
    path.write_text(content, encoding="utf-8")
    assert main(["allan", str(path), *extra]) == 2
    said = capsys.readouterr().err
    assert words in said
    assert "Traceback" not in said


def test_another_deviation_beside(
    records: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, curves = tmp_path / "o.json", tmp_path / "c.csv"
    asked = ["allan", records[0], "--beside", "modified", "--export", "curves", str(curves)]
    assert main([*asked, "--json", str(out)]) == 0
    assert "Modified Allan deviation" in capsys.readouterr().out
    found = json.loads(out.read_text(encoding="utf-8"))["records"][0]
    assert found["curve_beside"]["mode"] == "modified"
    kinds = [line.rpartition(",")[2] for line in curves.read_text("utf-8").splitlines()[1:]]
    assert set(kinds) == {"allan", "modified"}
    assert kinds.count("modified") == len(found["curve_beside"]["taus"])
