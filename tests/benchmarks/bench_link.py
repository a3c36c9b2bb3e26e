"""What the link costs: the simulated rig, the reader thread on a pty, the raw log."""

import tempfile
import time
from pathlib import Path

from drivers.decoders import make_decoder
from drivers.profile import load_profiles
from drivers.rawlog import RawLog
from drivers.reader import Reader
from drivers.transport import opener
from drivers.virtual.pty_process import PtyProcess
from drivers.virtual.rig import Rig, RigOptions

RATE = 2000
CHUNK = 40
SECONDS = 10


def row(name: str, value: float, unit: str, limit: float, at_most: bool = True) -> None:
    held = value <= limit if at_most else value >= limit
    sign = "<=" if at_most else ">="
    print(
        f"{name:34} {value:9.2f} {unit:8} | - | - | {sign} {limit:g} | {'ok' if held else 'MISSED'}"
    )


def rig_share() -> float:
    """Share of a core, %, that the rig takes at 2 kHz x 48 bytes in 20 ms chunks."""
    rig = Rig(RigOptions(device="cvg25", rate_hz=RATE))
    rig.produce(CHUNK)
    began = time.process_time()
    for _ in range(RATE * SECONDS // CHUNK):
        rig.produce(CHUNK)
    return (time.process_time() - began) / SECONDS * 100.0


def rig_hour() -> float:
    """CPU seconds for an hour of nine accelerometers at 200 Hz."""
    rig = Rig(RigOptions(device="clbacc"))
    began = time.process_time()
    rig.produce(3600 * 200)
    return time.process_time() - began


def reader_share(folder: Path) -> tuple[float, int]:
    """Share of a core, %, of reader, raw log and decoder at 2 kHz through a pty; lost samples."""
    profile = load_profiles()["cvgx48"]
    with PtyProcess(f"sim://cvg25?rate={RATE}") as rig:
        log = RawLog(folder / "bench.calrec", {})
        reader = Reader(opener(rig.port, profile.port), make_decoder(profile), log)
        reader.start()
        time.sleep(1.0)
        reader.drain()
        began = time.process_time()
        for _ in range(SECONDS * 30):
            time.sleep(1 / 30)
            reader.drain()
        share = (time.process_time() - began) / SECONDS * 100.0
        reader.close()
        return share, reader.counters.lost


def log_rate(folder: Path) -> float:
    """MB/s of the raw log in blocks of 2 kB, with its syncs."""
    log = RawLog(folder / "rate.calrec", {})
    data, count = bytes(2000), 20_000
    began = time.perf_counter()
    for _ in range(count):
        log.write(data, time.monotonic())
    log.close()
    return len(data) * count / (time.perf_counter() - began) / 1e6


def main() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        row("rig, 2 kHz x 48 bytes", rig_share(), "% core", 5.0)
        row("rig, an hour of 9 x 200 Hz", rig_hour(), "s CPU", 10.0)
        share, lost = reader_share(folder)
        row("reader on a pty, 2 kHz x 48 bytes", share, "% core", 8.0)
        row("samples lost meanwhile", lost, "", 0)
        row("raw log", log_rate(folder), "MB/s", 20.0, at_most=False)


if __name__ == "__main__":
    main()
