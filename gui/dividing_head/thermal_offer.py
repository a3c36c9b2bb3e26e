"""After a temperature cycle: the way to the tab that joins its temperatures."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject

from core.errors import Severity
from gui.messages import Messages
from gui.widgets.states import BannerAction, BannerState

SOURCE = "dividing_head thermal"
_OPEN = "open"
_TAB = "Thermal"


class ThermalOffer(QObject):
    """Offers a session of several temperatures to the Thermal tab, once a session.

    Parameters
    ----------
    messages : where it is offered
    open_file : hands a folder to the tab of a title
    """

    def __init__(
        self, messages: Messages, open_file: Callable[[str, Path], bool], parent: QObject
    ) -> None:
        super().__init__(parent)
        self._messages = messages
        self._open_file = open_file
        self._folder: Path | None = None
        messages.action.connect(self._on_action)

    def offer(self, folder: Path, temperatures: int) -> None:
        """A session with so many temperatures was processed."""
        if temperatures < 2 or folder == self._folder:
            return
        self._folder = folder
        what = QCoreApplication.translate(
            "ThermalOffer", "The session went through {count} temperatures"
        )
        self._messages.show(
            SOURCE,
            BannerState(
                Severity.INFO,
                what.format(count=temperatures),
                QCoreApplication.translate(
                    "ThermalOffer",
                    "Process Data takes one temperature at a time; the Thermal tab takes them"
                    " together: bias and scale factor against temperature, hysteresis.",
                ),
                "",
                (
                    BannerAction(
                        _OPEN, QCoreApplication.translate("ThermalOffer", "Open in Thermal")
                    ),
                ),
            ),
        )

    def _on_action(self, source: str, key: str) -> None:
        if source == SOURCE and key == _OPEN and self._folder is not None:
            self._messages.clear(SOURCE)
            self._open_file(_TAB, self._folder)
