"""What the first window needs must come up fast."""

import subprocess
import sys

SLOW = ("pyqtgraph", "scipy", "pandas", "matplotlib")
FIRST = (
    "theme",
    "stage",
    "step_list",
    "action_bar",
    "banner",
    "device_strip",
    "log_drawer",
    "result_table",
    "strip_charts",
    "sound",
)


def test_the_widgets_of_the_first_window_import_nothing_slow():
    imports = "".join(f"import gui.widgets.{name}\n" for name in FIRST)
    code = f"{imports}import sys\nprint(*[m for m in {SLOW!r} if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout.strip() == ""


def test_states_know_no_widgets():
    code = "import gui.widgets.states, sys\nprint('PySide6.QtWidgets' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout.strip() == "False"
