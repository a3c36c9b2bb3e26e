"""Full disks and read-only folders, each in a process of its own."""

import functools
import json
import os
import random
import shutil
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

from tests.reliability.fault import Found, Run
from tests.reliability.nursery import ROOT

WORDS = {
    "session": "positions are accepted",
    "record": "a record grows",
    "certificate": "certificates are issued",
    "file": "preferences are saved",
    "index": "the archive is indexed",
}


@functools.cache
def can_mount() -> bool:
    """Whether a small disk of its own can be made here without being root."""
    if shutil.which("unshare") is None:
        return False
    command = ["unshare", "-rm", "sh", "-c", "mount -t tmpfs none /mnt"]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def full(kind: str) -> Run:
    """A fault: the disk is full, and later there is room again."""

    def run(folder: Path, rng: random.Random, trials: int) -> Found:
        found = Found()
        for trial in range(trials):
            (answer,) = on_a_full_disk(folder / f"{trial}", rng.randrange(60_000), (kind,))
            found += answer
        return found

    return run


def read_only(kind: str) -> Run:
    """A fault: the folder may not be written to."""

    def run(folder: Path, _: random.Random, trials: int) -> Found:
        found = Found()
        for trial in range(trials):
            (answer,) = in_a_read_only_folder(folder / f"{trial}", (kind,))
            found += answer
        return found

    return run


def on_a_full_disk(folder: Path, room: int, kinds: Iterable[str]) -> list[Found]:
    """Work with so many bytes left on the disk."""
    return _process("tmpfs" if can_mount() else "limit", folder, room, kinds)


def in_a_read_only_folder(folder: Path, kinds: Iterable[str]) -> list[Found]:
    """Work where nothing may be written."""
    folder.mkdir()
    for path in (folder, *folder.parents):
        # Root becomes somebody else for this, who must get there.
        if os.geteuid() == 0 and path.stat().st_uid == 0:
            path.chmod(path.stat().st_mode | 0o055)
    return _process("read-only", folder, 0, kinds)


def _process(way: str, folder: Path, room: int, kinds: Iterable[str]) -> list[Found]:
    folder.mkdir(exist_ok=True)
    command = [sys.executable, "-m", "tests.reliability.small_disk", way, str(folder), str(room)]
    if way == "tmpfs":
        script = 'mount -t tmpfs -o size=3m none "$0" && exec "$@"'
        command = ["unshare", "-rm", "sh", "-c", script, str(folder), *command]
    done = subprocess.run(
        [*command, *kinds], cwd=ROOT, capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    answers = map(json.loads, done.stdout.splitlines())
    return [Found(1, answer["lost"], answer["message"]) for answer in answers]
