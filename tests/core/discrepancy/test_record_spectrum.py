"""Lines and noise terms at the full rate."""

from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.record_problem import Samples
from core.discrepancy.record_spectrum import lines_of, noise_terms
from tests.core.discrepancy.recorded import WHITE, hour_run, wander


def test_a_line_is_found_with_its_frequency_and_amplitude_and_taken_off():
    run = hour_run(lambda hour: 1.2e-4 * np.sin(2.0 * np.pi * 0.1234 * hour.t + 0.4), seed=1)
    lines, rest, seen = lines_of(Samples.of(run), 0.005)
    assert seen is not None
    (line,) = lines
    assert line.frequency == pytest.approx(0.1234, abs=2e-5)
    assert abs(line.amplitude - 1.2e-4) < 3.0 * line.u
    assert np.degrees(np.arctan2(line.cosine, line.sine)) == pytest.approx(np.degrees(0.4), abs=10)
    assert lines_of(rest, 0.005)[0] == ()
    assert float(seen.highest.max()) > 15.0


@pytest.mark.parametrize("walk", [0.0, 0.1])
def test_noise_alone_gives_lines_as_often_as_is_allowed(walk: float):
    """A level from few ordinates, or one that ends flat in a walk, makes lines of noise."""

    def walked(hour) -> np.ndarray:
        return walk * WHITE * np.cumsum(hour.rng.standard_normal(len(hour.t)))

    given = [len(lines_of(Samples.of(hour_run(walked, seed=s)), 0.05)[0]) for s in range(150)]
    assert sum(given) <= 12  # 5 % are meant; more than 12 in 150 happen once in 25


@pytest.mark.parametrize("seed", range(3))
def test_each_term_of_the_noise_is_named(seed: int):
    n = 3600

    def walk(hour) -> np.ndarray:
        return 0.08 * WHITE * np.cumsum(hour.rng.standard_normal(n))

    def markov(hour) -> np.ndarray:
        return wander(n, 1.5 * WHITE, 45.0, hour.rng)

    def flicker(hour) -> np.ndarray:
        waves = np.fft.rfft(hour.rng.standard_normal(n))
        f = np.fft.rfftfreq(n)
        f[0] = np.inf
        return np.fft.irfft(waves * np.sqrt(0.8**2 * WHITE**2 / (2.0 * np.pi * f)), n)

    def rounded(hour) -> np.ndarray:
        return 2.0 * WHITE * np.diff(hour.rng.standard_normal(n + 1))

    for hidden, name in (
        (walk, "rate_random_walk"),
        (markov, "markov"),
        (flicker, "bias_instability"),
        (rounded, "quantization"),
    ):
        terms, white = noise_terms(Samples.of(hour_run(hidden, seed=seed)), "V")
        assert name in {name for term in terms for name in (term.effect, *term.rivals)}
        assert len(white) == 1
        own = next((term for term in terms if term.effect == name), None)
        if name == "rate_random_walk" and own is not None:
            assert own.value == pytest.approx(0.08 * WHITE, rel=0.25)
        if name == "markov" and own is not None:
            assert own.memory == pytest.approx(45.0, rel=0.5)
            assert own.value == pytest.approx(1.5 * WHITE, rel=0.25)


def test_white_noise_has_its_coefficient_and_no_further_term():
    given = [noise_terms(Samples.of(hour_run(seed=s, drift=0.0)), "V") for s in range(20)]
    assert sum(bool(terms) for terms, _ in given) <= 3
    for _, white in given:
        (value,) = white.values()
        assert value == pytest.approx(WHITE, rel=0.06)


def test_a_short_record_has_no_spectrum_to_look_at():
    run = hour_run(seed=2).rows(range(150))
    lines, same, seen = lines_of(replace(Samples.of(run)), 0.005)
    assert lines == ()
    assert seen is None
    assert np.array_equal(same.y, run.y[:, 0])
