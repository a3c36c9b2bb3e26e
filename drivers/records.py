"""Records of both kinds, recordings and CVGCom's text files, opened alike."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from core.errors import FormatError
from core.records.cvgcom import is_cvgcom, read_cvgcom
from core.records.cvgcom_name import CvgcomName
from core.records.means import RecordMean, mean_of
from drivers.framing import MAGIC
from drivers.rawlog import EVENT, event_of, rawlog_header
from drivers.recording import SUFFIX, Recording, Stretch, read_recording

_TAIL = 4096


def open_record(path: Path) -> Recording:
    """Open a recording or a text file of CVGCom.

    Raises
    ------
    FormatError
        It is neither, or is damaged.
    """
    if not is_cvgcom(path):
        return read_recording(path)
    file = read_cvgcom(path)
    came = ~np.isnan(file.data).any(axis=1)
    edges = np.flatnonzero(np.diff(came.astype(np.int8), prepend=0, append=0)).tolist()
    stretches = [
        Stretch(start, file.data[start:stop])
        for start, stop in zip(edges[0::2], edges[1::2], strict=True)
    ]
    header: dict[str, object] = {
        "device": file.name.device if file.name else "",
        "settings": {"scale_factor": file.head.scale_factor},
    }
    return Recording(
        path, header, file.head.channels, file.head.rate, tuple(stretches), notes=file.notes
    )


def is_recording(path: Path) -> bool:
    """Whether a file begins as recordings and raw logs do.

    Raises
    ------
    FormatError
        It cannot be read.
    """
    try:
        with path.open("rb") as file:
            return file.read(len(MAGIC)) == MAGIC
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or str(error)
        raise FormatError(path, f"cannot be read: {why}") from error


def was_ended(path: Path) -> bool:
    """Whether a recording was ended in order; told by its last block, without reading the rest.

    Raises
    ------
    FormatError
        It cannot be read, or is no raw log.
    """
    rawlog_header(path)
    try:
        with path.open("rb") as file:
            file.seek(max(0, path.stat().st_size - _TAIL))
            tail = file.read()
    except OSError as error:
        raise FormatError(path, f"cannot be read: {error.strerror}") from error
    _, tag, last = tail.rpartition(EVENT)
    # The tag is followed by length and check sum.
    mark = event_of(last[8:]) if tag else None
    return mark is not None and mark.kind == "ended"


def records_in(folder: Path) -> list[Path]:
    """Records of a folder in the order of their experiments; of twins only the recording.

    Raises
    ------
    FormatError
        The folder cannot be read, or holds no records.
    """
    try:
        files = sorted(folder.iterdir())
    except OSError as error:
        raise FormatError(folder, f"cannot be read: {error.strerror}") from error
    recorded = {path.stem for path in files if path.suffix == SUFFIX}
    found = [
        path
        for path in files
        if path.suffix == SUFFIX or (path.stem not in recorded and is_cvgcom(path))
    ]
    if not found:
        raise FormatError(folder, "holds no records of CVGCom and no recordings")
    return sorted(found, key=_experiment)


def record_means(
    record: Recording, intervals: Sequence[tuple[float, float] | None] = (None,)
) -> list[RecordMean]:
    """Means of intervals of a record, s from its first sample; None is the whole of it."""
    index, data = record.samples()
    return [
        mean_of(record.path.name, record.channels, index, data, record.rate, part)
        for part in intervals
    ]


def _experiment(path: Path) -> tuple[int, str]:
    name = CvgcomName.parse(path.name)
    return (0 if name is None else name.experiment, path.name)
