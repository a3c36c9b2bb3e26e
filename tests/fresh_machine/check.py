"""Set CalRig up on a machine that has nothing, and see its demonstration work.

    sudo python3 tests/fresh_machine/check.py [--suite bookworm] [--keep FOLDER]

The machine is a minimal Debian root without Qt's libraries, made by debootstrap. This checkout's
committed files are put there and `python3 bootstrap.py run` is started as a user would start it;
then the bundle of `python3 bootstrap.py bundle`, if there is one, in a second root without Python.
Needs root, debootstrap and the archives that this machine uses. Not one of the tests of
`bootstrap.py test`: it takes minutes and fetches half a gigabyte.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MIRROR = "http://deb.debian.org/debian"
INHERITED = (
    # How this machine reaches its package archives.
    "etc/apt/apt.conf.d",
    "etc/pip.conf",
    "root/.config/pip",
    "etc/ssl/certs/ca-certificates.crt",
    "etc/resolv.conf",
    "etc/hosts",
)
LIBRARIES = [
    *("libglib2.0-0", "libgl1", "libegl1"),
    *("libdbus-1-3", "libfontconfig1", "libxkbcommon0"),
]
"""What the README names for a machine without a screen."""


class Machine:
    """A Debian root in a folder.

    Parameters
    ----------
    folder : where it is made
    suite : Debian's release, e.g. ``"bookworm"``
    packages : what it has beyond the minimum
    """

    def __init__(self, folder: Path, suite: str, packages: list[str]) -> None:
        self.folder = folder
        command = ["debootstrap", "--variant=minbase", f"--include={','.join(packages)}"]
        run([*command, suite, str(folder), MIRROR])
        for name in INHERITED:
            source, target = Path("/") / name, folder / name
            if source.is_dir():
                shutil.copytree(source, target, dirs_exist_ok=True, symlinks=False)
            elif source.exists():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, target)

    def call(self, command: list[str], where: str) -> None:
        """Run a command in the machine, from a folder of it."""
        inside = f"cd {where} && exec {' '.join(command)}"
        environ = {
            "PATH": "/usr/sbin:/usr/bin:/sbin:/bin",
            "HOME": "/root",
            "LANG": "C.UTF-8",
            **{name: value for name, value in os.environ.items() if name.startswith("PIP_")},
        }
        mount = ["unshare", "--mount", "--pid", "--fork", f"--mount-proc={self.folder}/proc"]
        run([*mount, "chroot", str(self.folder), "sh", "-c", inside], environ)


def from_the_sources(folder: Path, suite: str) -> None:
    """The two commands of the README, on a machine that has Python alone."""
    machine = Machine(folder, suite, ["python3", "python3-venv", "ca-certificates"])
    project = folder / "calrig"
    project.mkdir()
    archive = folder / "calrig.tar"
    run(["git", "-C", str(ROOT), "archive", f"--output={archive}", "HEAD"])
    run(["tar", "-xf", str(archive), "-C", str(project)])
    machine.call(["python3", "bootstrap.py", "run"], "/calrig")
    found = sorted(path.name for path in (project / "demo-output").rglob("*.png"))
    if not found:
        sys.exit("the demonstration left no pictures")
    print(f"pictures: {', '.join(found)}")


def from_the_bundle(folder: Path, suite: str, bundle: Path) -> None:
    """The built folder, on a machine that has no Python and the stated libraries alone."""
    machine = Machine(folder, suite, LIBRARIES)
    if (folder / "usr/bin/python3").exists():
        sys.exit("the machine has a Python; the bundle would prove nothing")
    shutil.copytree(bundle, folder / "opt" / "calrig", symlinks=True)
    machine.call(["/opt/calrig/calrig", "demo", "--part", "head", "--out", "demo"], "/srv")


def run(command: list[str], environ: dict[str, str] | None = None) -> None:
    """Run a command and stop where it fails."""
    print("+", " ".join(command), flush=True)
    code = subprocess.call(command, env=environ)
    if code:
        sys.exit(f"{command[0]} ended with {code}")


def main() -> None:
    """Check what the command line asks for."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--suite", default="bookworm", help="Debian's release")
    parser.add_argument("--keep", type=Path, help="folder for the machines, which are then kept")
    options = parser.parse_args()
    if os.geteuid() != 0 or shutil.which("debootstrap") is None:
        sys.exit("This needs root and debootstrap: apt-get install debootstrap")
    folder: Path = options.keep or Path(tempfile.mkdtemp(prefix="fresh-"))
    folder.mkdir(parents=True, exist_ok=True)
    try:
        began = time.monotonic()
        from_the_sources(folder / "sources", options.suite)
        print(f"ok: the sources, {time.monotonic() - began:.0f} s")
        bundle = ROOT / "dist" / "calrig"
        if bundle.is_dir():
            began = time.monotonic()
            from_the_bundle(folder / "bundle", options.suite, bundle)
            print(f"ok: the bundle, {time.monotonic() - began:.0f} s")
        else:
            print("no bundle in dist/calrig: python3 bootstrap.py bundle makes one")
    finally:
        if options.keep is None:
            shutil.rmtree(folder)


if __name__ == "__main__":
    main()
