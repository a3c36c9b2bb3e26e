import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.errors import FormatError
from core.procedures.rate_table import calibrate_rate_table
from core.records.cvgcom import channel_of
from core.records.means import mean_of, means_run, read_means, write_means

CHANNELS = (channel_of("GyroOut"), channel_of("Temperature"))
RATE = 100.0


def noise(seed, level=(0.0, 26.0), n=2000):
    values = np.random.default_rng(seed).normal(level, [1e-3, 1e-2], size=(n, 2))
    return frozen_int(np.arange(n)), frozen(values)


def test_a_mean_has_the_error_of_white_noise():
    one = mean_of("a.txt", CHANNELS, *noise(1, n=20_000), RATE)
    assert one.n == 20_000
    assert one.seconds == pytest.approx(200.0)
    assert one.se == pytest.approx([1e-3 / np.sqrt(20_000), 1e-2 / np.sqrt(20_000)], rel=0.1)
    assert abs(one.mean[0]) < 4 * one.se[0]


def test_an_interval_and_lost_rows_are_respected():
    index, data = noise(2)
    data = data.copy()
    data[500:510] = np.nan
    data[1000:, 0] += 5.0
    one = mean_of("a.txt", CHANNELS, index, frozen(data), RATE, (0.0, 10.0))
    assert (one.n, one.lost, one.record) == (990, 10, "a.txt[0..10]")
    assert abs(one.mean[0]) < 1e-3
    with pytest.raises(FormatError, match="no samples"):
        mean_of("a.txt", CHANNELS, index, frozen(data), RATE, (90.0, 99.0))


def test_means_dat_comes_back(tmp_path):
    means = [mean_of(f"25-143.exp(00{i})_d_pr1.txt", CHANNELS, *noise(i), RATE) for i in (1, 2)]
    path, table = write_means(means, tmp_path)
    again = read_means(path, ["GyroOut"])
    assert [one.record for one in again] == [one.record for one in means]
    assert [channel.name for channel in again[0].channels] == ["GyroOut", "2"]
    for one, other in zip(again, means, strict=True):
        assert np.abs(one.mean - other.mean).max() <= 5e-10
    assert table.read_text("utf-8").startswith("record,start_s,seconds,n,lost,GyroOut [V],se GyroO")


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("a.txt\t1.0\t2.0\r\nb.txt\t1.0\r\n", 2, "1 means"),
        ("a.txt\t1.0\tx\r\n", 1, "'x' is no number"),
        ("a.txt\r\n", 1, "no means"),
        ("\r\n", 0, "no means"),
    ],
)
def test_damaged_means_are_refused(tmp_path, text, line, words):
    path = tmp_path / "means.dat"
    path.write_text(text, encoding="utf-8", newline="")
    with pytest.raises(FormatError, match=words) as caught:
        read_means(path)
    assert caught.value.line == line


def test_blanks_and_decimal_commas_are_read(tmp_path):
    path = tmp_path / "means.dat"
    path.write_text("a.txt 1,5 -2\nb.txt 2,5 -3\n", encoding="utf-8")
    assert [one.mean.tolist() for one in read_means(path)] == [[1.5, -2.0], [2.5, -3.0]]


def test_means_give_the_scale_factor_of_the_table():
    rates = [-20.0, -10.0, 0.0, 10.0, 20.0]
    means = [
        mean_of(f"{i}", CHANNELS, *noise(i, (0.024 * rate + 0.001, 26.0)), RATE)
        for i, rate in enumerate(rates)
    ]
    run = means_run(means, "25-143", rates_dps=rates)
    assert run.axes == ("z",)
    assert run.temperature_c == pytest.approx([26.0] * 5, abs=0.01)
    line = calibrate_rate_table(run, run.conditions).sensors[0].line
    assert line.slope.value == pytest.approx(0.024, abs=5e-6)


def test_means_give_rows_of_the_head():
    means = [mean_of(f"{i}", CHANNELS, *noise(i), RATE) for i in range(2)]
    run = means_run(means, "25-143", positions=[("X_from", 0.0), ("X_from", 90.0)])
    assert run.test == "dividing_head"
    assert run.mount == ("X_from", "X_from")
    assert run.head_deg.tolist() == [0.0, 90.0]


def test_a_wrong_number_of_rates_is_refused():
    means = [mean_of("a", CHANNELS, *noise(1), RATE)]
    with pytest.raises(FormatError, match="1 records, 2 rates"):
        means_run(means, "x", rates_dps=[1.0, 2.0])
    with pytest.raises(FormatError, match="no output of a gyro"):
        means_run(
            [mean_of("a", CHANNELS[1:], noise(1)[0], noise(1)[1][:, 1:], RATE)],
            "x",
            rates_dps=[1.0],
        )
