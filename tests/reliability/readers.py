"""Every reader of the program with a file that it reads well: what is damaged to try them.

`READERS` names them; `attempt` gives one a damaged file and holds it to the rule: nothing leaves it
but an error of `core.errors`, within the time, and nothing on the disk is changed.
"""

import functools
import tempfile
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from core.archive.limits import read_limits
from core.archive.place import INDEX, place_of
from core.archive.reading import read_file
from core.archive.store import Archive
from core.certificates.laboratory import read_laboratory
from core.certificates.register import Register
from core.errors import LabError
from core.plans.plan import load_plan
from core.records.calibration_json import read_calibration
from core.records.cvgcom import read_cvgcom
from core.records.gyro_facts import read_facts
from core.records.means import read_means
from core.records.open import read_any
from core.records.run_file import read_run
from core.records.series_text import read_text_series
from core.records.session.record import JOURNAL_NAME, START_NAME, read_session
from core.records.session.start import start_from_text
from core.samples.run import Conditions
from drivers.decoders import make_decoder
from drivers.profile import load_profile, load_profiles
from drivers.rawlog import read_rawlog
from drivers.recording import read_recording
from drivers.records import is_recording, open_record, was_ended
from drivers.series import read_series
from gui.settings import Settings
from tests.reliability import repairs, seeds

PATIENCE_S = 5.0
"""Longest that a reader may take over a file of some kilobytes, on a loaded machine."""
_CONDITIONS = Conditions(g_mps2=9.81, u_g_mps2=1e-4, head_u_arcsec=5.0)


@dataclass(frozen=True, slots=True)
class Seed:
    """A folder that is read well.

    Parameters
    ----------
    name, content : the file that is damaged
    beside : other files of the folder
    """

    name: str
    content: bytes
    beside: Mapping[str, bytes] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Reader:
    """One reader.

    Parameters
    ----------
    seeds : returns good files
    read : reads the file at a path, and looks at what it gave
    repair : puts check sums right after damage
    own : beginning of names of files that reading may change: an index is no measurement
    """

    seeds: Callable[[], tuple[Seed, ...]]
    read: Callable[[Path], object]
    repair: Callable[[bytes], bytes] = repairs.unchanged
    own: str = ""


class Broken(AssertionError):
    """A reader broke the rule."""


def attempt(reader: Reader, seed: Seed, content: bytes, folder: Path) -> str:
    """Let a reader read a damaged file; return what it said, empty if it read it.

    Raises
    ------
    Broken
        Something else than an error of `core.errors` left it, it took too long, or it changed
        a file.
    """
    files = {**seed.beside, seed.name: content}
    for name, data in files.items():
        (folder / name).write_bytes(data)
    said = ""
    began = time.perf_counter()
    try:
        reader.read(folder / seed.name)
    except LabError as error:
        said = str(error)
        if not said.strip():
            raise Broken(f"{type(error).__name__} without a word") from error
    spent = time.perf_counter() - began
    if spent > PATIENCE_S:
        raise Broken(f"took {spent:.1f} s over {len(content)} bytes")
    after = {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}
    changed = {
        name
        for name in {*files, *after}
        if files.get(name) != after.get(name) and not (reader.own and name.startswith(reader.own))
    }
    for name in after:
        (folder / name).unlink()
    if changed:
        raise Broken(f"changed on the disk: {sorted(changed)}")
    return said


def _each(*readings: Callable[[], object]) -> None:
    """Read in several ways; raise what the last one said if no way led to anything."""
    said: list[LabError] = []
    for reading in readings:
        try:
            reading()
        except LabError as error:
            said.append(error)
    if len(said) == len(readings):
        raise said[-1]


def _legacy(path: Path) -> None:
    read_file(path, {})
    _each(
        lambda: read_any(path),
        lambda: read_any(path, sensor="accelerometer"),
        lambda: read_any(path, sensor="gyro", mounts=("X_to",)),
        lambda: read_facts(path, _CONDITIONS),
    )


def _run(path: Path) -> None:
    read_file(path, {})
    _each(lambda: read_run(path), lambda: read_any(path), lambda: read_facts(path, _CONDITIONS))


def _session(path: Path) -> None:
    read_file(path.parent, {})
    record = read_session(path.parent)
    _ = (record.attempts, record.is_finished)
    record.run()


def _calibration(path: Path) -> None:
    read_file(path, {})
    read_calibration(path)


def _cvgcom(path: Path) -> None:
    read_file(path, {})
    read_cvgcom(path)
    record = open_record(path)
    record.samples()


def _series(path: Path) -> None:
    series = read_series(path)
    for place in range(len(series.channels)):
        series.sampled(place, 100.0)


def _recording(path: Path) -> None:
    if is_recording(path):
        was_ended(path)
    for from_bytes in (False, True):
        record = read_recording(path, from_bytes=from_bytes)
        for chunk in record.chunks():
            _ = (chunk.index, chunk.data)
        record.index()
        _ = (record.gaps, record.marks, record.seconds, record.settings)
    _series(path)


def _raw_log(path: Path) -> None:
    for part in read_rawlog(path):
        _ = part.offset if hasattr(part, "offset") else part.t


def _noise(path: Path) -> None:
    read_file(path, {})
    read_facts(path, _CONDITIONS)


def _means(path: Path) -> None:
    read_file(path, {})
    read_means(path)


def _profile(path: Path) -> None:
    make_decoder(load_profile(path)).feed(bytes(range(256)) * 4)


def _index(path: Path) -> None:
    with Archive(path.parent) as archive:
        archive.refresh()
        for entry in archive.search().entries:
            archive.quantities(entry)


def _start(path: Path) -> None:
    start_from_text(path.read_text("utf-8", errors="replace"), str(path))


def _frames(profile: str) -> Reader:
    def read(path: Path) -> None:
        content = path.read_bytes()
        decoder = make_decoder(load_profiles_once()[profile])
        heard = 0
        for at in range(0, len(content), 700):
            for event in decoder.feed(content[at : at + 700]):
                index = getattr(event, "index", None)
                if index is not None:
                    heard += len(index)
                    assert np.all(np.diff(index) > 0), "sample numbers do not ascend"
        decoder.flush()
        assert heard <= len(content), "more samples than bytes"

    return Reader(lambda: (Seed("frames.bin", seeds.frames(profile)),), read)


load_profiles_once = functools.cache(load_profiles)


def _of(**files: Callable[[], bytes]) -> Callable[[], tuple[Seed, ...]]:
    return lambda: tuple(
        Seed(name.replace("__", "."), content()) for name, content in files.items()
    )


def _all(pairs: Callable[[], Mapping[str, bytes]]) -> Callable[[], tuple[Seed, ...]]:
    return lambda: tuple(Seed(name, content) for name, content in pairs().items())


def _within(name: str, files: Callable[[], Mapping[str, bytes]]) -> Callable[[], tuple[Seed, ...]]:
    """One file of a folder; the others stand beside it."""

    def made() -> tuple[Seed, ...]:
        folder = files()
        beside = {other: content for other, content in folder.items() if other != name}
        return (Seed(name, folder[name], beside),)

    return made


READERS: dict[str, Reader] = {
    "legacy text": Reader(_all(seeds.legacy), _legacy),
    "run file": Reader(_of(a__run__csv=seeds.run_file), _run),
    "session, start": Reader(_within(START_NAME, seeds.session), _session),
    "session, start alone": Reader(_within(START_NAME, seeds.session), _start),
    "session, journal": Reader(_within(JOURNAL_NAME, seeds.session), _session, repairs.journal),
    "calibration": Reader(_of(a__cal__json=seeds.calibration), _calibration),
    "certificate": Reader(
        _of(certificate_1__json=seeds.certificate), lambda path: Register(path.parent).read(path)
    ),
    "laboratory": Reader(_of(laboratory__json=seeds.laboratory), read_laboratory),
    "CVGCom": Reader(seeds_cvgcom := lambda: (Seed(*seeds.cvgcom()),), _cvgcom),
    "CVGCom as series": Reader(seeds_cvgcom, _series),
    "text series": Reader(_of(a__csv=seeds.text_series), _series),
    "text series alone": Reader(_of(a__csv=seeds.text_series), read_text_series),
    "means": Reader(_of(means__dat=seeds.means), _means),
    "noise table": Reader(_of(a__csv=seeds.noise), _noise),
    "recording": Reader(_of(a__calrec=seeds.recording), _recording, repairs.blocks),
    "recording, unrepaired": Reader(_of(a__calrec=seeds.recording), _recording),
    "raw log": Reader(_of(a__calrec=seeds.raw_log), _raw_log, repairs.blocks),
    "raw log as record": Reader(_of(a__calrec=seeds.raw_log), _recording, repairs.blocks),
    "device file": Reader(_all(seeds.profiles), _profile),
    "plan": Reader(_all(seeds.plans), load_plan),
    "limits": Reader(_of(limits__toml=seeds.limits), lambda path: read_limits(path.parent)),
    "archive.json": Reader(_of(archive__json=seeds.place), lambda path: place_of(path.parent)),
    "archive index": Reader(_within(INDEX, seeds.archive), _index, own=INDEX),
    "preferences": Reader(_of(settings__json=seeds.settings), Settings),
    **{f"frames of {name}": _frames(name) for name in load_profiles_once()},
}


def try_out(reader: Reader, damage: Callable[[bytes], bytes]) -> list[str]:
    """Damage each good file of a reader once and let it be read; return what was said."""
    said: list[str] = []
    for seed in reader.seeds():
        with tempfile.TemporaryDirectory() as folder:
            content = reader.repair(damage(seed.content))
            said.append(attempt(reader, seed, content, Path(folder)))
    return said
