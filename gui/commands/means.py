"""Every record of the folder is averaged: CVGCom's text files and recordings (.calrec).

Writes means.dat (file name and means) and means.csv (with standard errors) into the folder. Of a
recording and the text file beside it only the recording counts. With --rates or --positions, one
for each record in the order of the table, --run writes a run file for `calrig fit`.
"""

import argparse
from pathlib import Path

from core.errors import FormatError
from core.records.cvgcom_name import CvgcomName
from core.records.means import RecordMean, means_run, number_of, position_of, write_means
from core.records.run_file import write_run
from drivers.records import open_record, record_means, records_in
from gui.commands.answer import Answer


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the folder, the intervals and what stood on the table or the head."""
    parser.add_argument("folder", type=Path)
    parser.add_argument(
        "--interval", action="append", default=[], metavar="A:B", help="seconds of each record"
    )
    parser.add_argument("--rates", help="set rates, deg/s: 10,-10,20,-20")
    parser.add_argument("--positions", help="mounts and angles: X_from:0,X_from:90")
    parser.add_argument("--device", default="", help="serial number, if no file tells it")
    parser.add_argument("--run", type=Path, help="run file to write (NAME.run.csv)")


def run(args: argparse.Namespace) -> Answer:
    """Average, write and show the means."""
    intervals: list[tuple[float, float] | None] = [_pair(text) for text in args.interval]
    means = [
        mean
        for path in records_in(args.folder)
        for mean in record_means(open_record(path), intervals or [None])
    ]
    files = [*write_means(means, args.folder)]
    if args.run is not None:
        write_run(
            means_run(
                means,
                args.device or _device(means),
                rates_dps=[number_of(text) for text in _list(args.rates)],
                positions=[position_of(text) for text in _list(args.positions)],
            ),
            args.run,
        )
        files.append(args.run)
    data = {"files": files, "means": [_plain(one) for one in means]}
    return Answer(data, "\n".join([*map(_line, means), *map(str, files)]))


def _device(means: list[RecordMean]) -> str:
    names = (CvgcomName.parse(mean.record) for mean in means)
    return next((name.device for name in names if name is not None), "")


def _list(text: str | None) -> list[str]:
    return [part.strip() for part in text.split(",")] if text else []


def _pair(text: str) -> tuple[float, float]:
    start, colon, stop = text.partition(":")
    if not colon:
        raise FormatError("arguments", f"{text!r} is no interval; write 10:70")
    return number_of(start), number_of(stop)


def _plain(one: RecordMean) -> dict[str, object]:
    return {
        "record": one.record,
        "channels": [channel.name for channel in one.channels],
        "mean": one.mean,
        "se": one.se,
        "n": one.n,
        "start_s": one.start_s,
        "seconds": one.seconds,
        "lost": one.lost,
        "notes": one.notes,
    }


def _line(one: RecordMean) -> str:
    values = "  ".join(
        f"{channel.name} {mean:.9f} ± {se:.2g} {channel.unit}"
        for channel, mean, se in zip(one.channels[:2], one.mean, one.se, strict=False)
    )
    notes = "".join(f"\n  {note.severity.value}: {note.text}" for note in one.notes)
    return f"{one.record}  n {one.n}  {values}{notes}"
