"""The sheet of keys on the screen and on paper."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject

from core.errors import LabError, Severity
from gui.certificate.pdf import Paper
from gui.keys.key_html import sheet_sections, sheet_title
from gui.keys.sheet import KeySheet, sheet_of
from gui.keys.view import KeysView
from gui.main_window import MainWindow
from gui.messages import Messages
from gui.widgets.states import BannerState

FILE = "keys.pdf"


class Keys(QObject):
    """Opens the sheet by its menu and key, and writes it as PDF.

    Parameters
    ----------
    window : whose keys they are
    messages : where it is told where the PDF went
    folder : returns the folder of all sessions, where it goes
    """

    def __init__(self, window: MainWindow, messages: Messages, folder: Callable[[], Path]) -> None:
        super().__init__(window)
        self._window = window
        self._messages = messages
        self._folder = folder
        self.view = KeysView(window)
        self.view.print_requested.connect(self.save)
        window.menu.keys.triggered.connect(self.open)

    def open(self) -> None:
        """Show the keys as they are now."""
        self.view.render(self._sheet())
        self.view.open_sheet()

    def save(self) -> None:
        """Write the sheet beside the sessions."""
        path = self._folder() / FILE
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            Paper(sheet_sections(self._sheet()), sheet_title()).save(path)
        except (OSError, LabError) as error:
            banner = BannerState(
                Severity.ERROR,
                "The sheet of keys is not written",
                f"{error}.",
                "Make room there, or choose another folder of sessions in Preferences.",
            )
        else:
            banner = BannerState(
                Severity.INFO, "The sheet of keys is ready to be printed", f"{path}"
            )
        self._messages.show("keys", banner)

    def _sheet(self) -> KeySheet:
        return sheet_of(self._window, self._window.tabs)
