"""What the program tells the operator: one banner at a time, and a log of everything."""

from datetime import datetime

from PySide6.QtCore import QObject, Signal

from core.errors import FormatError, LabError, LinkError, Severity, StorageError
from gui.widgets.states import BannerAction, BannerState, LogEntry

_REMEDIES: dict[type[LabError], str] = {
    FormatError: "Nothing was changed. Choose another file, or correct the place that is named.",
    StorageError: "Make room there, or choose another folder; then try again.",
}
"""What to do about errors that do not tell it themselves."""
_RANK = {Severity.INFO: 0, Severity.WARNING: 1, Severity.ERROR: 2}


class Messages(QObject):
    """Collects the banners of all parts of the program and shows the most urgent one.

    Each source has one banner at most: a new one replaces its old one, since it tells the newer
    truth about the same thing.
    """

    shown = Signal(object)
    """`BannerState` to show, or None."""
    logged = Signal(object)
    """`LogEntry`."""
    action = Signal(str, str)
    """Source of the banner and key of the button that was pressed."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._banners: dict[str, BannerState] = {}

    @property
    def current(self) -> BannerState | None:
        """The banner on the screen."""
        source = self._most_urgent()
        return None if source is None else self._banners[source]

    def show(self, source: str, banner: BannerState) -> None:
        """Show a banner, and log it."""
        if self._banners.get(source) == banner:
            return
        self._banners.pop(source, None)
        self._banners[source] = banner
        words = " ".join(part for part in (banner.meaning, banner.remedy) if part)
        end = "" if banner.what.endswith(("?", "!", ".")) else "."
        self.log(banner.severity, f"{banner.what}{end} {words}" if words else banner.what, source)
        self.shown.emit(self.current)

    def tell_error(
        self, source: str, what: str, error: LabError, *actions: BannerAction, remedy: str = ""
    ) -> None:
        """Show what failed, with the words of the error and what to do.

        Parameters
        ----------
        source, what, error : whose banner, what could not be done, and why
        actions : buttons
        remedy : what to do; empty for what the link says, or what fits all errors of the kind
        """
        if isinstance(error, LinkError):
            banner = BannerState(
                Severity.ERROR,
                f"{what}: {error.port}",
                _sentence(error.why),
                remedy or _sentence(error.remedy),
                tuple(actions),
            )
        else:
            remedy = remedy or next(
                (text for kind, text in _REMEDIES.items() if isinstance(error, kind)), ""
            )
            banner = BannerState(Severity.ERROR, what, f"{error}.", remedy, tuple(actions))
        self.show(source, banner)

    def clear(self, source: str) -> None:
        """Take a source's banner away, since what it told is over."""
        if self._banners.pop(source, None) is not None:
            self.shown.emit(self.current)

    def dismiss(self) -> None:
        """The operator closed the banner on the screen."""
        source = self._most_urgent()
        if source is not None:
            self.clear(source)

    def press(self, key: str) -> None:
        """A button of the banner on the screen was pressed."""
        source = self._most_urgent()
        if source is not None:
            self.action.emit(source, key)

    def log(self, severity: Severity, text: str, source: str = "") -> None:
        """Write a line into the log."""
        self.logged.emit(LogEntry(datetime.now().astimezone(), severity, text, source))

    def _most_urgent(self) -> str | None:
        """Source of the most severe banner, the newest among equals."""
        best: str | None = None
        for source, banner in self._banners.items():
            if best is None or _RANK[banner.severity] >= _RANK[self._banners[best].severity]:
                best = source
        return best


def _sentence(text: str) -> str:
    """The text with a capital at its beginning and a stop at its end."""
    text = text.strip()
    if not text:
        return ""
    return text[0].upper() + text[1:] + ("" if text[-1] in ".!?" else ".")
