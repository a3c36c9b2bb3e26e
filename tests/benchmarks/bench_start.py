"""From the start of the process to the painted window, the usable tab, all tabs."""

import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[2]
RUNS = 3
LIMITS_S = {"painted": 0.6, "usable": 1.0, "ready": 3.0}
MEANING = {
    "painted": "start to first painted window",
    "usable": "start to the first tab usable, port opening",
    "ready": "start to all twelve tabs, without a device that is drawn meanwhile",
}

WINDOW = """
import sys, time
from gui.widgets.override_guard import guard_overrides
guard_overrides()
from pathlib import Path
from PySide6.QtWidgets import QApplication
from gui.app import Application, Options
qt = QApplication([])
folder = Path(sys.argv[1])
app = Application(qt, Options(sys.argv[2], folder, folder / "settings.json", quiet=True))
def tell(name):
    loaded = sorted({name.partition(".")[0] for name in sys.modules} & {"scipy", "pyqtgraph"})
    print(name, time.process_time(), *loaded, flush=True)
def painted():
    tell("painted")
def usable():
    tell("usable")
def ready():
    tell("ready")
    import os
    os._exit(0)
app.window.painted.connect(painted)
app.usable.connect(usable)
app.ready.connect(ready)
app.start()
qt.exec()
"""
LABEL = """
import os
import time
from PySide6.QtWidgets import QApplication, QLabel
qt = QApplication([])
label = QLabel("CalRig")
label.show()
qt.processEvents()
print("painted", time.process_time(), flush=True)
os._exit(0)
"""


def cpu_seconds(program: str, device: str = "") -> dict[str, tuple[float, list[str]]]:
    """CPU time of a fresh interpreter at each of its marks, and the heavy packages by then."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [sys.executable, "-c", program, folder, device],
            cwd=ROOT,
            env={**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": str(ROOT)},
            capture_output=True,
            text=True,
            check=True,
            timeout=120,
        )
    lines = [line.split() for line in done.stdout.splitlines()]
    return {name: (float(seconds), loaded) for name, seconds, *loaded in lines}


def main() -> int:
    """Print the rows; return the number of targets missed."""
    runs = [{**cpu_seconds(WINDOW), **_first(cpu_seconds(WINDOW, "pointer"))} for _ in range(RUNS)]
    label = statistics.median(cpu_seconds(LABEL)["painted"][0] for _ in range(RUNS))
    missed = 0
    for name, limit in LIMITS_S.items():
        seconds = statistics.median(run[name][0] for run in runs)
        missed += seconds > limit
        print(
            f"{MEANING[name]}  {seconds:.2f} s CPU | bare label {label:.2f} s |"
            f" x{seconds / label:.1f} | target <= {limit} s | {_verdict(seconds <= limit)}"
        )
    loaded = runs[0]["usable"][1]
    print(
        f"scipy or pyqtgraph loaded when usable  {' '.join(loaded) or 'none'} | - | - |"
        f" target none | {_verdict(not loaded)}"
    )
    return missed + bool(loaded)


def _first(marks: dict[str, tuple[float, list[str]]]) -> dict[str, tuple[float, list[str]]]:
    """Those before the device is drawn."""
    return {name: marks[name] for name in ("painted", "usable")}


def _verdict(kept: bool) -> str:
    return "ok" if kept else "MISSED"


if __name__ == "__main__":
    raise SystemExit(main())
