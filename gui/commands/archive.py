"""The archive of a folder of sessions: an index beside the files, which stay the truth.

    calrig archive list pw09 2025            what is there of PW09 in 2025
    calrig archive show 17                   a calibration with its parameters
    calrig archive history PW09 bias --channel acc_x
    calrig archive compare 17 42
    calrig archive nearest PW09 --date 2025-03-01 --temperature 40
    calrig archive import OLD_FOLDER
    calrig archive reprocess 16              decode a session's raw bytes again
    calrig archive rebuild                   read all files anew

Every call first takes in what has changed in the folder. --root names another folder than that of
the window, --database a PostgreSQL database that several rigs share.
"""

import argparse
import math
import sys
from collections.abc import Callable
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from core.errors import FormatError
from gui.commands.answer import Answer

if TYPE_CHECKING:
    from core.archive.entry import Entry
    from core.archive.store import Archive

_KINDS = ("session", "calibration", "run", "legacy", "record", "means", "noise")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what is to be done, and with what."""
    parser.add_argument("action", choices=list(ACTIONS))
    parser.add_argument("what", nargs="*", help="words, numbers of entries, or a folder")
    parser.add_argument("--kind", action="append", choices=_KINDS, help="of this kind only")
    parser.add_argument("--limit", type=int, default=50, help="no more lines than these (50)")
    parser.add_argument("--channel", default="", help="output that a parameter belongs to")
    parser.add_argument("--sensor", default="", choices=["", "accelerometer", "gyro"])
    parser.add_argument("--temperature", type=float, default=math.nan, metavar="C")
    parser.add_argument("--date", type=datetime.fromisoformat, help="ISO date or moment; now")
    parser.add_argument("--profiles", action="store_true", help="reprocess by today's device files")
    parser.add_argument("--root", type=Path, help="folder of the sessions")
    parser.add_argument("--database", default="", metavar="URL", help="postgresql://USER@HOST/NAME")


def run(args: argparse.Namespace) -> Answer:
    """Open the archive, bring it up to date, do what is asked."""
    from core.archive.store import Archive
    from core.records.session.find import default_root
    from gui.archive.raw import RAW_READERS

    with Archive(args.root or default_root(), args.database, RAW_READERS) as archive:
        for note in archive.notes:
            print(f"{note.severity.value}: {note.text}", file=sys.stderr)
        if args.action != "rebuild":
            archive.refresh(_progress("folders"))
        return ACTIONS[args.action](archive, args)


def _progress(of_what: str) -> "Callable[[int, int], None]":
    """Tell long work on the console, where there is one."""

    def tell(done: int, of: int) -> None:
        if sys.stderr.isatty() and of > 200:
            end = "\n" if done == of else "\r"
            print(f"{done} of {of} {of_what}", end=end, file=sys.stderr, flush=True)

    return tell


def _list(archive: "Archive", args: argparse.Namespace) -> Answer:
    from gui.archive.texts import LISTED, listed, table

    hits = archive.search(" ".join(args.what), args.kind or (), limit=args.limit)
    rows = [(str(entry.id), *listed(entry), entry.path) for entry in hits.entries]
    text = table(("no.", *LISTED, "file"), rows) if rows else "nothing found"
    if hits.total > len(rows):
        text += f"\n{len(rows)} of {hits.total}; more by --limit, fewer by more words"
    return Answer({"total": hits.total, "entries": hits.entries}, text)


def _show(archive: "Archive", args: argparse.Namespace) -> Answer:
    from core.archive.limits import limit_of, read_limits
    from gui.archive.texts import LISTED, listed, parameter_row, table

    entry = _entries(archive, args, 1)[0]
    limits = read_limits(archive.place.root)
    quantities = archive.quantities(entry)
    rows = [parameter_row(q, limit_of(limits, entry, q)) for q in quantities]
    lines = [table(("no.", *LISTED, "file"), [(str(entry.id), *listed(entry), entry.path)])]
    if entry.remark:
        lines.append(entry.remark)
    if rows:
        header = ("channel", "parameter", "value", "U (95 %)", "unit", "limits")
        lines += ["", table(header, rows)]
    return Answer({"entry": entry, "quantities": quantities}, "\n".join(lines))


def _history(archive: "Archive", args: argparse.Namespace) -> Answer:
    from core.archive.history import history_of
    from core.archive.limits import read_limits
    from gui.archive.texts import HISTORY, history_rows, statistics_rows, table

    if len(args.what) != 2:
        raise FormatError("history", "give a serial number and a parameter: history PW09 bias")
    serial, name = args.what
    channel = args.channel or _channel(archive, serial, name, args.sensor)
    readings = archive.readings(serial, name, channel, args.sensor)
    if not readings:
        raise FormatError(serial, f"has no {name} of {channel} in the archive")
    limits = read_limits(archive.place.root)
    history = history_of(readings, limits, temperature_c=args.temperature)
    lines = [
        f"{serial}, {channel} {name}, {history.unit}",
        table(HISTORY, history_rows(history)),
        "",
        table(("", "value", "U", "unit"), statistics_rows(history)),
        *(f"{note.severity.value}: {note.text}" for note in history.notes),
    ]
    data = {
        "serial": serial,
        "channel": channel,
        "parameter": name,
        "unit": history.unit,
        "n": history.n,
        "mean": history.mean,
        "repeatability": history.repeatability,
        "excess": history.excess,
        "drift": history.drift,
        "limit": history.limit,
        "readings": history.readings,
        "counted": history.counted,
        "notes": history.notes,
    }
    return Answer(data, "\n".join(lines))


def _channel(archive: "Archive", serial: str, name: str, sensor: str) -> str:
    """The channel that has the parameter in the latest calibration, where it is one."""
    for entry in archive.search(kinds=("calibration", "noise"), serial=serial).entries:
        if sensor in ("", entry.sensor):
            channels = [q.channel for q in archive.quantities(entry) if q.name == name]
            if len(channels) > 1:
                told = ", ".join(channels)
                raise FormatError(serial, f"has {name} of {told}: choose one by --channel")
            if channels:
                return channels[0]
    raise FormatError(serial, f"has no parameter {name} in the archive")


def _compare(archive: "Archive", args: argparse.Namespace) -> Answer:
    from core.archive.compare import compare
    from gui.archive.texts import COMPARED, compared_row, compared_summary, local, table

    one, other = _entries(archive, args, 2)
    compared = compare(
        (one, archive.quantities(one)),
        (other, archive.quantities(other)),
    )
    lines = [
        f"first: {compared.first.serial}, {local(compared.first.measured)};"
        f" second: {compared.second.serial}, {local(compared.second.measured)}",
        table(COMPARED, map(compared_row, compared.rows)),
        compared_summary(compared),
        *(f"{note.severity.value}: {note.text}" for note in compared.notes),
    ]
    return Answer(compared, "\n".join(lines), code=1 if compared.marked else 0)


def _nearest(archive: "Archive", args: argparse.Namespace) -> Answer:
    from core.archive.nearest import nearest
    from gui.archive.texts import degrees, local, table

    if len(args.what) != 1:
        raise FormatError("nearest", "give a serial number: nearest PW09")
    when = (args.date or datetime.now()).astimezone()
    found = nearest(archive, args.what[0], when, args.temperature, sensor=args.sensor)
    rows = [
        (
            str(one.entry.id),
            local(one.entry.measured),
            f"{one.days:+.1f}",
            degrees(one.entry.temperature_c),
            one.entry.path,
        )
        for one in found[: args.limit]
    ]
    text = table(("no.", "measured", "days", "°C", "file"), rows)
    if not rows:
        text = f"{args.what[0]} has no calibration in the archive"
    return Answer(found, text, code=0 if rows else 1)


def _import(archive: "Archive", args: argparse.Namespace) -> Answer:
    from core.archive.importing import import_folder
    from gui.archive.texts import table

    reports = [
        report
        for name in args.what
        for report in import_folder(archive, Path(name), _progress("files"))
    ]
    rows = [(report.outcome, str(report.path), report.what) for report in reports]
    counts: dict[str, int] = {}
    for report in reports:
        counts[report.outcome] = counts.get(report.outcome, 0) + 1
    told = ", ".join(f"{count} {outcome}" for outcome, count in counts.items())
    return Answer(reports, table(("", "file", "what"), rows) + f"\n{told or 'no files'}")


def _rebuild(archive: "Archive", _: argparse.Namespace) -> Answer:
    done = archive.rebuild(_progress("folders"))
    lines = [f"{archive.name}: {done.taken} entries"]
    lines += [f"damaged: {entry.path}: {entry.remark}" for entry in done.damaged]
    return Answer({"entries": done.taken, "damaged": done.damaged}, "\n".join(lines))


def _reprocess(archive: "Archive", args: argparse.Namespace) -> Answer:
    from core.archive.reprocess import reprocess
    from core.records.session.record import read_session
    from drivers.profile import load_profiles
    from gui.archive.raw import TodaysDecoder
    from gui.archive.texts import REDONE, reasons, redone_row, table

    entry = _entries(archive, args, 1)[0]
    if entry.kind != "session":
        raise FormatError(entry.path, f"is a {entry.kind}: only sessions have raw bytes")
    root = archive.place.root
    decode = TodaysDecoder(load_profiles(root / "devices") if args.profiles else None)
    found = reprocess(read_session(archive.path_of(entry)), root / "raw", decode)
    data = [
        {
            "step": one.position.step.number,
            "same": one.same,
            "samples": one.n,
            "channels": [channel.name for channel in one.channels],
            "stored": one.stored,
            "again": one.again,
            "ratio": one.ratio,
            "why_not": one.why_not,
        }
        for one in found
    ]
    same = sum(one.same for one in found)
    lines = [table(REDONE, map(redone_row, found)), *reasons(found)]
    text = "\n".join([*lines, f"{same} of {len(found)} the same"])
    return Answer(data, text, code=0 if same == len(found) else 1)


def _entries(archive: "Archive", args: argparse.Namespace, count: int) -> "list[Entry]":
    """The entries whose numbers are given."""
    if len(args.what) != count or not all(word.isdigit() for word in args.what):
        numbers = "the number of an entry" if count == 1 else f"the numbers of {count} entries"
        raise FormatError(args.action, f"give {numbers}, as `calrig archive list` shows them")
    return [archive.entry(int(word)) for word in args.what]


ACTIONS = {
    "list": _list,
    "show": _show,
    "history": _history,
    "compare": _compare,
    "nearest": _nearest,
    "import": _import,
    "rebuild": _rebuild,
    "reprocess": _reprocess,
}
