import json
from fractions import Fraction
from pathlib import Path

import allantools
import numpy as np
import pytest

from core.allan import deviation
from core.allan.deviation import nonoverlapping, overlapping, variance_of_phase
from core.allan.taus import averaging_factors
from core.errors import FitError

DATA = Path(__file__).parents[2] / "data"
NBS14 = DATA / "allan_reference" / "nbs14"
PHASEDAT = DATA / "allan_reference" / "phasedat"
GOLDEN = json.loads((DATA / "golden.json").read_text(encoding="utf-8"))["allan"]


def expected(dataset, statistic):
    rows = [
        line.split(",")
        for line in (NBS14 / "nbs14_expected.csv").read_text(encoding="utf-8").splitlines()
        if line.startswith(f"{dataset},{statistic},")
    ]
    return np.array([int(row[2]) for row in rows]), [row[3] for row in rows]


def printed_as(values, texts):
    """Round to as many significant digits as were printed."""
    return [
        float(f"{value:.{len(text.lstrip('0.').replace('.', '')) - 1}e}") == float(text)
        for value, text in zip(values, texts, strict=True)
    ]


@pytest.mark.parametrize("dataset", ["nbs14_9point", "nbs14_1000point"])
def test_nist_sp1065_to_the_printed_digits(dataset):
    y = np.loadtxt(NBS14 / f"{dataset}_freq.csv")
    m, texts = expected(dataset, "adev")
    assert all(printed_as(nonoverlapping(y, m), texts))
    m, texts = expected(dataset, "oadev")
    assert all(printed_as(overlapping(y, 1.0, m=m).deviation, texts))


def test_nist_1000_points_to_twelve_digits():
    golden = GOLDEN["nist_sp1065_1000point"]
    y = np.loadtxt(NBS14 / "nbs14_1000point_freq.csv")
    curve = overlapping(y, 1.0, m=np.array([1, 10, 100]))
    np.testing.assert_allclose(curve.deviation, golden["oadev_12digits"], rtol=2e-12)
    octaves = golden["oadev_octave"]
    m = np.array([int(one) for one in octaves])
    printed = [f"{one:.7e}" for one in overlapping(y, 1.0, m=m).deviation]
    assert printed == [f"{one:.7e}" for one in octaves.values()]
    printed = [f"{one:.7e}" for one in nonoverlapping(y, m)]
    assert printed == [f"{one:.7e}" for one in golden["adev_octave"].values()]


def test_nbs_phase_points():
    phase = np.loadtxt(NBS14 / "nbs14_10point_phase.csv")
    _, texts = expected("nbs14_9point", "oadev")
    values = np.sqrt(variance_of_phase(phase, np.array([1, 2])))
    np.testing.assert_allclose(values, [float(text) for text in texts], rtol=1e-6)


@pytest.mark.parametrize("name", ["oadev", "oadev_octave"])
def test_stable32_overlapping_at_every_factor_it_printed(name):
    phase = np.loadtxt(PHASEDAT / "PHASE.DAT")
    table = np.loadtxt(PHASEDAT / f"phase_dat_{name}.txt")
    values = np.sqrt(variance_of_phase(phase, table[:, 0].astype(np.int64)))
    assert [f"{one:.4e}" for one in values] == [f"{one:.4e}" for one in table[:, 5]]


def test_stable32_nonoverlapping():
    y = np.diff(np.loadtxt(PHASEDAT / "PHASE.DAT"))
    table = np.loadtxt(PHASEDAT / "phase_dat_adev.txt")
    values = nonoverlapping(y, table[:, 0].astype(np.int64))
    assert [f"{one:.4e}" for one in values] == [f"{one:.4e}" for one in table[:, 5]]


@pytest.mark.parametrize("n", [9, 1000, 32767, 32768, 32769, 120_000])
@pytest.mark.parametrize("kind", [np.float64, np.float32, np.int16])
def test_equal_to_allantools(n, kind):
    y = (np.random.default_rng(n).normal(size=n) * 900.0).astype(kind)
    curve = overlapping(y, 50.0)
    _, peer, _, _ = allantools.oadev(
        y.astype(np.float64), rate=50.0, data_type="freq", taus=curve.taus
    )
    # It drops points of a single difference; there are none up to a third of the record.
    np.testing.assert_allclose(curve.deviation, peer, rtol=1e-12)


def test_a_memory_map_of_strided_columns_is_read_in_place(tmp_path):
    data = np.random.default_rng(0).normal(size=(5000, 3)).astype(np.float32)
    data.tofile(tmp_path / "record.bin")
    mapped = np.memmap(tmp_path / "record.bin", dtype=np.float32, mode="r", shape=(5000, 3))
    curve = overlapping(mapped[:, 1], 10.0)
    np.testing.assert_array_equal(
        curve.deviation, overlapping(data[:, 1].astype(np.float64), 10.0).deviation
    )


def exact_variance(codes, m):
    """The definition in whole numbers, without any rounding."""
    phase = [0]
    for code in codes.tolist():
        phase.append(phase[-1] + code)
    total = sum(
        (phase[k + 2 * m] - 2 * phase[k + m] + phase[k]) ** 2 for k in range(len(phase) - 2 * m)
    )
    return float(Fraction(total, 2 * m * m * (len(phase) - 2 * m)))


@pytest.mark.parametrize(
    ("offset", "spread"),
    [(0, 100), (13_000, 1), (2**23, 3), (2**31, 50), (2**40, 2**33), (-(2**44), 5)],
)
def test_codes_are_exact_whatever_their_offset(offset, spread):
    rng = np.random.default_rng(5)
    codes = offset + rng.integers(-spread, spread + 1, 6000)
    curve = overlapping(codes, 1.0, m=np.array([1, 7, 300, 2000]))
    for m, variance in zip(curve.m.tolist(), curve.variance, strict=True):
        assert variance == pytest.approx(exact_variance(codes, m), rel=1e-14)


def test_large_codes_take_the_whole_number_path(monkeypatch):
    """A ramp of 32-bit codes over a long record leaves float64 sums no exact digits."""
    monkeypatch.setattr(deviation, "EXACT_FLOAT", 1e6)
    codes = 2**31 + np.random.default_rng(5).integers(-900, 900, 6000)
    curve = overlapping(codes, 1.0, m=np.array([1, 30, 2000]))
    for m, variance in zip(curve.m.tolist(), curve.variance, strict=True):
        assert variance == pytest.approx(exact_variance(codes, m), rel=1e-14)


@pytest.mark.parametrize("mode", ["exact", "equivalent"])
def test_scaled_data_on_a_large_offset_keeps_ten_digits(mode):
    """Without the mean taken off first the error here is 1e-6 and more."""
    codes = np.random.default_rng(5).integers(-3, 4, 200_000)
    scale = 1.0 / 79.378668
    m = np.array([1, 8, 128, 2048, 16384])
    curve = overlapping((codes + 2**23) * scale, 1.0, m=m, mode=mode)
    reference = overlapping(codes, 1.0, m=m, mode=mode)
    # The products themselves are rounded to 1e-16 of the offset: 3e-10 of the spread.
    np.testing.assert_allclose(curve.deviation, reference.deviation * scale, rtol=1e-9)


def test_equivalent_mode_agrees_within_a_small_part_of_the_interval():
    y = np.random.default_rng(1).normal(size=100_000)
    curve = overlapping(y, 1.0, mode="equivalent")
    exact = overlapping(y, 1.0, m=curve.m)
    off = (curve.variance / exact.variance - 1.0) * np.sqrt(exact.edf / 2.0)
    assert np.sqrt(np.mean(off**2)) < 0.1
    np.testing.assert_allclose(curve.edf, exact.edf, rtol=0.02)
    assert curve.mode == "equivalent"


@pytest.mark.slow
def test_equivalent_mode_loses_less_than_two_per_cent_of_the_degrees_of_freedom():
    ratios = []
    for seed in range(200):
        y = np.random.default_rng(seed).normal(size=4000)
        curve = overlapping(y, 1.0, mode="equivalent", m=np.array([20, 40, 100, 250]))
        exact = overlapping(y, 1.0, m=curve.m)
        ratios.append(curve.variance / exact.variance - 1.0)
    lost = np.var(ratios, axis=0) * exact.edf / 2.0
    assert np.all(lost < 0.02)


class TestGaps:
    def test_pooled_stretches_equal_their_sums(self):
        y = np.random.default_rng(1).normal(size=9000)
        y[[3000, 3001, 7000]] = np.nan
        m = np.array([1, 10, 500, 1000])
        curve = overlapping(y, 1.0, m=m, gaps="stretches")
        top = np.zeros(4)
        pairs = np.zeros(4)
        for part in (y[:3000], y[3002:7000], y[7001:]):
            count = np.maximum(len(part) + 1 - 2 * m, 0)
            phase = np.concatenate(([0.0], np.cumsum(part)))
            fits = count > 0
            top[fits] += variance_of_phase(phase, m[fits]) * count[fits]
            pairs += count
        np.testing.assert_allclose(curve.variance, top / pairs, rtol=1e-10)
        assert curve.pairs.tolist() == pairs.tolist()
        assert curve.n == 8997
        assert [note.subject for note in curve.notes] == ["gaps"]
        other = overlapping(y, 1.0, m=m, gaps="stretches", mode="equivalent")
        np.testing.assert_allclose(other.deviation, curve.deviation, rtol=0.05)

    @pytest.mark.slow
    def test_intervals_of_pooled_stretches_cover(self, noise):
        """Degrees of freedom of pooled stretches are a lower bound, so 95 % cover no less."""
        m = np.array([1, 10, 50, 200])
        hits = np.zeros(4)
        for seed in range(300):
            y = noise(np.random.default_rng(seed), 5000, 1.0, N=1.0)
            y[np.random.default_rng(seed + 1000).integers(0, 5000, 5)] = np.nan
            curve = overlapping(y, 1.0, m=m, gaps="stretches", level=0.95)
            truth = 1.0 / np.sqrt(m)
            hits += (curve.lower <= truth) & (truth <= curve.upper)
        assert np.all(hits / 300 > 0.92)

    def test_the_longest_stretch_alone(self):
        y = np.random.default_rng(1).normal(size=5000)
        y[1000] = np.nan
        curve = overlapping(y, 1.0, gaps="longest")
        np.testing.assert_array_equal(
            curve.deviation, overlapping(y[1001:], 1.0, m=curve.m).deviation
        )
        assert curve.n == 3999


class TestRefusals:
    def test_tau_beyond_a_third(self):
        with pytest.raises(FitError, match=r"tau = 3.34 s needs 1002 samples.*there are 1000"):
            overlapping(np.random.default_rng(0).normal(size=1000), 100.0, m=np.array([1, 334]))

    def test_a_record_that_alternates_has_no_curve(self):
        with pytest.raises(FitError, match="tau = 2 s is zero"):
            overlapping(np.tile([0.0, 1.0], 500), 1.0, m=np.array([1, 2]))

    @pytest.mark.parametrize("rate", [0.0, -1.0, np.nan, np.inf])
    def test_no_rate(self, rate):
        with pytest.raises(ValueError, match="rate must be positive"):
            overlapping(np.arange(100.0), rate)


def test_a_ramp_has_the_deviation_of_6_4():
    curve = overlapping(0.25 * np.arange(10_000) / 50.0, 50.0)
    np.testing.assert_allclose(curve.deviation, 0.25 * curve.taus / np.sqrt(2.0), rtol=1e-6)


def test_result_is_read_only_and_complete():
    y = np.random.default_rng(0).normal(size=1000)
    curve = overlapping(y, 100.0)
    assert (curve.n, curve.rate, curve.mode, curve.notes) == (1000, 100.0, "exact", ())
    assert curve.duration == 10.0
    assert len(curve.taus) == len(averaging_factors(1000))
    for array in (curve.taus, curve.deviation, curve.m, curve.edf, curve.lower, curve.upper):
        assert not array.flags.writeable
