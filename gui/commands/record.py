"""The bytes are written as they come, so that any later program can decode them again.

The profile is found by listening if it is not given. Ends after ``--seconds`` or at Ctrl+C.
"""

import argparse
import sys
import time
from datetime import datetime
from pathlib import Path

from core.errors import FormatError, LinkError, StorageError
from core.records.names import safe_name, stamp
from core.version import SOFTWARE
from drivers.decoders import make_decoder
from drivers.events import Ended
from drivers.ports import reopener
from drivers.profile import Profile, load_profiles
from drivers.rawlog import RawLog
from drivers.reader import Counters, Reader
from drivers.scan import scan
from drivers.transport import opener
from gui.commands.answer import Answer

_LOOK_S = 0.1


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the port, the profile, the length and the file."""
    parser.add_argument("port", help="COM4, /dev/ttyUSB0, sim://cvg25, ...")
    parser.add_argument("--profile", help="identifier of the device's profile")
    parser.add_argument("--baud", type=int, default=0, help="speed; the profile's own if not given")
    parser.add_argument("--seconds", type=float, default=float("inf"), help="how long (no end)")
    parser.add_argument("--out", type=Path, help="file (DEVICE_YYYYMMDDhhmm.calrec)")


def run(args: argparse.Namespace) -> Answer:
    """Record until the time is over."""
    profile, baud = _profile(args)
    path = args.out or Path(f"{safe_name(profile.name)}_{stamp(datetime.now())}.calrec")
    header = {
        "software": SOFTWARE,
        "port": args.port,
        "baud": baud or profile.port.bauds[0],
        "profile": profile.id,
        "profile_text": profile.text,
    }
    reader = Reader(
        opener(args.port, profile.port, baud),
        make_decoder(profile),
        RawLog(path, header),
        reopener(args.port, profile.port, baud),
    )
    reader.start()
    error = _until(reader, args.seconds)
    counters, refused = reader.counters, reader.storage_error
    if refused is not None:
        raise StorageError(f"{refused}; what was written before is in {path}")
    if error is not None and not counters.bytes:
        raise error
    data = {"file": path, "profile": profile.id, "counters": counters, "ended_by": str(error or "")}
    return Answer(data, f"{path}\n{_sentence(counters)}" + (f"\n{error}" if error else ""))


def _profile(args: argparse.Namespace) -> tuple[Profile, int]:
    profiles = load_profiles()
    if args.profile is None:
        found = scan([args.port], profiles.values()).found
        if not found:
            raise LinkError(args.port, "no profile explains what comes", "name one by --profile")
        return found[0].profile, args.baud or found[0].baud
    if args.profile not in profiles:
        known = ", ".join(profiles)
        raise FormatError(args.profile, f"there is no such profile; there are: {known}")
    return profiles[args.profile], args.baud


def _until(reader: Reader, seconds: float) -> LinkError | None:
    end = time.monotonic() + seconds
    error: LinkError | None = None
    ended = False
    try:
        while not ended and time.monotonic() < end:
            time.sleep(_LOOK_S)
            for event in reader.drain():
                if isinstance(event, Ended):
                    error, ended = event.error, True
    except KeyboardInterrupt:
        print("ending the record", file=sys.stderr)
    finally:
        reader.close()
    return error


def _sentence(counters: Counters) -> str:
    return (
        f"{counters.bytes} bytes, {counters.frames} frames, {counters.bad_checksum} bad checksums,"
        f" {counters.lost} samples lost, {counters.garbage} bytes of garbage"
    )
