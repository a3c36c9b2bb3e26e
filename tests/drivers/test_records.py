import numpy as np
import pytest

from core.arrays import frozen
from core.errors import FormatError
from core.records.cvgcom import CvgcomFile, CvgcomHead, channel_of
from core.records.cvgcom_writer import write_cvgcom
from drivers.recording import Gap
from drivers.records import open_record, record_means, records_in, was_ended
from tests.drivers.test_recorder import block, recorder

CHANNELS = (channel_of("GyroOut"), channel_of("Temperature"))


def text_file(path):
    data = np.arange(40.0).reshape(20, 2)
    data[5:8] = np.nan
    write_cvgcom(CvgcomFile(path, CvgcomHead(0.01, 0.024, CHANNELS), frozen(data), None, ()), path)
    return path


def test_a_text_file_opens_as_a_record_with_its_gaps(tmp_path):
    record = open_record(text_file(tmp_path / "25-143.exp(001)_s_pr1.txt"))
    assert record.gaps == (Gap(5, 3),)
    assert record.device == "25-143"
    assert len(record) == 17
    assert record.column(0)[5] == 16.0
    (mean,) = record_means(record)
    assert (mean.n, mean.lost) == (17, 3)


def test_the_order_is_that_of_the_experiments_and_twins_count_once(tmp_path):
    for number in (10, 2):
        text_file(tmp_path / f"25-143.exp({number:03d})_s_pr1.txt")
    writer = recorder(tmp_path / "25-143.exp(002)_s_pr1.calrec")
    writer.say(block(0, 10))
    writer.close()
    (tmp_path / "notes.txt").write_text("nothing", encoding="utf-8")
    assert [path.name for path in records_in(tmp_path)] == [
        "25-143.exp(002)_s_pr1.calrec",
        "25-143.exp(010)_s_pr1.txt",
    ]


def test_a_folder_without_records_is_refused(tmp_path):
    with pytest.raises(FormatError, match="no records"):
        records_in(tmp_path)
    with pytest.raises(FormatError, match="cannot be read"):
        records_in(tmp_path / "nowhere")


def test_a_record_that_was_cut_off_was_not_ended(tmp_path):
    path = tmp_path / "a.calrec"
    writer = recorder(path)
    writer.say(block(0, 10))
    assert writer.flush()
    assert not was_ended(path)
    writer.close()
    assert was_ended(path)
    path.write_bytes(path.read_bytes()[:-3])
    assert not was_ended(path)
    (tmp_path / "b.calrec").write_bytes(b"x")
    with pytest.raises(FormatError):
        was_ended(tmp_path / "b.calrec")
