"""kill -9 at random moments, a file cut off anywhere, two programs in one folder."""

import random
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.archive.store import Archive
from core.certificates.register import Register
from core.records.session.record import JOURNAL_NAME, START_NAME, read_session
from core.records.session.store import Session
from drivers.framing import Damage, read_blocks
from drivers.rawlog import Chunk, read_rawlog
from drivers.recording import read_recording
from tests.reliability import seeds
from tests.reliability.fault import Found, Run
from tests.reliability.nursery import Victim, nursery
from tests.reliability.victims import YEAR, promised

_MOST_S = 0.12

Check = Callable[[Path, list[str]], Found]
"""Looks at a folder after a victim of it, with what that had been promised."""


def kills(victim: str, check: Check) -> Run:
    """A fault: one victim after the other is killed in the same folder."""

    def run(folder: Path, rng: random.Random, trials: int) -> Found:
        found = Found()
        promises = folder / "promises.txt"
        for trial in range(trials):
            place = folder / ("all" if victim in _GO_ON else f"{trial}")
            place.mkdir(exist_ok=True)
            _furnish(victim, place)
            before = len(promised(promises))
            started = nursery().start(victim, place, promises)
            started.wait_for(before + 1)
            told = started.kill(rng, _MOST_S)
            found += check(place, told if victim in _GO_ON else told[before:])
        return found

    return run


_GO_ON = ("measure", "overwrite", "index")
"""Victims that go on where the one before them was killed."""


def _furnish(victim: str, folder: Path) -> None:
    if victim == "index" and not (folder / "0.cal.json").exists():
        for number in range(12):
            (folder / f"{number}.cal.json").write_bytes(seeds.calibration() + b"\n" * number)


def session_kept(folder: Path, told: list[str]) -> Found:
    """Every promised position stands in the journal with its mean, once."""
    record = read_session(folder)
    stored = {p.id: repr(float(p.accumulation.mean[0])) for p in record.positions}
    wanted = dict(line.split() for line in told)
    lost = sum(stored.get(int(number)) != mean for number, mean in wanted.items())
    ids = [event.id for event in record.events]
    doubled = len(ids) - len(set(ids))
    notes = [note.text.partition(": ")[2] for note in record.notes if note.subject == "torn_line"]
    others = sum(note.subject != "torn_line" for note in record.notes)
    with Session.open(folder) as again:
        assert again.legacy_error is None
        assert again.legacy_path is not None
        rows = len(again.legacy_path.read_text("utf-8").splitlines())
        lost += abs(rows - len(again.positions))
    return Found(1, lost + doubled + others, notes[0] if notes else "the session is continued")


def record_kept(folder: Path, told: list[str]) -> Found:
    """Every promised sample is in the record, and nothing that was not sent."""
    path = folder / "a.calrec"
    record = read_recording(path)
    index, data = record.samples()
    missing = max(0, int(told[-1]) - len(index))
    wrong = int(np.sum(index != np.arange(len(index)))) + int(np.sum(data[:, 0] != index / 3.0))
    raw = b"".join(part.data for part in read_rawlog(path) if isinstance(part, Chunk))
    numbers = np.frombuffer(raw[: len(raw) // 8 * 8], dtype="<i8")
    missing += max(0, int(told[-1]) - len(numbers)) + int(
        np.sum(numbers != np.arange(len(numbers)))
    )
    assert not record.ended
    texts = [note.text for note in record.notes]
    return Found(1, missing + wrong, texts[0] if texts else "opened as not ended in order")


def certificates_kept(folder: Path, told: list[str]) -> Found:
    """Every number that was given has a whole twin and is not given again."""
    register = Register(folder)
    found = [register.read(path) for path in sorted(folder.glob("certificate_*.json"))]
    numbers = [one.number for one in found]
    lost = len(set(told) - set(numbers)) + len(told) - len(set(told))
    following, _ = register.issue(
        found[0].laboratory, YEAR, lambda number: replace(found[0], number=number)
    )
    # A twin that nobody was told of any more is whole, and its number is taken.
    lost += int(following.number in numbers) + int(len(numbers) > len(told) + 2)
    return Found(1, lost, "the next certificate gets the next number")


def overwritten_whole(folder: Path, told: list[str]) -> Found:
    """The file is one of those that were saved, whole, and no older than promised."""
    lines = (folder / "a.cal.json").read_text("utf-8").splitlines()
    whole = len(lines) == int(lines[0]) and set(lines) == {lines[0]}
    newest = int(told[-1])
    late = int(lines[0]) not in (newest, newest + 1)
    return Found(1, int(not whole) + int(late), "the file before or the file after, whole")


def whole_at_all(folder: Path, _: list[str]) -> Found:
    """The file is one of those that were saved, whole."""
    lines = (folder / "a.cal.json").read_text("utf-8").splitlines()
    whole = len(lines) == int(lines[0]) and set(lines) == {lines[0]}
    return Found(1, int(not whole), "the later of the two is kept, whole")


def index_kept(folder: Path, _: list[str]) -> Found:
    """The index opens undamaged, and after a look at the folder holds all of it."""
    with Archive(folder) as archive:
        notes = [note.text for note in archive.notes]
        archive.refresh()
        total = archive.search().total
    return Found(1, abs(12 - total) + len(notes), "the next refresh takes in what is missing")


def cut_journal(folder: Path, rng: random.Random, trials: int) -> Found:
    """A power cut: the journal ends anywhere, or in zeros; every event before stays."""
    files = seeds.session()
    journal = files[JOURNAL_NAME]
    ends = [n + 1 for n, byte in enumerate(journal) if byte == 10]

    def check(place: Path, content: bytes, size: int) -> Found:
        record = read_session(place)
        whole = sum(end <= size for end in ends)
        lost = max(0, whole - len(record.events))
        # What the disk gave back after the cut is never changed, the next event begins after it.
        with Session.open(place) as again:
            step = again.record.start.plan.steps[4]
            again.accept(step, seeds.mean(), temperature_c=26.0)
        after = (place / JOURNAL_NAME).read_bytes()
        lost += int(not after.startswith(content))
        lost += int(read_session(place).positions[-1].step != step)
        notes = [note.text.partition(": ")[2] for note in record.notes]
        return Found(1, lost, notes[0] if notes else "")

    return _cuts(
        folder, rng, trials, {START_NAME: files[START_NAME]}, (JOURNAL_NAME, journal), check
    )


def cut_record(folder: Path, rng: random.Random, trials: int) -> Found:
    """A power cut: the record ends anywhere, or in zeros; every block before stays."""
    whole = seeds.recording()
    first = whole.index(b"RAW0")
    (folder / "whole.calrec").write_bytes(whole)
    blocks = [b for b in read_blocks(folder / "whole.calrec") if not isinstance(b, Damage)]
    ends = [block.offset + 12 + len(block.payload) for block in blocks]

    def check(place: Path, _: bytes, size: int) -> Found:
        kept = [b for b in read_blocks(place / "a.calrec") if not isinstance(b, Damage)]
        wanted = sum(end <= size for end in ends)
        lost = max(0, wanted - len(kept)) + sum(
            one.payload != other.payload for one, other in zip(kept, blocks, strict=False)
        )
        record = read_recording(place / "a.calrec")
        notes = [note.text for note in record.notes]
        return Found(1, lost, notes[0] if notes else "")

    low = next(end for block, end in zip(blocks, ends, strict=True) if block.tag == b"BLK0")
    assert first < low
    return _cuts(folder, rng, trials, {}, ("a.calrec", whole), check, low)


def _cuts(
    folder: Path,
    rng: random.Random,
    trials: int,
    beside: Mapping[str, bytes],
    file: tuple[str, bytes],
    check: Callable[[Path, bytes, int], Found],
    low: int = 0,
) -> Found:
    found = Found()
    for trial in range(trials):
        place = folder / f"cut {trial}"
        place.mkdir()
        size = rng.randint(low, len(file[1]))
        zeros = rng.choice((0, 0, rng.randint(1, 5000)))
        content = file[1][:size] + bytes(zeros)
        for name, data in {**beside, file[0]: content}.items():
            (place / name).write_bytes(data)
        found += check(place, content, size)
    return found


def together(victim: str, check: Check) -> Run:
    """A fault: two programs work in one folder at once."""

    def run(folder: Path, rng: random.Random, trials: int) -> Found:
        found = Found()
        for trial in range(trials):
            place = folder / f"pair {trial}"
            place.mkdir()
            _furnish(victim, place)
            both: list[Victim] = []
            for name in ("first", "second"):
                promises = folder / f"{name} {trial}.txt"
                both.append(nursery().start(victim, place, promises))
                both[-1].wait_for(1)
            told = [line for one in both for line in one.kill(rng, _MOST_S)]
            refused = [line for line in told if line.startswith("refused: ")]
            kept = check(place, [line for line in told if line not in refused])
            message = refused[0].removeprefix("refused: ") if refused else kept.message
            found += Found(1, kept.lost, message.replace(str(place), "FOLDER"))
        return found

    return run
