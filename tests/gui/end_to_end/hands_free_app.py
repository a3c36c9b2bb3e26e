"""The program in a process of its own, hands-free at a port, until somebody ends it.

``python hands_free_app.py PORT FOLDER``; the test turns the head and kills this process.
"""

import sys
from pathlib import Path

from PySide6.QtWidgets import QApplication

from gui.app import Application, Options
from gui.devices.setup import DeviceSetup
from gui.dividing_head.tab import HeadTab


def main(port: str, folder: Path) -> int:
    """Open the window, connect, go hands-free."""
    qt = QApplication(sys.argv[:1])
    app = Application(qt, Options(root=folder, settings=folder / "set.json", quiet=True))

    def begin() -> None:
        tab = app.tabs["Dividing head"]
        if not isinstance(tab, HeadTab):
            raise TypeError("the first tab is not the dividing head's")
        app.connection.open([DeviceSetup(port, 115200, "pw09_raw", "PW09")])
        tab.presenter.set_hands_free(True)

    app.ready.connect(begin)
    app.start()
    return qt.exec()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], Path(sys.argv[2])))
