"""The launcher finds the program in a checkout and in an installed package."""

import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def version_from(folder: Path, *, cwd: Path) -> str:
    """What `calrig --version` says when `calrig` lies in `folder`."""
    program = (
        "import sys; sys.path.insert(0, sys.argv.pop(1));"
        "from calrig.__main__ import main; sys.exit(main())"
    )
    done = subprocess.run(
        [sys.executable, "-I", "-c", program, str(folder), "--version"],
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_a_checkout_is_used_from_any_folder(tmp_path: Path):
    assert version_from(ROOT, cwd=tmp_path).startswith("calrig ")


def test_an_installed_package_uses_its_private_folder(tmp_path: Path):
    site = tmp_path / "site packages"
    shutil.copytree(ROOT / "calrig", site / "calrig")
    private = site / "calrig" / "_app"
    for package in ("core", "drivers", "gui"):
        shutil.copytree(ROOT / package, private / package)
    (private / "core" / "version.py").write_text('VERSION = "installed"\n', encoding="utf-8")
    assert version_from(site, cwd=tmp_path) == "calrig installed\n"
