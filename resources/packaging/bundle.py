"""Build ``dist/calrig`` by PyInstaller, play the demonstration with it, and pack it.

Called by ``python3 bootstrap.py bundle [arguments of PyInstaller]``, which provides the packages.
"""

import os
import platform
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def main(arguments: list[str]) -> int:
    """Build, try, pack; return the exit code."""
    folder, work = ROOT / "dist", ROOT / "build"
    spec = Path(__file__).with_name("calrig.spec")
    build = ["-m", "PyInstaller", "--noconfirm", f"--distpath={folder}", f"--workpath={work}"]
    if subprocess.call([sys.executable, *build, *arguments, str(spec)]) != 0:
        return _stop("PyInstaller could not build the folder; its reason stands above.")
    program = folder / "calrig" / ("calrig-cli.exe" if os.name == "nt" else "calrig")
    with tempfile.TemporaryDirectory() as elsewhere:
        played = [program, "demo", "--part", "head", "--out", elsewhere]
        if subprocess.call(played, cwd=elsewhere) != 0:
            return _stop(f"{program} was built and does not work.")
    kind = "zip" if os.name == "nt" else "gztar"
    name = f"calrig-{platform.system()}-{platform.machine()}".lower()
    print(shutil.make_archive(str(folder / name), kind, folder, "calrig"))
    return 0


def _stop(why: str) -> int:
    print(why, file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
