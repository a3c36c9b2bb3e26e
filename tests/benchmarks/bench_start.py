"""From the start of the process to the first painted window, against a bare label."""

import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[2]
LIMIT_S = 1.0
RUNS = 5

WINDOW = """
import sys
from pathlib import Path
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
from gui.app import Application, Options
qt = QApplication([])
folder = Path(sys.argv[1])
app = Application(qt, Options(root=folder, settings=folder / "settings.json", quiet=True))
app.window.show()
qt.processEvents()
assert app.window.isVisible()
loaded = sorted({name.partition(".")[0] for name in sys.modules} & {"scipy", "pyqtgraph"})
print(*loaded)
import os
os._exit(0)
"""
LABEL = """
import os
from PySide6.QtWidgets import QApplication, QLabel
qt = QApplication([])
label = QLabel("CalRig")
label.show()
qt.processEvents()
os._exit(0)
"""


def cpu_seconds(program: str) -> tuple[float, str]:
    """CPU time of a fresh interpreter that runs `program`, and what it printed."""
    with tempfile.TemporaryDirectory() as folder:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(
            [sys.executable, "-c", program, folder],
            cwd=ROOT,
            env={**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": str(ROOT)},
            capture_output=True,
            text=True,
            check=True,
        )
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return used, done.stdout.strip()


def main() -> int:
    """Print the rows; return the number of targets missed."""
    runs = [(cpu_seconds(WINDOW), cpu_seconds(LABEL)) for _ in range(RUNS)]
    window = statistics.median(one for (one, _), _ in runs)
    label = statistics.median(one for _, (one, _) in runs)
    heavy = runs[0][0][1] or "none"
    slow = window > LIMIT_S
    print(
        f"start to first painted window  {window:.2f} s CPU | bare label {label:.2f} s |"
        f" x{window / label:.1f} | target <= {LIMIT_S} s | {'MISSED' if slow else 'ok'}"
    )
    loaded = "scipy" in heavy
    print(
        f"scipy or pyqtgraph loaded by then  {heavy} | - | - | target no scipy |"
        f" {'MISSED' if loaded else 'ok'}"
    )
    return int(slow) + int(loaded)


if __name__ == "__main__":
    raise SystemExit(main())
