"""Put the program on the path and start it: ``calrig`` or ``python -m calrig``.

In a checkout the program stands beside this package; in an installed one it is the private
folder ``_app``, so that nothing called ``core`` or ``gui`` lies open in site-packages.
"""

import os
import sys
from pathlib import Path


def main() -> int:
    """Start CalRig with the arguments of the command line and return its exit code."""
    here = Path(__file__).resolve().parent
    installed = here / "_app"
    sys.path.insert(0, str(installed if installed.is_dir() else here.parent))
    # Our matrices are small: threads of the linear algebra only wait for each other (a comparison
    # of model and data took nine times as long) and take cores from the readers of the ports.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

    from gui.main import main as start

    return start(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
