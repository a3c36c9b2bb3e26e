"""Records as text, as laboratories write them."""

from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError, FormatError
from core.records.series_text import parse_text_series, read_text_series

RNG = np.random.default_rng(3)
VALUES = RNG.normal(size=40)


def rows(*columns: np.ndarray, mark: str = ",", decimal: str = ".") -> str:
    lines = (mark.join(f"{cell:.9g}" for cell in row) for row in zip(*columns, strict=True))
    return "\n".join(lines).replace(".", decimal) + "\n"


@pytest.mark.parametrize(
    ("head", "mark", "decimal"),
    [
        ("t_s,rate_z_dps\n", ",", "."),
        ("Time (s);Gyro Z [deg/s]\n", ";", ","),
        ("# device = unit 7\n# t [s]\trate z (°/s)\n", "\t", "."),
        ("t rate_dps\n\n", " ", ","),
    ],
)
def test_every_spelling_of_a_table_is_the_same_record(head: str, mark: str, decimal: str) -> None:
    text = head + rows(np.arange(40) / 50.0, VALUES, mark=mark, decimal=decimal)
    series = parse_text_series(text, "x.csv")
    taken = series.sampled(series.main)
    assert taken.unit == "deg/s"
    assert taken.rate == pytest.approx(50.0)
    np.testing.assert_allclose(taken.values, VALUES, rtol=1e-8)
    assert taken.index is None


def test_milliseconds_are_seconds() -> None:
    series = parse_text_series("time_ms,g\n" + rows(np.arange(40) * 5.0, VALUES), "x")
    assert series.sampled(0).rate == pytest.approx(200.0)


def test_a_lost_row_is_a_gap_of_the_index() -> None:
    kept = np.delete(np.arange(40), [7, 8])
    series = parse_text_series("t,g\n" + rows(kept / 10.0, VALUES[kept]), "x")
    index = series.sampled(0).index
    assert index is not None
    assert index[-1] == 39


def test_a_nameless_first_column_that_counts_is_no_signal() -> None:
    series = parse_text_series(rows(np.arange(40.0), VALUES), "x.txt")
    assert len(series.columns) == 1
    with pytest.raises(FitError, match="state the samples per second"):
        series.sampled(0)
    assert series.sampled(0, rate=25.0).rate == 25.0


def test_a_nameless_first_column_that_increases_is_the_time_and_that_is_said() -> None:
    series = parse_text_series(rows(np.arange(40) * 0.02, VALUES), "x.txt")
    assert series.sampled(0).rate == pytest.approx(50.0)
    assert [note.subject for note in series.notes] == ["time"]


def test_the_head_tells_rate_unit_and_device() -> None:
    text = "# device = ADXRS 3\n# rate_hz = 100\n# unit = deg/s\n" + rows(VALUES)
    series = parse_text_series(text, "x.txt")
    assert (series.device, series.rate, series.channels[0].unit) == ("ADXRS 3", 100.0, "deg/s")


def test_an_empty_cell_is_a_lost_sample_and_a_cut_last_row_is_left_out() -> None:
    series = parse_text_series("t,g\n0,1\n1,\n2,3\n3", "x")
    np.testing.assert_array_equal(series.columns[0], [1.0, np.nan, 3.0])


@pytest.mark.parametrize(
    ("text", "line", "column"),
    [("t,g\n0,1\n1,x\n2,1\n", 3, 2), ("t,g\n\n0,1\n1,2,3\n2,1\n", 4, 0)],
)
def test_what_is_no_number_is_refused_with_its_place(text: str, line: int, column: int) -> None:
    with pytest.raises(FormatError) as caught:
        parse_text_series(text, "x")
    assert (caught.value.line, caught.value.column) == (line, column)


@pytest.mark.parametrize("text", ["", "nothing here\nbut words\n"])
def test_words_are_no_record(text: str) -> None:
    with pytest.raises(FormatError, match=r"is empty|no row of numbers"):
        parse_text_series(text, "x")


def test_a_run_file_of_a_record_is_read_and_one_of_positions_refused(tmp_path: Path) -> None:
    head = "# calrig_run = 1\n"
    path = tmp_path / "a.run.csv"
    table = "t_s,y,temperature_c\n" + rows(np.arange(40) / 20.0, VALUES, np.full(40, 25.0))
    told = '# test = "record"\n# sensor = "gyro"\n# device = "G1"\n# unit = "deg/s"\n'
    path.write_text(head + told + table, encoding="utf-8")
    series = read_text_series(path)
    assert series.sampled(series.main).rate == pytest.approx(20.0)
    assert series.channels[series.place("temp")].unit == "degC"


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_every_line_end_gives_all_rows(end: str):
    text = end.join(["# rate: 50 Hz", "note \x0c with a form feed", "1.5", "2.5", "3.5"])
    series = parse_text_series(text + end, "a.txt")
    assert series.columns[0].tolist() == [1.5, 2.5, 3.5]
