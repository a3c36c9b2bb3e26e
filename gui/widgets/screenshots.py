"""Pictures of widgets for the documentation."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QEvent, QSize
from PySide6.QtWidgets import QApplication, QWidget

from gui.widgets.colours import THEMES
from gui.widgets.theme import apply_theme


def save_pictures(
    app: QApplication, make: Callable[[], QWidget], folder: Path, name: str, size: QSize
) -> list[Path]:
    """Draw a widget in every look and save it as ``NAME-LOOK.png``.

    Parameters
    ----------
    make : builds the widget, filled as it shall be seen
    size : of the widget, in device-independent pixels

    Returns
    -------
    list of Path
        The files written.

    Raises
    ------
    OSError
        A file could not be written.
    """
    written: list[Path] = []
    for look in THEMES:
        apply_theme(app, look)
        widget = make()
        widget.resize(size)
        widget.show()
        app.processEvents()
        path = folder / f"{name}-{look}.png"
        if not widget.grab().save(str(path)):
            raise OSError(f"{path}: the picture could not be written")
        written.append(path)
        widget.close()
        widget.deleteLater()
        app.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    return written
