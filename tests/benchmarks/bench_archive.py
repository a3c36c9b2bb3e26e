"""Speed of the archive with ten thousand sessions, half of them calibrated.

    python tests/benchmarks/bench_archive.py [NUMBER]      SQLite
    python tests/benchmarks/bench_archive.py 10000 URL     PostgreSQL as well

Searches are the median of 20 calls after a first one; a refresh lists what has changed in the
folders. With SQLite times are CPU seconds of the process, so that other work on the machine does
not count; with PostgreSQL, whose server is another process, they are wall clock. There is no peer:
the programs of the field keep no index.
"""

import os
import shutil
import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from core.archive.nearest import nearest
from core.archive.store import Archive
from core.procedures.dividing_head import calibrate
from core.records.legacy.reader import read_legacy
from tests.core.archive.conftest import SPECIMENS, STATED, calibrated, measured, old

SEARCH_MS, REFRESH_S, HISTORY_MS = 50.0, 0.5, 50.0
DEVICES = 200


def fill(root: Path, number: int) -> None:
    """Copies of one session with its calibration, each under its own device and day."""
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    seed = root / "seed"
    measured(seed, positions=8)
    calibrated(calibrate(run, STATED), seed)
    texts = {path.name: path.read_text("utf-8") for path in seed.iterdir()}
    shutil.rmtree(seed)
    for n in range(number):
        day = f"{2005 + n // 700}-{1 + n % 12:02d}-{1 + n % 28:02d}"
        folder = root / f"{day.replace('-', '')}_{n}"
        folder.mkdir()
        for name, text in texts.items():
            if name.endswith(".cal.json") and n % 2:
                continue
            own = text.replace('"PW09"', f'"PW{n % DEVICES:03d}"').replace("2024-05-14", day)
            (folder / name).write_text(own.replace("2025-03-01", day), "utf-8")
    old(root)


class Watch:
    """Times calls on the clock that fits the database."""

    def __init__(self, url: str) -> None:
        self._now = time.perf_counter if url else time.process_time

    def once(self, call: Callable[[], object]) -> float:
        """Seconds of one call."""
        begin = self._now()
        call()
        return self._now() - begin

    def median_ms(self, call: Callable[[], object], times: int = 20) -> float:
        """Median after a first call."""
        call()
        return 1e3 * statistics.median(self.once(call) for _ in range(times))


def row(name: str, value: float, unit: str, target: float) -> None:
    """One line; without a target it is only told."""
    verdict = "" if target <= 0.0 else f"<= {target:g} | {'ok' if value <= target else 'MISSED'}"
    print(f"{name:52} {value:9.3g} {unit:3} |  |  | {verdict}".rstrip())


def measure(root: Path, number: int, url: str) -> None:
    """All figures on one database."""
    kind = "PostgreSQL" if url else "SQLite"
    watch = Watch(url)
    with Archive(root, url) as archive:
        first = watch.once(archive.rebuild)
        row(f"{kind}: {number} sessions read for the first time", first, "s", 0)
        questions = {
            "all, the latest 500": lambda: archive.search(),
            "a device": lambda: archive.search("pw017"),
            "four words": lambda: archive.search("pw0 2012 session олена"),
            "nothing found": lambda: archive.search("nobody"),
        }
        for name, question in questions.items():
            row(f"{kind}: search, {name}", watch.median_ms(question), "ms", SEARCH_MS)
        follow = watch.median_ms(lambda: archive.readings("PW016", "bias", "acc_x"))
        row(f"{kind}: history of a parameter", follow, "ms", HISTORY_MS)
        when = archive.search(limit=1).entries[0].when
        assert when is not None
        near = watch.median_ms(lambda: nearest(archive, "PW016", when, 25.0))
        row(f"{kind}: nearest calibration", near, "ms", SEARCH_MS)
        row(
            f"{kind}: refresh, nothing new",
            watch.median_ms(archive.refresh, 5) / 1e3,
            "s",
            REFRESH_S,
        )
        new = measured(root / "20300101_new", device="NEW", started="2030-01-01T10:00:00+00:00")
        row(f"{kind}: refresh, one new session", watch.once(archive.refresh), "s", REFRESH_S)
        assert archive.search("new").entries[0].serial == "NEW"
        shutil.rmtree(new)
        if not url:
            size = sum(path.stat().st_size for path in root.glob("archive.db*")) / 2**20
            row(f"{kind}: size of the index", size, "MB", 0)


def main() -> None:
    """Print all rows."""
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    with tempfile.TemporaryDirectory(prefix="calrig-bench-") as folder:
        root = Path(folder)
        fill(root, number)
        os.sync()
        for url in ["", *sys.argv[2:]]:
            measure(root, number, url)


if __name__ == "__main__":
    main()
