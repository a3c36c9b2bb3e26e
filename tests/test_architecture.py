"""What the folders promise: sizes, names, light imports, a test for every module, links."""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PACKAGES = ("calrig", "core", "drivers", "gui", "resources")
SOURCES = sorted(
    [ROOT / "bootstrap.py"]
    + [path for folder in (*PACKAGES, "tests") for path in (ROOT / folder).rglob("*.py")]
)
PAGES = sorted(
    [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "tests").rglob("*.md")]
)
COMMAND_MODULES = sorted(
    f"gui.commands.{path.stem}"
    for path in (ROOT / "gui" / "commands").glob("*.py")
    if path.stem != "__init__"
)


def relative(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def test_no_source_is_longer_than_400_lines():
    lengths = {relative(path): len(path.read_text("utf-8").splitlines()) for path in SOURCES}
    assert {path: length for path, length in lengths.items() if length > 400} == {}


def test_the_wheel_gets_every_package_and_no_other():
    tools = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]
    listed = tools["setuptools"]["packages"]
    folders = {path.parent for package in PACKAGES for path in (ROOT / package).rglob("*.py")}
    # To setuptools a folder of data is a package as well.
    data = {path.parent for path in (ROOT / "resources").rglob("*.*") if path.suffix != ".pyc"}
    dotted = {relative(folder).replace("/", ".") for folder in folders | data}
    wanted = {name if name == "calrig" else f"calrig._app.{name}" for name in dotted}
    assert wanted - set(listed) == set(), "add these to pyproject.toml"
    assert set(listed) - wanted == set(), "take these out of pyproject.toml"
    assert [relative(folder) for folder in folders if not (folder / "__init__.py").exists()] == []


def test_every_package_explains_itself():
    silent = [
        relative(path)
        for path in SOURCES
        if path.name == "__init__.py" and not path.read_text("utf-8").startswith('"""')
    ]
    assert silent == []


def test_no_source_or_page_is_tied_to_one_machine_or_left_unfinished():
    stain = re.compile(
        r"(?<![\w.}/])/(?:home|root|work|Users)/\w|[A-Z]:\\Users|\b(?:TODO|FIXME|XXX)\b"
    )
    found = [
        f"{relative(path)}:{number}: {line.strip()}"
        for path in [*SOURCES, *PAGES]
        if path != Path(__file__)
        for number, line in enumerate(path.read_text("utf-8").splitlines(), 1)
        if stain.search(line)
    ]
    assert found == []


@pytest.mark.parametrize("layer", ["core", "drivers"])
def test_every_module_has_its_tests(layer: str):
    without = [
        relative(path)
        for path in (ROOT / layer).rglob("*.py")
        if path.stem != "__init__"
        and not list((ROOT / "tests" / relative(path.parent)).glob(f"test_*{path.stem}*.py"))
    ]
    assert without == []


def modules_after(statement: str) -> set[str]:
    """Top-level names of all modules that a fresh interpreter has loaded after `statement`."""
    program = f"import sys; {statement}; print(*{{name.split('.')[0] for name in sys.modules}})"
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return set(done.stdout.split())


@pytest.mark.parametrize("module", ["gui.main", *COMMAND_MODULES])
def test_a_subcommand_needs_no_qt_and_loads_scipy_only_to_compute(module: str):
    heavy = {"PySide6", "pyqtgraph", "scipy", "matplotlib"}
    assert modules_after(f"import {module}") & heavy == set()


def test_the_entry_loads_nothing_but_itself():
    assert modules_after("import gui.main") & {"numpy", "serial"} == set()


def test_links_between_pages_resolve():
    link = re.compile(r"!?\[[^\]]*\]\(([^)#\s]+)(?:#[^)]*)?\)")
    broken = [
        f"{relative(page)}: {target}"
        for page in PAGES
        for target in link.findall(page.read_text("utf-8"))
        if "://" not in target and not (page.parent / target).exists()
    ]
    assert broken == []
