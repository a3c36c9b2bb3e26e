"""Bring the translations up to the sources: ``python -m gui.languages.update``.

New texts are added as unfinished, texts that are gone are dropped, the rest stays as it is; what
lacks a translation is told for each language, with its place, and counted at the end. Then Qt's
``lrelease`` makes the ``.qm`` that the program loads. ``--check`` changes nothing and ends with 1
if something would have been changed.
"""

import argparse
import subprocess
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

import PySide6

from gui.languages.gui_texts import Sources, Text
from gui.languages.plain_texts import all_texts
from gui.languages.ts_file import Message, read_ts, ts_text, write_ts

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "resources" / "i18n"
FOLDERS = ("gui", "core", "drivers")


def ts_files() -> list[Path]:
    """The files of all languages that there are."""
    return sorted(FOLDER.glob("calrig_*.ts"))


def language_of(path: Path) -> str:
    """``calrig_uk.ts`` -> ``uk``."""
    return path.stem.removeprefix("calrig_")


def merged(texts: Iterable[Text], known: Sequence[Message]) -> list[Message]:
    """Return messages for all texts, with the translations that are known.

    A text that moved to another context, or came to a second one, keeps its words.
    """
    by_place = {(one.context, one.source): one.translation for one in known if one.translation}
    by_source = {one.source: one.translation for one in known if one.translation}
    return [
        Message(
            text.context,
            text.source,
            text.place,
            by_place.get((text.context, text.source)) or by_source.get(text.source, ""),
        )
        for text in texts
    ]


def release(path: Path, target: Path) -> None:
    """Make the ``.qm`` of a ``.ts``.

    Raises
    ------
    RuntimeError
        Qt's tool refused the file.
    """
    tool = Path(PySide6.__file__).parent / "lrelease"
    if not tool.exists():
        tool = tool.with_suffix(".exe")
    done = subprocess.run(
        [tool, "-silent", path, "-qm", target], capture_output=True, text=True, check=False
    )
    if done.returncode:
        raise RuntimeError(f"lrelease: {done.stdout}{done.stderr}")


def main(arguments: Sequence[str]) -> int:
    """Run the command; see the docstring of the module."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="change nothing, tell what would be")
    options = parser.parse_args(arguments)
    texts, complaints = all_texts(Sources(ROOT, FOLDERS))
    lines = [f"cannot be followed: {one}" for one in complaints]
    counts: list[str] = []
    changed = False
    for path in ts_files():
        language = language_of(path)
        messages = merged(texts, read_ts(path))
        missing = [m for m in messages if not m.translation]
        lines += [f"{language}: {m.place}: {m.source!r}" for m in missing]
        counts.append(f"{language}: {len(missing)} of {len(messages)} texts lack a translation")
        if ts_text(language, messages) != path.read_text(encoding="utf-8"):
            changed = True
            if not options.check:
                write_ts(path, language, messages)
        if not options.check:
            release(path, path.with_suffix(".qm"))
    sys.stdout.write("".join(f"{line}\n" for line in (*lines, *counts)))
    return int(bool(complaints) or (options.check and changed))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
