"""The fault table: each fault often, what was lost, what the program said; kept in the docs.

``--long`` does each fault as often as `tests.reliability.matrix` asks, searches every reader for
damage that is not answered in words, and puts both tables into docs/reliability.md. Without it each
fault happens a few times. ``--only WORD`` takes the faults and readers whose names hold the word,
``--table faults`` or ``--table readers`` one of the tables.
"""

import argparse
import importlib.util
import os
import platform
import random
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from core.records.atomic import write_text_atomic  # noqa: E402
from tests.reliability.edits import chance, edited  # noqa: E402
from tests.reliability.matrix import FAULTS  # noqa: E402
from tests.reliability.readers import READERS, try_out  # noqa: E402

PAGE = ROOT / "docs" / "reliability.md"
BEGIN, END = "<!-- {} begins -->", "<!-- {} ends -->"
_SHORT, _LONG_S, _GUIDED_S = 2, 2.0, 5
_WIDEST = 150
_HEAD_LINES = 5
"""Lines of a table before its first row: an empty one, when, an empty one, two of titles."""
_FRAMES = "frames of"
"""How the names of the decoders begin; they are searched by coverage all together."""


@dataclass(frozen=True, slots=True)
class Row:
    """A row of one of the tables."""

    name: str
    trials: int
    lost: int
    told: str
    spent_s: float = 0.0
    load: float = 0.0

    def line(self, unit: str) -> str:
        """As the other benchmarks print it."""
        verdict = "ok" if not self.lost else "MISSED"
        count = f"{self.trials} {unit}"
        return f"{self.name:<58} {self.lost:4d} lost in {count:<14} | - | - | 0 | {verdict}"

    def cells(self) -> str:
        """As the page shows it."""
        told = self.told.replace("|", "/").replace("<", "&lt;")
        told = told if len(told) <= _WIDEST else told[: _WIDEST - 3] + "..."
        took = f"{self.spent_s:.0f} s, {self.load:.1f}"
        return f"| {self.name} | {self.trials} | {self.lost} | {took} | {told} |"


def timed(rows: Iterator[Row]) -> Iterator[Row]:
    """The same rows, each with how long it took and how much the machine had to do meanwhile."""
    began = time.monotonic()
    for row in rows:
        now = time.monotonic()
        yield replace(row, spent_s=now - began, load=os.getloadavg()[0])
        began = time.monotonic()


def faults(names: Sequence[str], long: bool) -> Iterator[Row]:
    """Do the faults."""
    for name in names:
        fault = FAULTS[name]
        trials = fault.many if long else max(1, min(fault.few, _SHORT))
        with tempfile.TemporaryDirectory() as folder:
            place = Path(folder)
            try:
                found = fault.run(place, random.Random(name), trials)
            except AssertionError as error:
                yield Row(fault.title, trials, trials, f"broke off: {error}")
                continue
        told = found.message.replace(folder, "FOLDER")
        yield Row(fault.title, found.trials, found.lost, told)


def by_chance(name: str, seconds: float) -> Row:
    """Damage the files of a reader by chance for so long."""
    rng = random.Random(name)
    until = time.monotonic() + seconds
    trials, refused, broken = 0, 0, ""
    while time.monotonic() < until:
        try:
            said = try_out(READERS[name], lambda content: edited(content, chance(rng)))
        except Exception as error:  # noqa: BLE001  # whatever leaves a reader is what is looked for
            broken = f"{type(error).__name__}: {error}"
            return Row(name, trials + 1, 1, broken)
        trials += len(said)
        refused += sum(map(bool, said))
    return Row(name, trials, 0, f"{refused} refused in words, the others read")


def by_coverage(name: str, seconds: int) -> Row:
    """The same, guided by which lines a file has reached."""
    command = [sys.executable, "-m", "tests.reliability.coverage_guided", name, str(seconds)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    lines = done.stderr.splitlines()
    count = [line.rpartition(" ")[2] for line in lines if "number_of_executed_units" in line]
    reached = [part for line in lines if "DONE" in line for part in line.split()]
    places = reached[reached.index("cov:") + 1] if "cov:" in reached else "?"
    if done.returncode or not count:
        errors = [line for line in done.stdout.splitlines() + lines if "Error" in line]
        return Row(
            f"{name}, by coverage",
            int(count[0]) if count else 0,
            1,
            errors[0] if errors else "ended",
        )
    return Row(
        f"{name}, by coverage", int(count[0]), 0, f"{places} branches of the sources reached"
    )


def readers(names: Sequence[str], long: bool) -> Iterator[Row]:
    """Search the readers."""
    guided = importlib.util.find_spec("atheris") is not None
    for name in names:
        yield by_chance(name, _LONG_S if long else 0.3)
        if long and guided and not name.startswith(_FRAMES):
            yield by_coverage(name, _GUIDED_S)
    if long and guided and any(name.startswith(_FRAMES) for name in names):
        yield by_coverage(_FRAMES, 3 * _GUIDED_S)


def _names(word: str) -> list[str]:
    """Names of the rows of a table, in its order; a row of another name is one of old."""
    if word == "faults":
        return [fault.title for fault in FAULTS.values()]
    known = [*READERS, _FRAMES]
    return [name for reader in known for name in (reader, f"{reader}, by coverage")]


def kept(word: str, head: str, row: Row) -> None:
    """Put a row into its table on the page, in the place of the one that stood there before."""
    text = PAGE.read_text("utf-8")
    before, begin, rest = text.partition(BEGIN.format(word))
    table, end, after = rest.partition(END.format(word))
    when = datetime.now(UTC).date().isoformat()
    system = f"{platform.system()}, Python {platform.python_version()}, {os.cpu_count()} cores"
    lines = {line.split(" | ")[0]: line for line in table.splitlines()[_HEAD_LINES:]}
    new = row.cells()
    lines[new.split(" | ")[0]] = new
    order = [f"| {name}" for name in _names(word)]
    rows = [lines[name] for name in order if name in lines]
    heads = ("", f"{when}, {system}:", "", head, "| --- | --- | --- | --- | --- |")
    whole = "\n".join([*heads, *rows, ""])
    write_text_atomic(PAGE, f"{before}{begin}{whole}{end}{after}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--table", choices=("faults", "readers", "both"), default="both")
    wanted = parser.parse_args()
    if sys.platform == "win32":
        print("the fault table needs Linux or macOS: it kills, stops and limits processes")
        return
    for word, head, unit, rows in (
        ("faults", "| fault | trials | lost | took, load | message |", "trials", faults),
        ("readers", "| reader | files | broken rules | took, load | how |", "files", readers),
    ):
        if wanted.table not in (word, "both"):
            continue
        known = FAULTS if word == "faults" else READERS
        names = [name for name in known if wanted.only in name]
        for row in timed(rows(names, wanted.long)):
            print(row.line(unit), flush=True)
            if wanted.long:
                kept(word, head, row)


if __name__ == "__main__":
    main()
