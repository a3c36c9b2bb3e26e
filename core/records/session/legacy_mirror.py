"""The legacy text beside the journal: always the rows that count.

It follows from the journal, so that nothing is lost when it cannot be written; it is then made
anew at the next change.
"""

from datetime import datetime
from pathlib import Path

from core.errors import FormatError, LabError, Note, Severity, StorageError
from core.records.atomic import write_text_atomic
from core.records.legacy.layout import LEGACY_FORMATS
from core.records.legacy.writer import append_row, legacy_rows, legacy_text
from core.records.names import stamp
from core.records.session.record import JOURNAL_NAME, SessionRecord
from core.records.session.start import SessionStart
from core.records.text import read_bytes


class LegacyMirror:
    """Writes the legacy text of one session.

    Parameters
    ----------
    folder : the session's
    start : its start document; names the layout, or none
    """

    def __init__(self, folder: Path, start: SessionStart) -> None:
        self._folder = folder
        self._layout = LEGACY_FORMATS.get(start.legacy)
        self.path: Path | None = None
        """The file, None if the session writes none."""
        self.error: StorageError | None = None
        """Why the file is behind the journal; None while it holds the rows that count."""
        if self._layout is not None:
            started = stamp(datetime.fromisoformat(start.started))
            self.path = folder / f"{self._layout.stem}_{started}.txt"

    def append(self, record: SessionRecord) -> None:
        """Add the row of the newest position; make the file anew if it was left behind before."""
        if self.path is None or self._layout is None:
            return
        if self.error is not None or not self.path.exists():
            self.rewrite(record)
            return
        try:
            last = record.run().rows([len(record.positions) - 1])
            append_row(self.path, legacy_rows(last, self._layout))
        except (FormatError, StorageError) as error:
            self.error = self._left_behind(error)

    def rewrite(self, record: SessionRecord) -> None:
        """Make the file anew from the positions that count."""
        if self.path is None:
            return
        self.error = None
        if not record.positions and not self.path.exists():
            return
        try:
            write_text_atomic(self.path, self._text(record))
        except (FormatError, StorageError) as error:
            self.error = self._left_behind(error)

    def check(self, record: SessionRecord, when: str) -> Note | None:
        """Make the file anew if a crash left it behind the journal.

        A file that holds something else is kept under another name, which the note tells; `when`
        becomes a part of it.
        """
        if self.path is None or not self.path.exists():
            self.rewrite(record)
            return None
        try:
            wanted = self._text(record).encode()
            found = read_bytes(self.path)
        except FormatError as error:
            self.error = self._left_behind(error)
            return None
        if found == wanted:
            return None
        note = None
        if not wanted.startswith(found):
            kept = self.path.with_name(f"{self.path.stem}.{when}.kept")
            try:
                self.path.replace(kept)
            except OSError as error:
                self.error = self._left_behind(StorageError(str(error)))
                return None
            note = Note(
                Severity.WARNING,
                "legacy_differs",
                f"{self.path}: did not hold the rows of the journal and was made anew; the file as"
                f" it was found is {kept.name}",
            )
        self.rewrite(record)
        return note

    def _text(self, record: SessionRecord) -> str:
        if self._layout is None or not record.positions:
            return ""
        return legacy_text(record.run(), self._layout)

    def _left_behind(self, error: LabError) -> StorageError:
        return StorageError(
            f"every position is stored in {self._folder / JOURNAL_NAME}, but the text file for the"
            f" old programs could not follow: {error}; it is made anew at the next change"
        )
