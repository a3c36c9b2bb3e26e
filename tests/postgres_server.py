"""A throw-away PostgreSQL server for tests, from the programs of Debian's package."""

import getpass
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

PACKAGE = "postgresql"


class PostgresServer:
    """A cluster in a temporary folder that listens on a socket in it, and nowhere else."""

    def __init__(self) -> None:
        self._programs = programs()
        # Not pytest's folder: the server refuses to run as root, and its user must get there.
        self.folder = Path(tempfile.mkdtemp(prefix="calrig-pg-"))
        self._user = "postgres" if os.geteuid() == 0 else getpass.getuser()
        if os.geteuid() == 0:
            shutil.chown(self.folder, self._user)
        data = str(self.folder / "data")
        self._run("initdb", "-D", data, "-U", "calrig", "-A", "trust", "-E", "UTF8", "--no-sync")
        options = f"-k {self.folder} -c listen_addresses='' -c fsync=off"
        self._run("pg_ctl", "-D", data, "-w", "-o", options, "-l", f"{data}/log", "start")
        self._number = 0

    def url(self) -> str:
        """URL of a new, empty database."""
        self._number += 1
        name = f"rig{self._number}"
        self._run("createdb", "-h", str(self.folder), "-U", "calrig", name)
        return f"postgresql://calrig@/{name}?host={self.folder}"

    def stop(self) -> None:
        """End the server and take its folder away."""
        self._run("pg_ctl", "-D", str(self.folder / "data"), "-m", "immediate", "stop")
        shutil.rmtree(self.folder)

    def _run(self, program: str, *arguments: str) -> None:
        other = {"user": self._user} if os.geteuid() == 0 else {}
        done = subprocess.run(
            [str(self._programs / program), *arguments],
            cwd="/",
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE if program != "pg_ctl" else subprocess.DEVNULL,
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
            **other,
        )
        if done.returncode != 0:
            raise OSError(f"{program}: {done.stdout or done.returncode}")


def programs() -> Path:
    """The folder of the server's programs; newest version first."""
    places = sorted(Path("/usr/lib/postgresql").glob("*/bin"), key=_version, reverse=True)
    on_path = shutil.which("initdb")
    if on_path is not None:
        places.append(Path(on_path).resolve().parent)
    if not places:
        raise OSError(
            "the tests of the archive start a PostgreSQL server, and there is none here:"
            f" apt-get install {PACKAGE} (python3 bootstrap.py test does it)"
        )
    return places[0]


def _version(place: Path) -> float:
    try:
        return float(place.parent.name)
    except ValueError:
        return 0.0
