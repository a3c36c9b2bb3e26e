import subprocess
import sys
from pathlib import Path

import pytest

from core.errors import StorageError
from core.records.session.lock import SessionLock

HOLDER = """
import sys, time
from pathlib import Path
from core.records.session.lock import SessionLock
lock = SessionLock(Path(sys.argv[1]))
print("held", flush=True)
time.sleep(60)
"""


def test_a_lock_is_held_by_one(tmp_path):
    path = tmp_path / "lock"
    lock = SessionLock(path)
    with pytest.raises(StorageError, match=r"another program is measuring .* continue there"):
        SessionLock(path)
    lock.release()
    lock.release()
    SessionLock(path).release()


def test_the_lock_of_a_killed_program_is_free(tmp_path):
    path = tmp_path / "lock"
    holder = subprocess.Popen(
        [sys.executable, "-c", HOLDER, str(path)],
        cwd=Path(__file__).parents[4],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert holder.stdout is not None
    with holder.stdout as output:
        assert output.readline() == "held\n"
        with pytest.raises(StorageError, match=f"process {holder.pid} on "):
            SessionLock(path)
        holder.kill()
        holder.wait()
    SessionLock(path).release()


def test_a_folder_that_cannot_be_written(tmp_path):
    with pytest.raises(StorageError, match="untouched"):
        SessionLock(tmp_path / "none" / "lock")
