import subprocess
import sys

import pytest

PROGRAM = """
import os, sys
os.environ["QT_QPA_PLATFORM"] = "offscreen"
from gui.widgets.override_guard import guard_overrides
guard_overrides()
guard_overrides()
from PySide6.QtCore import QAbstractListModel, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QListView, QWidget

class Broken(QWidget):
    def keyPressEvent(self, event):
        {error}
    def paintEvent(self, event):
        {error}
    def sizeHint(self):
        return super().sizeHint()

class Rows(QAbstractListModel):
    def rowCount(self, parent):
        return 3
    def data(self, index, role=0):
        {error}

seen = set()
sys.excepthook = lambda kind, error, trace: seen.add(kind.__name__)

def attempt(call, *args):
    # Under a call from Python the error comes back through that call.
    try:
        call(*args)
    except Exception as error:
        seen.add(type(error).__name__)

app = QApplication([])
window, view = Broken(), QListView()
rows = Rows(view)
attempt(window.show)
attempt(view.setModel, rows)
attempt(view.show)
for _ in range(3):
    attempt(QTest.keyClick, window, Qt.Key.Key_C)
    attempt(app.processEvents)
print("alive", sorted(seen), flush=True)
os._exit(0)
"""


@pytest.mark.parametrize(
    ("error", "kind"),
    [
        ("1 / 0", "ZeroDivisionError"),
        ("float('x')", "ValueError"),
        ("[][0]", "IndexError"),
        ("raise KeyError(3)", "KeyError"),
    ],
)
def test_an_error_in_a_method_that_qt_calls_does_not_end_the_program(error, kind):
    program = PROGRAM.format(error=error)
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0, done.stderr[-500:]
    assert f"alive ['{kind}']" in done.stdout
