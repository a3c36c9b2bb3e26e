"""Any record file -> `Series`: what the Allan tab and ``calrig allan`` read."""

from collections.abc import Sequence
from pathlib import Path
from typing import overload

from core.arrays import FloatArray
from core.errors import FormatError, Note, Severity
from core.records.cvgcom import is_cvgcom
from core.records.series import Series, distinct
from core.records.series_text import read_text_series
from drivers.recording import Recording
from drivers.records import is_recording, open_record


def read_series(path: Path) -> Series:
    """Read a record of any kind, recognised by what it holds.

    Raises
    ------
    FormatError
        It cannot be read as a record; with the place where that is known.
    """
    if is_recording(path) or is_cvgcom(path):
        return of_recording(open_record(path))
    return read_text_series(path)


def of_recording(recording: Recording) -> Series:
    """Return a recording, or a raw log whose bytes were decoded, as a series.

    Raises
    ------
    FormatError
        It holds no samples.
    """
    if not len(recording):
        raise FormatError(recording.path, "holds no samples yet")
    stated = recording.settings.get("scale_factor")
    notes = list(recording.notes)
    if not recording.ended:
        text = "the record was not ended in order; what stands in it is whole"
        notes.append(Note(Severity.INFO, "open_end", text))
    return Series(
        path=str(recording.path),
        device=recording.device or recording.path.stem,
        channels=distinct(recording.channels),
        columns=_Columns(recording),
        n=len(recording),
        rate=recording.rate,
        index=recording.index() if recording.gaps else None,
        scale_factor=float(stated) if isinstance(stated, int | float) else float("nan"),
        notes=tuple(notes),
    )


class _Columns(Sequence[FloatArray]):
    """The columns of a recording, each read when it is asked for: a day of eleven is gigabytes."""

    def __init__(self, recording: Recording) -> None:
        self._recording = recording

    def __len__(self) -> int:
        return len(self._recording.channels)

    @overload
    def __getitem__(self, place: int) -> FloatArray: ...
    @overload
    def __getitem__(self, place: slice) -> Sequence[FloatArray]: ...
    def __getitem__(self, place: int | slice) -> FloatArray | Sequence[FloatArray]:
        if isinstance(place, slice):
            return [self._recording.column(one) for one in range(len(self))[place]]
        return self._recording.column(range(len(self))[place])
