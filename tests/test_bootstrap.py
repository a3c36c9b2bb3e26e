"""The bootstrap without its installations: what it needs, decides, remembers and says."""

import ast
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import bootstrap
from bootstrap import DEVELOPMENT, RUNTIME, Environment, Library, StopError

ROOT = Path(bootstrap.__file__).parent
NOWHERE = Library("libcalrig-is-nowhere.so.7", "libcalrig7", "libcalrig7t64")


@pytest.fixture
def checkout(tmp_path: Path) -> Environment:
    """A folder with what an environment depends on, its name with a space."""
    root = tmp_path / "my bench"
    root.mkdir()
    (root / "requirements.lock").write_text("numpy==2.4.6\n", "utf-8")
    (root / "pyproject.toml").write_text(
        '[project]\ndependencies = ["numpy>=2"]\noptional-dependencies = {dev = ["pytest"]}\n',
        "utf-8",
    )
    return Environment(root)


def install_nothing(environment: Environment, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Stand in for venv and pip: only the interpreter appears. Returns the log of what was done."""
    done: list[str] = []

    def create() -> None:
        done.append("create")
        shutil.rmtree(environment.folder, ignore_errors=True)
        environment.python.parent.mkdir(parents=True)
        environment.python.touch()

    monkeypatch.setattr(environment, "create", create)
    monkeypatch.setattr(environment, "install", done.append)
    monkeypatch.setattr(environment, "is_usable", environment.python.exists)
    return done


def test_only_the_standard_library_is_imported():
    tree = ast.parse((ROOT / "bootstrap.py").read_text("utf-8"))
    names: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names.update(alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            names.add((node.module or "").split(".")[0])
    assert names <= sys.stdlib_module_names


def test_an_old_python_can_read_the_file_far_enough_to_be_told():
    ast.parse((ROOT / "bootstrap.py").read_text("utf-8"), feature_version=(3, 7))


def test_an_old_python_is_told_what_is_needed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.setattr(sys, "version_info", (3, 9, 2))
    assert bootstrap.main(["run"]) == 2
    assert "CalRig needs Python 3.11 or newer; this is 3.9" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "code"), [([], 2), (["walk"], 2), (["--help"], 0), (["-h"], 0)]
)
def test_without_a_known_word_the_usage_is_shown(
    arguments: list[str], code: int, capsys: pytest.CaptureFixture[str]
):
    assert bootstrap.main(arguments) == code
    assert "bootstrap.py run" in capsys.readouterr().out


def test_a_prepared_environment_is_left_alone(
    checkout: Environment, monkeypatch: pytest.MonkeyPatch
):
    done = install_nothing(checkout, monkeypatch)
    checkout.prepare(RUNTIME)
    checkout.prepare(RUNTIME)
    assert done == ["create", RUNTIME]


def test_development_adds_to_runtime_and_covers_it(
    checkout: Environment, monkeypatch: pytest.MonkeyPatch
):
    done = install_nothing(checkout, monkeypatch)
    checkout.prepare(RUNTIME)
    assert not checkout.is_ready(DEVELOPMENT)
    checkout.prepare(DEVELOPMENT)
    assert checkout.is_ready(RUNTIME)
    assert done == ["create", RUNTIME, DEVELOPMENT]


def test_an_interrupted_installation_is_begun_anew(
    checkout: Environment, monkeypatch: pytest.MonkeyPatch
):
    done = install_nothing(checkout, monkeypatch)
    checkout.prepare(RUNTIME)
    (checkout.root / "requirements.lock").write_text("numpy==2.4.7\n", "utf-8")

    def interrupted(group: str) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(checkout, "install", interrupted)
        with pytest.raises(KeyboardInterrupt):
            checkout.prepare(RUNTIME)
    assert not checkout.is_ready(RUNTIME)
    checkout.prepare(RUNTIME)
    assert done == ["create", RUNTIME, "create", RUNTIME]
    assert checkout.is_ready(RUNTIME)


@pytest.mark.parametrize("file", ["requirements.lock", "pyproject.toml"])
def test_a_changed_lock_or_list_is_noticed(
    file: str, checkout: Environment, monkeypatch: pytest.MonkeyPatch
):
    install_nothing(checkout, monkeypatch)
    checkout.prepare(RUNTIME)
    path = checkout.root / file
    path.write_text(path.read_text("utf-8").replace("numpy", "numpy2"), "utf-8")
    assert not checkout.is_ready(RUNTIME)


def test_another_python_and_another_place_are_noticed(
    checkout: Environment, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
):
    install_nothing(checkout, monkeypatch)
    checkout.prepare(RUNTIME)
    assert checkout.is_ready(RUNTIME)
    moved = checkout.root.rename(tmp_path / "moved")
    assert not Environment(moved).is_ready(RUNTIME)
    moved.rename(checkout.root)
    monkeypatch.setattr(sys, "version_info", (3, 99, 0))
    assert not checkout.is_ready(RUNTIME)


def test_an_environment_of_another_python_is_not_used(checkout: Environment):
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", checkout.folder], check=True)
    settings = checkout.folder / "pyvenv.cfg"
    text = settings.read_text("utf-8")
    assert not checkout.is_usable()  # no pip in it
    here = "{}.{}.".format(*sys.version_info[:2])
    settings.write_text(text.replace(f"version = {here}", "version = 3.99."), "utf-8")
    assert not checkout.is_usable()


def test_a_folder_that_cannot_be_written_is_named(
    checkout: Environment, monkeypatch: pytest.MonkeyPatch
):
    def create() -> None:
        raise OSError(30, "Read-only file system", str(checkout.folder))

    monkeypatch.setattr(checkout, "create", create)
    with pytest.raises(StopError, match=r"Read-only file system.*a folder that you may write to"):
        checkout.prepare(RUNTIME)


def test_a_failed_command_stops_with_its_reason():
    with pytest.raises(StopError, match="because"):
        bootstrap.run_or_stop([sys.executable, "-c", "raise SystemExit(3)"], "because")


def test_every_library_is_a_soname_and_has_one_package_in_each_release():
    libraries = bootstrap.ALWAYS + bootstrap.WITH_X11 + bootstrap.WITH_WAYLAND
    sonames = [library.soname for library in libraries]
    assert len(set(sonames)) == len(sonames)
    assert all(
        library.soname.startswith("lib") and ".so." in library.soname for library in libraries
    )
    assert all(library.package.startswith("lib") for library in libraries)


def test_only_what_the_linker_does_not_find_is_missing():
    present = Library("libc.so.6", "libc6")
    assert bootstrap.missing_libraries((present, NOWHERE)) == [NOWHERE]


@pytest.mark.parametrize(
    ("release", "package"),
    [
        ({"ID": "debian", "VERSION_ID": "12"}, "libcalrig7"),
        ({"ID": "debian", "VERSION_ID": "13"}, "libcalrig7t64"),
        ({"ID": "debian"}, "libcalrig7t64"),  # testing and unstable have no number
        ({"ID": "ubuntu", "VERSION_ID": "22.04"}, "libcalrig7"),
        ({"ID": "ubuntu", "VERSION_ID": "24.04"}, "libcalrig7t64"),
        ({"ID": "arch", "VERSION_ID": "rolling"}, "libcalrig7"),
        ({}, "libcalrig7"),
    ],
)
def test_packages_are_named_as_that_release_has_them(release: dict[str, str], package: str):
    assert bootstrap.packages_of([NOWHERE, NOWHERE], release) == [package]


def test_the_screen_decides_which_libraries_are_needed(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(sys, "platform", "linux")
    needed = bootstrap.needed_libraries
    assert needed({}) == bootstrap.ALWAYS
    assert needed({"DISPLAY": ":0"}) == bootstrap.ALWAYS + bootstrap.WITH_X11
    assert needed({"WAYLAND_DISPLAY": "w"}) == bootstrap.ALWAYS + bootstrap.WITH_WAYLAND
    assert needed({"DISPLAY": ":0", "QT_QPA_PLATFORM": "offscreen"}) == bootstrap.ALWAYS
    monkeypatch.setattr(sys, "platform", "win32")
    assert needed({"DISPLAY": ":0"}) == ()


def test_a_user_who_is_not_root_is_given_the_command(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(os, "geteuid", lambda: 1000, raising=False)
    with pytest.raises(StopError, match=r"why\n.*\n\n    sudo apt-get install .* libone libtwo\n"):
        bootstrap.install_system_packages(["libone", "libtwo"], "why")


def test_variables_of_another_python_are_not_passed_on(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("PYTHONPATH", "elsewhere")
    monkeypatch.setenv("LANG", "uk_UA.UTF-8")
    environ = bootstrap.child_environment()
    assert "PYTHONPATH" not in environ
    assert environ["LANG"] == "uk_UA.UTF-8"


def test_a_chosen_platform_is_kept(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("QT_QPA_PLATFORM", "xcb")
    assert bootstrap.headless_environment()["QT_QPA_PLATFORM"] == "xcb"
    monkeypatch.delenv("QT_QPA_PLATFORM")
    assert bootstrap.headless_environment()["QT_QPA_PLATFORM"] == "offscreen"


def test_missed_targets_are_counted(
    checkout: Environment, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
):
    folder = checkout.root / "tests" / "benchmarks"
    folder.mkdir(parents=True)
    shutil.copy(ROOT / "tests" / "benchmarks" / "run_all.py", folder)
    (folder / "bench_fast.py").write_text("print('decode 120 MB/s | - | - | 100 | ok')", "utf-8")
    slow = "print('fit 9 ms | - | - | 2 | MISSED'); raise SystemExit(1)"
    (folder / "bench_slow.py").write_text(slow, "utf-8")
    (folder / "bench_torn.py").write_text("raise SystemExit(3)", "utf-8")
    monkeypatch.setattr(checkout, "prepare", lambda group: None)
    monkeypatch.setattr(bootstrap, "provide_libraries", lambda environ: None)
    monkeypatch.setattr(checkout, "python", Path(sys.executable))
    assert bootstrap.bench(checkout, ["fast"]) == 0
    assert bootstrap.bench(checkout, []) == 1
    text = capfd.readouterr().out
    assert "fit 9 ms" in text
    assert "bench_torn broke off with exit code 3" in text
    assert text.endswith("2 missed\n")
