"""Raw logs for the archive: what their header tells, and their bytes decoded again; no Qt."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from core.archive.entry import Entry, Found
from core.archive.reading import Reader, moment
from core.errors import FormatError
from core.samples.block import SampleBlock
from drivers.decoders import make_decoder
from drivers.profile import Profile, parse_profile
from drivers.rawlog import Chunk, rawlog_header, read_rawlog
from drivers.recording import SUFFIX


def read_raw_entry(path: Path) -> tuple[Found, ...]:
    """A raw log or a recording, by its header: hours of samples are not read for a list."""
    header = rawlog_header(path)
    entry = Entry(
        kind="record",
        path="",
        serial=str(header.get("device", "")) or path.stem,
        what=str(header.get("content", "")),
        profile=str(header.get("profile", "")),
        measured=moment(str(header.get("started_utc", ""))),
    )
    return (Found(entry),)


RAW_READERS: Mapping[str, Reader] = {SUFFIX: read_raw_entry}


class TodaysDecoder:
    """Decodes raw logs with the decoders of this program; each file once.

    Parameters
    ----------
    profiles : today's device files by id, to be used instead of the text in the log; empty to use
        the text that was in force when it was recorded
    """

    def __init__(self, profiles: Mapping[str, Profile] | None = None) -> None:
        self._profiles = profiles or {}
        self._path: Path | None = None
        self._blocks: tuple[SampleBlock, ...] = ()

    def __call__(self, path: Path) -> Sequence[SampleBlock]:
        """Return all samples of a log, numbered as they were when it was recorded."""
        if path != self._path:
            self._path, self._blocks = path, ()
            self._blocks = self._decode(path)
        return self._blocks

    def _decode(self, path: Path) -> tuple[SampleBlock, ...]:
        decoder = make_decoder(self._profile(path))
        events = [
            event
            for part in read_rawlog(path)
            if isinstance(part, Chunk)
            for event in decoder.feed(part.data)
        ]
        events += decoder.flush()
        return tuple(event for event in events if isinstance(event, SampleBlock))

    def _profile(self, path: Path) -> Profile:
        header = rawlog_header(path)
        today = self._profiles.get(str(header.get("profile", "")))
        if today is not None:
            return today
        text = header.get("profile_text")
        if not isinstance(text, str) or not text:
            raise FormatError(path, "holds no device file by which its bytes could be read")
        return parse_profile(text, f"{path}: profile")
