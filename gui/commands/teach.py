"""The file is a raw log or a recording of CalRig (`calrig record` makes one), or plain bytes.

What is printed is a whole device file; save it as NAME.toml in the folder `devices` of the
sessions, look through names, scales and units, and choose it in Device Properties.
"""

import argparse
from pathlib import Path

from core.records.atomic import write_text_atomic
from drivers.profile_types import LineSpec
from drivers.teach.analysis import Proposal, analyse, device_file
from drivers.teach.frames import FrameProposal
from gui.commands.answer import Answer
from gui.frames.listening import heard_in


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file, and what the bytes do not tell."""
    parser.add_argument("rawlog", type=Path, help="raw log, recording, or file of plain bytes")
    parser.add_argument("--name", default="", help="what the operator reads (the file's name)")
    parser.add_argument(
        "--kind", default="imu", choices=("gyro", "accel", "imu", "ahrs", "adc"), help="(imu)"
    )
    parser.add_argument("--baud", type=int, default=115200, help="speed of the port (115200)")
    parser.add_argument("--out", type=Path, help="write the device file there")


def run(args: argparse.Namespace) -> Answer:
    """Find out what the bytes of a file are."""
    heard = heard_in(args.rawlog)
    proposal = analyse(heard.tail, heard.bytes_per_s, heard.doubt)
    if proposal.found is None:
        text = (
            f"{args.rawlog}: neither frames of one length nor lines of numbers were found in"
            f" {len(heard.tail)} bytes. Is the baud rate right?"
        )
        return Answer({"found": None, "bytes": len(heard.tail)}, text, 1)
    name = args.name or args.rawlog.stem
    text = device_file(proposal, name, args.kind, args.baud, f"taught from {args.rawlog.name}")
    if args.out is not None:
        write_text_atomic(args.out, text)
    return Answer(_plain(proposal, text), text.rstrip("\n"))


def _plain(proposal: Proposal, text: str) -> dict[str, object]:
    found, stream = proposal.found, proposal.stream
    if found is None or stream is None:
        return {"found": None}
    told: dict[str, object] = {
        "share": found.share,
        "hz": proposal.hz,
        "rate_doubt": proposal.pace.why,
        "device_file": text,
    }
    if isinstance(stream, LineSpec):
        return {"found": "lines", **told, "columns": [one.name for one in stream.channels]}
    if not isinstance(found, FrameProposal):
        raise TypeError(f"frames were found as {type(found).__name__}")
    return {
        "found": "frames",
        **told,
        "sync": " ".join(f"{byte:02X}" for byte in stream.sync if byte is not None),
        "length": stream.length,
        "checksums": [
            {"checksum": one.text, "from": one.spec.start, "share": one.share}
            for one in found.checks
        ],
        "length_readings": [
            {"at": one.at, "value": one.value, "meaning": one.meaning, "length": one.length,
             "share": one.share}
            for one in found.readings
        ],
        "fields": [{"at": field.at, "type": field.type} for field in stream.fields],
    }  # fmt: skip
