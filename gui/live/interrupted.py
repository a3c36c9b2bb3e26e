"""Records that a crash or a power cut interrupted: told of once, at the start of the program."""

import time
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, Signal

from core.errors import FormatError, LabError, Severity
from core.records.cvgcom_name import FOLDER
from drivers.recording import SUFFIX
from drivers.records import was_ended
from gui.jobs import Jobs
from gui.messages import Messages
from gui.settings import Settings
from gui.widgets.states import BannerAction, BannerState

SOURCE = "interrupted record"
SECTION = "interrupted records"
OPEN, LEAVE = "open", "leave"
_QUIET_S = 10.0
"""A file that was written to since is being recorded, by another window."""


def _say(text: str) -> str:
    return QCoreApplication.translate("LiveInterrupted", text)


class Interrupted(QObject):
    """Offers to open the newest record that was not ended; each is told of once.

    Parameters
    ----------
    jobs : looks at the files
    messages : where it is told
    settings : remembers of which has been told; the records themselves are not touched
    """

    chosen = Signal(object)
    """Path of the record to open."""

    def __init__(
        self, jobs: Jobs, messages: Messages, settings: Settings, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._settings = settings
        self._jobs = jobs
        self._messages = messages
        self._found: list[Path] = []
        messages.action.connect(self._on_action)

    def look(self, root: Path) -> None:
        """Look for such records among those of all devices."""
        stored = self._settings.section(SECTION).get("told")
        told = {str(name) for name in stored} if isinstance(stored, list) else set[str]()
        self._jobs.start(
            "records", lambda: interrupted_in(root, told), self._on_found, self._on_failed
        )

    def _on_found(self, found: object) -> None:
        if not isinstance(found, list):
            raise TypeError(f"the search brought {type(found).__name__}")
        self._found = [path for path in found if isinstance(path, Path)]
        if not self._found:
            return
        newest, others = self._found[0], len(self._found) - 1
        more = _say(" So were {n} others.").format(n=others) if others else ""
        self._messages.show(
            SOURCE,
            BannerState(
                Severity.INFO,
                _say("A record was interrupted: {name}").format(name=newest.name),
                _say("The program or the computer stopped while it ran.{more}").format(more=more),
                _say("All up to about a second before stands in it; START begins the next record."),
                (BannerAction(OPEN, _say("Open it")), BannerAction(LEAVE, _say("Leave it"))),
            ),
        )

    def _on_action(self, source: str, key: str) -> None:
        if source != SOURCE or not self._found:
            return
        paths, self._found = self._found, []
        self._messages.clear(SOURCE)
        stored = self._settings.section(SECTION).get("told")
        before = [str(name) for name in stored] if isinstance(stored, list) else []
        told = [name for name in before if Path(name).exists()] + [str(path) for path in paths]
        self._settings.store(SECTION, {"told": told})
        if key == OPEN:
            self.chosen.emit(paths[0])

    def _on_failed(self, error: LabError) -> None:
        self._messages.log(Severity.WARNING, str(error), SOURCE)


def interrupted_in(root: Path, told: set[str]) -> list[Path]:
    """Records that were not ended, are not being written and not told of; the newest first."""
    now = time.time()
    found: list[tuple[float, Path]] = []
    for path in (root / FOLDER).glob(f"*/*{SUFFIX}"):
        if str(path) in told:
            continue
        try:
            changed = path.stat().st_mtime
            if now - changed > _QUIET_S and not was_ended(path):
                found.append((changed, path))
        except (OSError, FormatError):
            continue  # it went away meanwhile, or is none of ours
    return [path for _, path in sorted(found, reverse=True)]
