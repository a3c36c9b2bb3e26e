"""Set CalRig up beside itself and start it.

    python3 bootstrap.py run [--offscreen] [arguments of calrig]
    python3 bootstrap.py test [arguments of pytest]
    python3 bootstrap.py bench [words in a benchmark's file name]
    python3 bootstrap.py bundle [arguments of PyInstaller]

run    open the program on the simulated rig; without a screen (or with --offscreen) play the
       scripted demonstration instead, which writes its files and pictures into demo-output/
test   lint, type check, import rules and all tests
bench  the benchmarks; exit code 1 if one misses its target
bundle the program as a folder and an archive in dist/ that need no Python

The first start makes .venv and installs the packages of requirements.lock into it; later starts
only look at a stamp. Needs Python 3.11 or newer and nothing else.
"""

from __future__ import annotations  # an old Python must get as far as its clear message

import sys

try:
    import hashlib
    import importlib.util
    import os
    import platform
    import shutil
    import subprocess
    from pathlib import Path
    from typing import NamedTuple
except ImportError as gap:  # Debian's python3-minimal
    sys.exit(f"This Python lacks a part of its standard library ({gap}): apt-get install python3")

ROOT = Path(__file__).resolve().parent
OLDEST = (3, 11)
RUNTIME, DEVELOPMENT = "runtime", "development"
UNFINISHED = "installing"


class StopError(Exception):
    """Nothing more can be done without the user; the message says what to do."""


class Library(NamedTuple):
    """A system library that Qt loads: its soname and the Debian package that brings it."""

    soname: str
    package: str
    renamed: str = ""
    """The package's name since Debian 13 and Ubuntu 24.04, where it changed."""


ALWAYS = (
    Library("libglib-2.0.so.0", "libglib2.0-0", "libglib2.0-0t64"),
    Library("libgthread-2.0.so.0", "libglib2.0-0", "libglib2.0-0t64"),
    Library("libGL.so.1", "libgl1"),
    Library("libEGL.so.1", "libegl1"),
    Library("libdbus-1.so.3", "libdbus-1-3"),
    Library("libfontconfig.so.1", "libfontconfig1"),
    Library("libxkbcommon.so.0", "libxkbcommon0"),
)
WITH_X11 = (
    Library("libX11-xcb.so.1", "libx11-xcb1"),
    Library("libxcb-cursor.so.0", "libxcb-cursor0"),
    Library("libxcb-icccm.so.4", "libxcb-icccm4"),
    Library("libxcb-keysyms.so.1", "libxcb-keysyms1"),
    Library("libxcb-shape.so.0", "libxcb-shape0"),
    Library("libxcb-xkb.so.1", "libxcb-xkb1"),
    Library("libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
)
WITH_WAYLAND = (
    Library("libwayland-client.so.0", "libwayland-client0"),
    Library("libwayland-cursor.so.0", "libwayland-cursor0"),
    Library("libwayland-egl.so.1", "libwayland-egl1"),
)


# ---- the environment: .venv with exactly the packages of requirements.lock


class Environment:
    """The virtual environment of one checkout."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.folder = root / ".venv"
        self.stamp = self.folder / "calrig-stamp.txt"
        scripts = ("Scripts", "python.exe") if os.name == "nt" else ("bin", "python")
        self.python = self.folder.joinpath(*scripts)

    def requirements(self, group: str) -> list[str]:
        """The packages that pyproject.toml asks for, without versions pinned."""
        import tomllib

        project = tomllib.loads((self.root / "pyproject.toml").read_text("utf-8"))["project"]
        wanted = list(project["dependencies"])
        if group == DEVELOPMENT:
            wanted += project["optional-dependencies"]["dev"]
        return wanted

    def fingerprint(self, group: str) -> str:
        """What must be unchanged for an installed environment to be good."""
        parts = [
            *self.requirements(group),
            (self.root / "requirements.lock").read_text("utf-8"),
            "{}.{}".format(*sys.version_info[:2]),
            platform.machine(),
            str(self.folder),
        ]
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()

    def is_ready(self, group: str) -> bool:
        """True if everything was installed to its end for this lock and this Python."""
        try:
            stamped = self.stamp.read_text("utf-8").split()
        except OSError:
            return False
        return self.fingerprint(group) in stamped and self.python.exists()

    def prepare(self, group: str) -> None:
        """Make the environment ready; what is ready already is left alone."""
        if self.is_ready(group):
            return
        try:
            if self.is_broken() or not self.is_usable():
                self.create()
            self.stamp.write_text(UNFINISHED, "utf-8")
            self.install(group)
            groups = (RUNTIME, group)
            self.stamp.write_text("\n".join(map(self.fingerprint, groups)) + "\n", "utf-8")
        except OSError as error:
            where = error.filename or self.folder
            raise StopError(f"{where}: {error.strerror}. {self.not_made()}") from error

    def is_broken(self) -> bool:
        """True if an installation was cut off: half a package can look like a whole one."""
        return self.stamp.exists() and self.stamp.read_text("utf-8") == UNFINISHED

    def is_usable(self) -> bool:
        """True if there is an environment of this Python version with a pip that runs."""
        try:
            settings = (self.folder / "pyvenv.cfg").read_text("utf-8")
        except OSError:
            return False
        version = "version = {}.{}.".format(*sys.version_info[:2])
        return version in settings and self.python.exists() and has_pip(self.python)

    def create(self) -> None:
        """Make an empty environment with pip, whatever was there before."""
        say(f"making {self.folder}")
        if self.folder.exists():
            shutil.rmtree(self.folder)
        base = getattr(sys, "_base_executable", None) or sys.executable
        if not can_import("ensurepip", "venv") and not (can_import("venv") and has_pip(base)):
            # Debian keeps these out of its python3; the package also completes python3-minimal.
            version = "{}.{}".format(*sys.version_info[:2])
            why = "This Python can make no virtual environment (it has no ensurepip and no pip)."
            install_system_packages([f"python{version}-venv"], why)
        if can_import("ensurepip", "venv"):
            run_or_stop([base, "-m", "venv", str(self.folder)], self.not_made())
            return
        run_or_stop([base, "-m", "venv", "--without-pip", str(self.folder)], self.not_made())
        seed = [base, "-m", "pip", "--python", str(self.python), "install", "--quiet", "pip"]
        run_or_stop(seed, NOT_INSTALLED)

    def not_made(self) -> str:
        """The message for a folder that cannot be written."""
        return (
            f"The environment {self.folder} could not be made. "
            "The checkout must be in a folder that you may write to."
        )

    def install(self, group: str) -> None:
        """Install the packages of the group in the versions of the lock."""
        say(f"installing the {group} packages (some hundred megabytes, only once)")
        command = [str(self.python), "-m", "pip", "install", "--quiet", "--only-binary", ":all:"]
        command += ["--disable-pip-version-check", "--no-warn-script-location"]
        command += ["--constraint", str(self.root / "requirements.lock"), *self.requirements(group)]
        run_or_stop(command, NOT_INSTALLED)


NOT_INSTALLED = """\
The packages could not be installed; pip's reason stands above.
  * No network, or a proxy in between: start again when there is one (for a proxy or a mirror set
    up pip: `pip config set global.index-url ...`). What was downloaded is kept.
  * "No matching distribution": there are no ready packages for this Python or this system. They
    exist for CPython 3.11 to 3.14 on 64-bit Windows 10 or newer, and Linux with glibc 2.34 or
    newer (Debian 12, Ubuntu 22.04)."""


def has_pip(python: str | Path) -> bool:
    """True if this interpreter can run pip."""
    command = [str(python), "-m", "pip", "--version"]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def can_import(*modules: str) -> bool:
    """True if this Python brings all these modules."""
    return all(importlib.util.find_spec(module) is not None for module in modules)


# ---- the system libraries that Qt's wheels leave to the system


def needed_libraries(environ: dict[str, str]) -> tuple[Library, ...]:
    """What Qt will load under these variables on Linux."""
    if sys.platform != "linux":
        return ()
    wanted = ALWAYS
    if environ.get("QT_QPA_PLATFORM", "") not in ("offscreen", "minimal"):
        wanted += WITH_X11 if environ.get("DISPLAY") else ()
        wanted += WITH_WAYLAND if environ.get("WAYLAND_DISPLAY") else ()
    return wanted


def missing_libraries(libraries: tuple[Library, ...]) -> list[Library]:
    """Those that the dynamic linker does not find."""
    import ctypes

    missing: list[Library] = []
    for library in libraries:
        try:
            ctypes.CDLL(library.soname)
        except OSError:
            missing.append(library)
    return missing


def packages_of(libraries: list[Library], release: dict[str, str]) -> list[str]:
    """The Debian packages of these libraries in that release of Debian or Ubuntu."""
    since = {"debian": 13.0, "ubuntu": 24.04}.get(release.get("ID", ""))
    try:
        new = since is not None and float(release.get("VERSION_ID", "99")) >= since
    except ValueError:
        new = False
    return list(dict.fromkeys((new and lib.renamed) or lib.package for lib in libraries))


def provide_libraries(environ: dict[str, str]) -> None:
    """Have every library that Qt needs, or stop and name the packages."""
    missing = missing_libraries(needed_libraries(environ))
    if not missing:
        return
    try:
        release = platform.freedesktop_os_release()
    except OSError:
        release = {}
    names = ", ".join(library.soname for library in missing)
    install_system_packages(packages_of(missing, release), f"Qt needs system libraries: {names}.")
    left = missing_libraries(tuple(missing))
    if left:
        raise StopError(f"Still missing: {', '.join(library.soname for library in left)}.")


def install_system_packages(packages: list[str], why: str) -> None:
    """Install Debian packages if we are root, else stop with the command that does it."""
    command = ["apt-get", "install", "--no-install-recommends", *packages]
    root = hasattr(os, "geteuid") and os.geteuid() == 0
    if not root or shutil.which("apt-get") is None:
        raise StopError(
            f"{why}\nInstall them and start again. On Debian and Ubuntu:\n\n"
            f"    sudo {' '.join(command)}\n"
        )
    say(f"{why} Installing as root: {' '.join(packages)}")
    environ = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    command[2:2] = ["--yes", "--quiet"]
    if subprocess.call(command, env=environ) != 0:
        # The lists of packages are older than the archive, or not there at all.
        subprocess.call(["apt-get", "--quiet", "update"], env=environ)
        if subprocess.call(command, env=environ) != 0:
            raise StopError(f"{why}\napt-get could not install them; its reason stands above.")
    importlib.invalidate_caches()


# ---- the three things to do


def run(environment: Environment, arguments: list[str]) -> int:
    """Open the program, or play the demonstration where there is no screen."""
    environ = child_environment()
    offscreen = "--offscreen" in arguments or not has_screen(environ)
    arguments = [argument for argument in arguments if argument != "--offscreen"]
    if offscreen:
        environ["QT_QPA_PLATFORM"] = "offscreen"
    provide_libraries(environ)
    environment.prepare(RUNTIME)
    what = ["demo"] if offscreen else ["--simulated"]
    if offscreen and "--part" not in arguments:
        # The measuring tabs; `calrig demo` alone plays all tabs, which takes some minutes.
        what += ["--part", "head", "--part", "rate", "--part", "accuracy"]
    command = [str(environment.python), "-m", "calrig", *what, *arguments]
    os.chdir(environment.root)
    if os.name == "posix":
        os.execve(command[0], command, environ)
    return subprocess.call(command, env=environ)


_TWO_WORKERS = ("-n", "2", "--dist", "loadfile", "--no-loadscope-reorder")
"""The tests of the window wait more than they compute; long files come first, see conftest."""


def test(environment: Environment, arguments: list[str]) -> int:
    """Lint, check and test; pytest comes last, so that its summary closes the output."""
    environ = headless_environment()
    provide_libraries(environ)
    servers = Path("/usr/lib/postgresql").glob("*/bin/initdb")  # Debian keeps them off the path
    if sys.platform == "linux" and not (shutil.which("initdb") or any(servers)):
        install_system_packages(["postgresql"], "The archive's tests start a PostgreSQL server.")
    environment.prepare(DEVELOPMENT)
    import_rules = "from importlinter.cli import lint_imports_command as main; main()"
    checks = {
        "ruff check": ["-m", "ruff", "check", "."],
        "ruff format": ["-m", "ruff", "format", "--check", "."],
        "import rules": ["-c", import_rules],
        "pyright": ["-m", "pyright"],
        "pytest": ["-m", "pytest", *_TWO_WORKERS, *arguments],
    }
    failed: list[str] = []
    for name, command in checks.items():
        say(name)
        python = str(environment.python)
        if subprocess.call([python, *command], env=environ, cwd=environment.root) != 0:
            failed.append(name)
    if failed:
        say(f"failed: {', '.join(failed)}")
    return 1 if failed else 0


def bench(environment: Environment, arguments: list[str]) -> int:
    """Run the benchmarks one after another and count the targets that were missed."""
    return hand_over(environment, "tests/benchmarks/run_all.py", arguments)


def bundle(environment: Environment, arguments: list[str]) -> int:
    """Build the program as one folder that needs no Python, and see it work."""
    return hand_over(environment, "resources/packaging/bundle.py", arguments)


def hand_over(environment: Environment, script: str, arguments: list[str]) -> int:
    """Run a script of the checkout in the environment, without a screen."""
    environ = {**headless_environment(), "PYTHONPATH": str(environment.root)}
    provide_libraries(environ)
    environment.prepare(DEVELOPMENT)
    command = [str(environment.python), str(environment.root / script), *arguments]
    return subprocess.call(command, env=environ, cwd=environment.root)


def has_screen(environ: dict[str, str]) -> bool:
    """True if a window can be opened."""
    if sys.platform != "linux":
        return True
    return bool(environ.get("DISPLAY") or environ.get("WAYLAND_DISPLAY"))


def child_environment() -> dict[str, str]:
    """Our variables without those that would mix another Python's packages in."""
    strange = ("PYTHONPATH", "PYTHONHOME", "PYTHONSAFEPATH")
    environ = {name: value for name, value in os.environ.items() if name not in strange}
    return {**environ, "PYTHONIOENCODING": "utf-8"}


def headless_environment() -> dict[str, str]:
    """The same with a Qt that needs no screen."""
    return {"QT_QPA_PLATFORM": "offscreen", **child_environment()}


def run_or_stop(command: list[str], why: str) -> None:
    """Run a command; if it fails, stop with the reason."""
    if subprocess.call(command, env=child_environment()) != 0:
        raise StopError(why)


def say(text: str) -> None:
    """Tell what happens now; flushed, since programs that we start write to the same place."""
    print(f"bootstrap: {text}", flush=True)


def main(arguments: list[str]) -> int:
    """Do what the command line asks for and return the exit code."""
    if sys.version_info < OLDEST:
        here = "{}.{}".format(*sys.version_info[:2])
        print(f"CalRig needs Python 3.11 or newer; this is {here} ({sys.executable}).")
        print("Install a newer one from python.org or your system and start with it.")
        return 2
    actions = {"run": run, "test": test, "bench": bench, "bundle": bundle}
    if not arguments or arguments[0] not in actions:
        print(__doc__)
        return 0 if arguments[:1] in (["-h"], ["--help"]) else 2
    try:
        return actions[arguments[0]](Environment(ROOT), arguments[1:])
    except StopError as stop:
        print(f"\nbootstrap: {stop}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nbootstrap: interrupted; start again to go on.", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
