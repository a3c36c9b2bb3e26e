"""What must not be lost whatever happens: faults of the program, and orders of the system."""

import signal
import sys
import traceback
from types import TracebackType

from PySide6.QtCore import QTimer

from core.errors import Severity
from gui.main_window import MainWindow
from gui.messages import Messages
from gui.widgets.states import BannerState

_AWAKE_MS = 300


def hook_errors(messages: Messages) -> None:
    """A fault of the program is told and logged; the program goes on, since data are at stake."""

    def tell(kind: type[BaseException], fault: BaseException, trace: TracebackType | None) -> None:
        text = "".join(traceback.format_exception(kind, fault, trace))
        sys.stderr.write(text)
        messages.show(
            "program",
            BannerState(
                Severity.ERROR,
                "A fault inside the program",
                f"{kind.__name__}: {fault}. What was accepted is on the disk.",
                "Go on; if something behaves oddly, start the program anew and resume.",
            ),
        )
        messages.log(Severity.ERROR, text, "program")

    sys.excepthook = tell


def hook_signals(window: MainWindow) -> None:
    """Ctrl+C in the console and a polite end by the system close the window in order."""

    def end(*_: object) -> None:
        window.close()

    for name in ("SIGINT", "SIGTERM"):
        signal.signal(getattr(signal, name), end)
    # Python handles signals between its own instructions: give it some now and then.
    awake = QTimer(window)
    awake.timeout.connect(lambda: None)
    awake.start(_AWAKE_MS)
