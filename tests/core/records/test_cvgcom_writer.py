import errno
import os
from pathlib import Path

import numpy as np
import pytest

from core.errors import StorageError
from core.records.cvgcom import CvgcomHead, channel_of, read_cvgcom
from core.records.cvgcom_writer import CvgcomWriter, FrameMean

HEAD = CvgcomHead(0.02, 0.024, (channel_of("GyroOut"), channel_of("Temperature")))


@pytest.mark.parametrize("frames", [1, 2, 4, 40])
@pytest.mark.parametrize("piece", [1, 3, 37, 400])
def test_means_do_not_depend_on_how_the_frames_came(frames, piece):
    data = np.random.default_rng(1).normal(size=(400, 2))
    index = np.arange(1000, 1400)
    mean = FrameMean(frames, 2)
    rows = [mean.feed(index[i : i + piece], data[i : i + piece]) for i in range(0, 400, piece)]
    wanted = data.reshape(-1, frames, 2).mean(axis=1)
    assert np.allclose(np.concatenate(rows), wanted, rtol=0, atol=1e-15)


def test_lost_frames_leave_their_time():
    index = np.array([0, 1, 2, 3, 5, 16, 17, 18, 19])
    mean = FrameMean(4, 1)
    rows = np.concatenate(
        [mean.feed(index[:5], index[:5, None] * 1.0), mean.feed(index[5:], index[5:, None] * 1.0)]
    )
    assert np.array_equal(rows[:, 0], [1.5, 5.0, np.nan, np.nan, 17.5], equal_nan=True)


def test_rows_come_back_from_the_file(tmp_path):
    path = tmp_path / "25-143.exp(001)_s_pr1.txt"
    writer = CvgcomWriter(path, HEAD, frames=4)
    writer.feed(np.arange(10), np.arange(20.0).reshape(10, 2))
    writer.close()
    writer.close()
    read = read_cvgcom(path)
    assert read.data.tolist() == [[3.0, 4.0], [11.0, 12.0]]
    assert b"\r\n3.000000000\t4.000000000\r\n" in path.read_bytes()
    with pytest.raises(StorageError, match="cannot be created"):
        CvgcomWriter(path, HEAD)


def test_a_full_disk_is_told():
    writer = CvgcomWriter.__new__(CvgcomWriter)
    writer.path = Path("/dev/full")
    writer._mean = FrameMean(1, 2)
    writer._fd = os.open("/dev/full", os.O_WRONLY)
    with pytest.raises(StorageError, match="No space left"):
        writer.feed(np.arange(1), np.zeros((1, 2)))
    os.close(writer._fd)


def test_a_file_that_could_not_be_begun_leaves_its_name_free(tmp_path, monkeypatch):
    def refuse(fd, data):
        raise OSError(errno.ENOSPC, "No space left on device")

    head = CvgcomHead(0.01, 0.024, (channel_of("GyroOut"),))
    with monkeypatch.context() as patch:
        patch.setattr(os, "write", refuse)
        with pytest.raises(StorageError, match="No space left"):
            CvgcomWriter(tmp_path / "a.txt", head)
    CvgcomWriter(tmp_path / "a.txt", head).close()
