import numpy as np
import pytest

from core.allan.noise import fit_noise
from core.errors import FitError

HOUR = 360_000
CASE_B = {"N": 0.0025, "B": 0.001, "K": 5e-5}
"""A MEMS gyro of 0.15 deg/sqrt(h) and 3.6 deg/h."""


def subjects(result):
    return [note.subject for note in result.notes]


def test_figure_6_3_with_every_method(noise):
    y = 1.0 + noise(np.random.default_rng(1), HOUR, 100.0, N=0.02, B=0.0125, K=3e-4)
    result = fit_noise(y, 100.0)
    assert [(row.term, row.method) for row in result.rows if row.method == "likelihood"] == [
        ("random_walk", "likelihood"),
        ("bias_instability", "likelihood"),
        ("rate_random_walk", "likelihood"),
        ("rate_ramp", "likelihood"),
    ]
    for method in ("likelihood", "least_squares"):
        assert result.row("random_walk", method).value == pytest.approx(0.02, rel=0.005)
        assert result.row("bias_instability", method).value == pytest.approx(0.0125, rel=0.1)
    assert result.row("random_walk", "graphical").value == pytest.approx(0.02, rel=0.06)
    assert result.model.random_walk == result.row("random_walk").value
    assert result.band == pytest.approx(50.0, rel=1e-4)
    assert result.shortest == 0.0
    assert result.notes == ()
    assert result.curve.n == HOUR
    # Composite degrees of freedom: no jumps where one type gives way to another.
    steps = np.diff(np.log(result.curve.edf * result.curve.m)[10:])
    assert np.abs(steps).max() < 0.15


def test_no_bias_instability_is_an_upper_limit_and_not_a_number(noise):
    y = noise(np.random.default_rng(0), 90_000, 25.0, N=0.0025, K=1e-4)
    row = fit_noise(y, 25.0).row("bias_instability")
    assert row.upper_limit
    assert row.lower == 0.0
    assert 2e-4 < row.upper < 1e-3


def test_a_filter_in_the_sensor_is_said_and_does_not_spoil_n(noise):
    from scipy.signal import butter, sosfilt

    y = noise(np.random.default_rng(2), HOUR, 100.0, **CASE_B)
    y = sosfilt(butter(2, 25.0, fs=100.0, output="sos"), y)
    result = fit_noise(y, 100.0)
    assert "band" in subjects(result)
    assert 2.0 < result.band < 13.0
    assert result.shortest == pytest.approx(2.0 / result.band)
    row = result.row("random_walk")
    assert row.value == pytest.approx(0.0025, abs=3.0 * row.u)
    assert result.row("random_walk", "least_squares").value == pytest.approx(0.0025, rel=0.02)


def test_a_stated_bandwidth_is_used(noise):
    y = noise(np.random.default_rng(2), 90_000, 25.0, **CASE_B)
    result = fit_noise(y, 25.0, bandwidth=10.0)
    assert result.band == pytest.approx(2.0, rel=0.1)


def test_a_ramp_is_reported_apart(noise):
    y = noise(np.random.default_rng(3), 90_000, 25.0, **CASE_B, R=-3e-5)
    result = fit_noise(y, 25.0)
    row = result.row("rate_ramp")
    assert row.value == pytest.approx(-3e-5, abs=3.0 * row.u)
    assert row.u < 4e-6
    assert "ramp" in subjects(result)
    assert result.model.rate_ramp == -row.value
    assert result.row("rate_random_walk").upper < 2e-4


def test_quantisation_is_asked_of_increments_only(noise):
    # The angle moves by about a step between samples; where it does not, steps are no noise.
    rate, lsb = 100.0, 2e-3
    angle = np.cumsum(noise(np.random.default_rng(4), 60_000, rate, N=0.02)) / rate
    output = np.diff(np.floor(angle / lsb) * lsb, prepend=0.0) * rate
    row = fit_noise(output, rate, output="increment").row("quantization")
    assert row.value == pytest.approx(lsb / np.sqrt(12.0), rel=0.03)
    assert row.unit == "deg"
    assert row.symbol == "Q"
    assert all(one.term != "quantization" for one in fit_noise(output, rate).rows)


def test_rounding_of_a_rate_output_is_white_noise_not_q(noise):
    y = noise(np.random.default_rng(5), 60_000, 100.0, N=0.0025)
    rounded = np.rint(y / 0.02) * 0.02
    expected = np.sqrt(0.0025**2 + 0.02**2 / 12.0 / 100.0)
    assert fit_noise(rounded, 100.0).row("random_walk").value == pytest.approx(expected, rel=0.02)
    # Offered the term by mistake, the fit finds none.
    assert fit_noise(rounded, 100.0, output="increment").row("quantization").upper_limit


def test_vibration_below_the_band_is_named(noise):
    y = noise(np.random.default_rng(6), 90_000, 25.0, **CASE_B)
    y += 0.002 * np.sin(2.0 * np.pi * 0.05 * np.arange(90_000) / 25.0)
    result = fit_noise(y, 25.0)
    (note,) = [one for one in result.notes if one.subject == "line"]
    assert "about 0.05" in note.text


def test_two_methods_that_disagree_are_said(noise):
    """A sensor that warms and cools again: a walk to one method, ramps to the other."""
    y = noise(np.random.default_rng(7), 30_000, 10.0, N=0.0025)
    y += 0.2 * np.abs(np.linspace(-1.0, 1.0, 30_000))
    result = fit_noise(y, 10.0)
    assert subjects(result) == ["line", "disagreement"]
    assert result.notes[1].text.startswith("K is 0.000")


def test_a_spectrum_of_another_shape_is_said(noise):
    y = noise(np.random.default_rng(7), 30_000, 10.0, N=0.0025)
    y[15_000:15_300] += 0.05
    assert subjects(fit_noise(y, 10.0)) == ["misfit"]


def test_gaps_leave_the_longest_stretch(noise):
    y = noise(np.random.default_rng(8), 30_000, 10.0, N=0.0025)
    y[5000] = np.nan
    result = fit_noise(y, 10.0)
    assert subjects(result) == ["gaps"]
    assert result.curve.n == 24_999
    with pytest.raises(FitError, match="gaps"):
        fit_noise(y, 10.0, gaps="refuse")
    with pytest.raises(ValueError, match="longest"):
        fit_noise(y, 10.0, gaps="stretches")


def test_a_short_record_is_refused_in_words():
    with pytest.raises(FitError, match=r"255 samples.*fewer than 256"):
        fit_noise(np.random.default_rng(0).normal(size=255), 100.0)


@pytest.mark.parametrize("seed", range(5))
def test_the_shortest_record_is_fitted_without_a_fault(seed):
    result = fit_noise(np.random.default_rng(seed).normal(size=256), 100.0)
    assert result.row("random_walk").value == pytest.approx(0.1, rel=0.2)
    for row in result.rows:
        assert np.isfinite([row.value, row.u, row.lower, row.upper]).all()


def test_codes_of_16_bits_are_taken_as_they_are(noise):
    codes = np.rint(12866.0 + 3.0 * np.random.default_rng(0).normal(size=20_000)).astype(np.int16)
    result = fit_noise(codes, 100.0, unit="code")
    row = result.row("random_walk")
    assert row.value == pytest.approx(np.sqrt((9.0 + 1.0 / 12.0) / 100.0), rel=0.02)
    assert row.unit == "code/sqrt(Hz)"


@pytest.mark.slow
def test_accuracy_and_coverage_on_hours_of_a_mems_gyro(noise):
    """25 records; the full table of cases is in the benchmark."""
    truth = {"random_walk": 0.0025, "bias_instability": 0.001, "rate_random_walk": 5e-5}
    values = {term: [] for term in truth}
    hits = dict.fromkeys(truth, 0)
    least = []
    for seed in range(25):
        result = fit_noise(noise(np.random.default_rng(seed), HOUR, 100.0, **CASE_B), 100.0)
        least.append(result.row("bias_instability", "least_squares").value)
        for term, true in truth.items():
            row = result.row(term)
            values[term].append(row.value / true - 1.0)
            hits[term] += row.lower <= true <= row.upper
    rmse = {term: np.sqrt(np.mean(np.square(one))) for term, one in values.items()}
    assert rmse["random_walk"] < 0.0016
    assert rmse["bias_instability"] < 0.075
    assert np.sqrt(np.mean((np.array(least) / 0.001 - 1.0) ** 2)) < 0.075
    assert abs(np.mean(values["bias_instability"])) < 0.025
    assert all(count >= 22 for count in hits.values())


@pytest.mark.slow
def test_upper_limits_hold_where_there_is_no_bias_instability(noise):
    """Case D: a limit is printed nearly always, and the false alarms are a few per cent."""
    limits = 0
    for seed in range(20):
        y = noise(np.random.default_rng(seed), 90_000, 25.0, N=0.0025, K=1e-4)
        row = fit_noise(y, 25.0).row("bias_instability")
        limits += row.upper_limit
        assert row.upper < 1.3e-3
    assert limits >= 18


@pytest.mark.slow
@pytest.mark.parametrize("spoiled", ["filter", "outliers", "warm-up"])
def test_b_survives_what_real_records_hold(noise, spoiled):
    from scipy.signal import butter, sosfilt

    t = np.arange(90_000) / 25.0
    values = []
    for seed in range(8):
        rng = np.random.default_rng(seed)
        y = noise(rng, 90_000, 25.0, **CASE_B)
        if spoiled == "filter":
            y = sosfilt(butter(2, 6.0, fs=25.0, output="sos"), y)
        elif spoiled == "outliers":
            y[rng.integers(0, 90_000, 20)] += 10.0 * 0.0125
        else:
            y += 0.01 * np.exp(-t / 600.0)
        values.append(fit_noise(y, 25.0).row("bias_instability").value / 0.001 - 1.0)
    assert np.sqrt(np.mean(np.square(values))) < 0.12
