"""Readers searched by coverage: ``python -m tests.reliability.coverage_guided NAME SECONDS``.

NAME is how the names of the readers begin that are searched together. Needs atheris, which has
wheels for Linux alone and is therefore installed by hand: ``pip install atheris``. A reader that
breaks the rule ends the search with its traceback, and the exit code is not zero.
"""

import sys
import tempfile
from pathlib import Path

import atheris  # pyright: ignore[reportMissingImports]

with atheris.instrument_imports(include=["core", "drivers", "gui.settings"]):
    from tests.reliability.edits import edited, of_bytes
    from tests.reliability.readers import READERS, attempt


def main(name: str, seconds: float) -> None:
    """Search until the time is over; libFuzzer ends the process."""
    chosen = [reader for known, reader in READERS.items() if known.startswith(name)]
    good = [(reader, seed) for reader in chosen for seed in reader.seeds()]
    folder = Path(tempfile.mkdtemp())

    def one(data: bytes) -> None:
        if not data:
            return
        reader, seed = good[data[0] % len(good)]
        # The first byte also chooses between edits of a good file and bytes alone.
        content = data[1:] if data[0] >= 0xF0 else edited(seed.content, of_bytes(data[1:21]))
        attempt(reader, seed, reader.repair(content), folder)

    options = [f"-max_total_time={seconds:g}", "-max_len=600", "-timeout=20", "-rss_limit_mb=1500"]
    atheris.Setup([sys.argv[0], *options, "-print_final_stats=1"], one)
    atheris.Fuzz()


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]))
