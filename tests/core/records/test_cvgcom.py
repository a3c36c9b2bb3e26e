import numpy as np
import pytest

from core.errors import FormatError
from core.records.cvgcom import CvgcomFile, CvgcomHead, channel_of, is_cvgcom, read_cvgcom
from core.records.cvgcom_writer import write_cvgcom

SEVEN = (
    "GyroOut Temperature AntiNodePeriod ExcitationDelay AntiNodeAmplitude ExcitationAmpl"
    " QuadratureAmpl"
)
HEAD = (
    "FileVersion\t\t= 1\r\nSamplingTime[seconds]\t\t= 0.010000000\r\n"
    f"ScaleFactor\t\t= 0.024000000\r\nCanalCount\t\t= 7\r\nCanalNames\t\t{SEVEN}\r\n"
)
# The practicum's fig. 5.5.
ROW = (
    "-0.020585243\t26.141712189\t23.733621597\t14.333653450\t1.899964690\t1.086271524\t0.071447477"
)
NAME = "25-143.exp(002)_d_pr1.txt"


def stored(tmp_path, text, name=NAME):
    path = tmp_path / name
    path.write_bytes(text.encode("utf-8"))
    return path


def test_a_file_as_cvgcom_writes_it(tmp_path):
    read = read_cvgcom(stored(tmp_path, f"{HEAD}\r\n{ROW}\r\n{ROW}"))
    assert read.head.rate == 100.0
    assert read.head.scale_factor == 0.024
    assert [c.unit for c in read.head.channels] == ["V", "degC", "us", "us", "V", "V", "V"]
    assert read.data.tolist() == [[float(cell) for cell in ROW.split()]] * 2
    assert read.notes == ()
    assert read.name is not None
    assert (read.name.device, read.name.experiment, read.name.static) == ("25-143", 2, False)
    assert is_cvgcom(read.path)


def test_unix_ends_decimal_commas_and_a_closing_line_end(tmp_path):
    text = f"{HEAD}\n{ROW}\n".replace("\r\n", "\n").replace(".", ",")
    read = read_cvgcom(stored(tmp_path, text, "other.txt"))
    assert read.data[0, 1] == 26.141712189
    assert read.name is None


@pytest.mark.parametrize("keep", range(len(ROW) - 1, 0, -1))
def test_a_torn_last_row_is_left_out_wherever_it_was_cut(tmp_path, keep):
    read = read_cvgcom(stored(tmp_path, f"{HEAD}\r\n{ROW}\r\n{ROW[:keep]}"))
    assert read.data.tolist() == [[float(cell) for cell in ROW.split()]]
    assert [note.subject for note in read.notes] == ["cut_row"]


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        (f"{HEAD}\r\n{ROW}\r\n1.0\t2.0\r\n{ROW}", 8, "2 values; the head names 7"),
        (f"{HEAD}\r\n{ROW.replace('26.1', '26.x')}\r\n{ROW}", 7, "is no number"),
        (HEAD.replace("= 7", "= 8") + "\r\n" + ROW, 5, "7 names, CanalCount is 8"),
        (HEAD.replace("0.010000000", "0.0") + "\r\n" + ROW, 2, "above zero"),
        (HEAD.replace("0.010000000", "soon") + "\r\n" + ROW, 2, "is no number"),
        (HEAD.replace("ScaleFactor", "Scale") + "\r\n" + ROW, 0, "no line ScaleFactor"),
        (HEAD, 0, "no rows"),
        ("Colibrys\t+27\t0\n", 0, "no line CanalNames"),
    ],
)
def test_damage_is_told_with_its_line(tmp_path, text, line, words):
    with pytest.raises(FormatError, match="25-143") as caught:
        read_cvgcom(stored(tmp_path, text))
    assert caught.value.line == line
    assert words in str(caught.value)


def test_what_is_written_comes_back(tmp_path):
    data = np.round(np.random.default_rng(3).normal(size=(2500, 2)), 9)
    data[7] = np.nan
    head = CvgcomHead(0.005, 0.024, (channel_of("GyroOut"), channel_of("Temperature")))
    path = tmp_path / NAME
    write_cvgcom(CvgcomFile(path, head, data, None, ()), path)
    again = read_cvgcom(path)
    assert again.head == head
    assert np.array_equal(again.data, data, equal_nan=True)


def test_other_files_are_not_taken_for_it(tmp_path):
    assert not is_cvgcom(stored(tmp_path, "Vector\t1\n"))
    assert not is_cvgcom(tmp_path / "nowhere.txt")
