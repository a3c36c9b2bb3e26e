"""The program in a process of its own, hands-free at a port, until somebody ends it.

``python hands_free_app.py PORT FOLDER``; the test turns the head and kills this process.
"""

import sys
from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from gui.app import Application, Options
from gui.dividing_head.tab import HeadTab
from gui.devices.setup import DeviceSetup


def main(port: str, folder: Path) -> int:
    """Open the window, connect, go hands-free."""
    qt = QApplication(sys.argv[:1])
    app = Application(qt, Options(root=folder, settings=folder / "set.json", quiet=True))
    app.start()
    tab = app.tabs["Dividing head"]
    if not isinstance(tab, HeadTab):
        raise TypeError("the first tab is not the dividing head's")
    QTimer.singleShot(
        0, lambda: app.connection.open([DeviceSetup(port, 115200, "pw09_raw", "PW09")])
    )
    tab.presenter.set_hands_free(True)
    return qt.exec()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], Path(sys.argv[2])))
