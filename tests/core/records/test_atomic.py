import errno
import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from core.errors import StorageError
from core.records.atomic import (
    append_durable,
    atomic_file,
    make_folder,
    write_bytes_atomic,
    write_text_atomic,
)


def test_a_file_is_replaced_whole(tmp_path):
    path = tmp_path / "a.txt"
    write_text_atomic(path, "one\r\n")
    write_text_atomic(path, "їєґ\n")
    assert path.read_bytes() == "їєґ\n".encode()
    assert list(tmp_path.iterdir()) == [path]


def test_a_file_in_pieces_is_there_whole_or_not_at_all(tmp_path):
    path = tmp_path / "a.csv"
    with atomic_file(path) as file:
        file.write(b"one")
        assert not path.exists()
        file.write(b"two")
    assert path.read_bytes() == b"onetwo"

    def broken_off() -> None:
        with atomic_file(path) as file:
            file.write(b"half")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        broken_off()
    assert path.read_bytes() == b"onetwo"
    assert list(tmp_path.iterdir()) == [path]


def test_a_folder_is_made_with_those_above_it(tmp_path):
    for _ in range(2):
        make_folder(tmp_path / "a" / "b")
    assert (tmp_path / "a" / "b").is_dir()
    (tmp_path / "file").touch()
    with pytest.raises(StorageError, match="cannot be made"):
        make_folder(tmp_path / "file" / "b")


def test_a_failed_write_leaves_the_old_file(tmp_path):
    folder = tmp_path / "folder"
    folder.mkdir()
    with pytest.raises(StorageError, match="untouched"):
        write_bytes_atomic(folder, b"x")  # a folder stands in the way of the name
    with pytest.raises(StorageError, match="choose another folder"):
        write_bytes_atomic(tmp_path / "none" / "a", b"x")
    assert list(tmp_path.iterdir()) == [folder]


LIMITED = """
import os, resource, sys
from pathlib import Path
from core.errors import StorageError
from core.records.atomic import append_durable, write_bytes_atomic
resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
folder = Path(sys.argv[1])
try:
    write_bytes_atomic(folder / "whole", b"new" * 1000)
except StorageError as error:
    assert "untouched" in str(error), error
else:
    raise SystemExit("the limit did not hold")
handle = os.open(folder / "growing", os.O_WRONLY | os.O_APPEND)
try:
    append_durable(handle, b"x" * 5000)
except OSError:
    append_durable(handle, b"short")
else:
    raise SystemExit("the limit did not hold")
"""


if sys.platform != "win32":  # Windows has no limit on the size of a file

    def test_a_full_disk_loses_nothing(tmp_path):
        (tmp_path / "whole").write_bytes(b"old")
        (tmp_path / "growing").write_bytes(b"first ")
        root = Path(__file__).parents[3]
        subprocess.run([sys.executable, "-c", LIMITED, str(tmp_path)], check=True, cwd=root)
        assert (tmp_path / "whole").read_bytes() == b"old"
        assert (tmp_path / "growing").read_bytes() == b"first short"
        assert sorted(path.name for path in tmp_path.iterdir()) == ["growing", "whole"]


def test_appending_goes_to_the_end(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"one ")
    handle = os.open(path, os.O_WRONLY | os.O_APPEND)
    append_durable(handle, b"two")
    os.close(handle)
    assert path.read_bytes() == b"one two"


@pytest.mark.skipif(os.name == "nt", reason="no folder is opened there")
@pytest.mark.parametrize(("number", "matters"), [(errno.EINVAL, False), (errno.EIO, True)])
def test_a_network_folder_that_knows_no_sync_of_names(tmp_path, monkeypatch, number, matters):
    real = os.fsync

    def fsync(handle: int) -> None:
        if stat.S_ISDIR(os.fstat(handle).st_mode):
            raise OSError(number, os.strerror(number))
        real(handle)

    monkeypatch.setattr(os, "fsync", fsync)
    if matters:
        with pytest.raises(StorageError, match="Input/output error"):
            write_text_atomic(tmp_path / "a", "x")
    else:
        write_text_atomic(tmp_path / "a", "x")
        assert (tmp_path / "a").read_text() == "x"
