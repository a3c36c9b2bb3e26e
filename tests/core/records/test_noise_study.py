"""A record analysed as the tab and the command do it."""

import sys

import numpy as np
import pytest

from core.errors import FitError
from core.records.noise_study import StudyRequest, study
from core.records.series import Series
from core.samples.block import Channel
from tests.core.records.noise_records import gyro_noise

TRUTH = (0.02, 0.0125, 3e-4)
CHANNELS = (Channel("rate", "deg/s", "rate.z"), Channel("temp", "degC", "temp"))


def record(n: int = 60_000, slope: float = 0.0) -> Series:
    temperature = 25.0 + 5.0 * np.sin(np.arange(n) / n * 3.0)
    values = gyro_noise(n, 20.0, TRUTH) + slope * temperature
    return Series("r.txt", "G1", CHANNELS, (values, temperature), n, rate=20.0)


def test_the_simulated_noise_comes_back_within_its_intervals() -> None:
    found = study(record(), StudyRequest())
    for term, true in zip(("random_walk", "bias_instability"), TRUTH, strict=False):
        row = found.published.row(term)
        assert row.lower < true < row.upper
    assert (found.channel, found.unit, found.samples) == ("rate", "deg/s", 60_000)
    assert found.previews[0].factor == 1.0


def test_regression_on_temperature_takes_its_effect_off() -> None:
    found = study(record(slope=0.05), StudyRequest(regressors=("temp",)))
    assert found.regression is not None
    assert found.regression.values[0] == pytest.approx(0.05, abs=4 * found.regression.u[0])
    before, after = found.coefficients.curve, found.published.curve
    assert after.deviation[-1] < 0.5 * before.deviation[-1]


@pytest.mark.parametrize(
    ("request_", "words"),
    [
        (StudyRequest(regressors=("rate",)), "regressed on itself"),
        (StudyRequest(channel="temp", regressors=("temp",)), "regressed on itself"),
    ],
)
def test_a_channel_does_not_explain_itself(request_: StudyRequest, words: str) -> None:
    with pytest.raises(FitError, match=words):
        study(record(4000), request_)


def test_a_scale_factor_makes_rates_of_volts() -> None:
    found = study(record(8000), StudyRequest(scale_factor=2.0))
    plain = study(record(8000), StudyRequest())
    ratio = plain.published.row("random_walk").value / found.published.row("random_walk").value
    assert ratio == pytest.approx(2.0, rel=1e-6)
    assert (found.unit, found.scale_factor) == ("deg/s", 2.0)


def test_another_deviation_stands_beside_and_is_of_what_the_regression_left() -> None:
    plain = study(record(8000, slope=0.5), StudyRequest(beside="hadamard")).beside
    assert plain is not None
    assert plain.mode == "hadamard"
    request_ = StudyRequest(beside="hadamard", regressors=("temp",))
    left = study(record(8000, slope=0.5), request_).beside
    assert left is not None
    assert left.deviation[-1] < 0.9 * plain.deviation[-1]


def test_without_its_library_the_other_deviation_is_a_note(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "allantools", None)
    found = study(record(4000), StudyRequest(beside="total"))
    assert found.beside is None
    assert "pip install" in next(note.text for note in found.notes if note.subject == "beside")
