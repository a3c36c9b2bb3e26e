"""Noise studies as files that other programs read."""

import csv
import io
import math
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat

from core.errors import FitError
from core.records.noise_exports import (
    NOISE_EXPORTS,
    coefficients_csv,
    curves_csv,
    export_noise,
    kalibr_yaml,
)
from core.records.noise_study import NoiseStudy, StudyRequest, study
from core.records.series import Series
from core.samples.block import Channel
from tests.core.records.noise_records import gyro_noise


def found(unit: str = "deg/s", seed: int = 1, rate: float = 20.0) -> NoiseStudy:
    values = gyro_noise(20_000, rate, (0.02, 0.0125, 3e-3), seed)
    channel = Channel("y", unit, "rate.z")
    series = Series(f"r{seed}", f"G{seed}", (channel,), (values,), 20_000, rate=rate)
    return study(series, StudyRequest())


def keys(text: str) -> dict[str, str]:
    lines = (line.partition("#")[0].partition(":") for line in text.splitlines())
    return {key.strip(): value.strip() for key, _, value in lines if key.strip()}


def test_kalibr_gets_two_sided_si_values() -> None:
    one = found()
    told = keys(kalibr_yaml([one]))
    n = one.published.row("random_walk").value
    k = one.published.row("rate_random_walk").value
    assert float(told["gyroscope_noise_density"]) == pytest.approx(math.radians(n), rel=1e-6)
    assert float(told["gyroscope_random_walk"]) == pytest.approx(math.radians(k), rel=1e-6)
    assert told["update_rate"] == "20"
    assert "accelerometer_noise_density" not in told


def test_kalibr_joins_both_sensors_and_their_axes() -> None:
    studies = [found(seed=1), found(seed=2), found("m/s^2", 3)]
    told = keys(kalibr_yaml(studies))
    squares = [one.published.row("random_walk").value ** 2 for one in studies[:2]]
    expected = math.radians(math.sqrt(sum(squares) / 2))
    assert float(told["gyroscope_noise_density"]) == pytest.approx(expected, rel=1e-6)
    assert "accelerometer_random_walk" in told


@pytest.mark.parametrize(
    ("studies", "words"),
    [([found("code")], "state the scale factor"), ([found(), found(rate=50.0)], "different rates")],
)
def test_kalibr_refuses_what_it_cannot_hold(studies: list[NoiseStudy], words: str) -> None:
    with pytest.raises(FitError, match=words):
        kalibr_yaml(studies)


def test_the_tables_come_back_from_csv() -> None:
    one = found()
    rows = list(csv.DictReader(io.StringIO(coefficients_csv([one]))))
    first = rows[0]
    assert float(first["value"]) == one.published.row("random_walk").value
    assert {row["method"] for row in rows} == {"likelihood", "least_squares", "graphical"}
    points = list(csv.DictReader(io.StringIO(curves_csv([one]))))
    np.testing.assert_array_equal(
        [float(p["deviation"]) for p in points], one.published.curve.deviation
    )


def test_matlab_reads_the_structures(tmp_path: Path) -> None:
    one = found()
    export_noise([one, found(seed=2)], "matlab", tmp_path / "n.mat")
    noise = loadmat(tmp_path / "n.mat", squeeze_me=True, struct_as_record=False)["noise"]
    assert [entry.device for entry in noise] == ["G1", "G2"]
    np.testing.assert_array_equal(noise[0].deviation, one.published.curve.deviation)
    assert noise[0].coefficient[0].symbol == "N"


def test_every_format_writes(tmp_path: Path) -> None:
    for key, one in NOISE_EXPORTS.items():
        export_noise([found()], key, tmp_path / f"x{one.suffix}")
        assert (tmp_path / f"x{one.suffix}").stat().st_size > 100
