"""The environment is the one that was tested: the lock is complete, and Qt's binding is sound."""

import importlib.metadata
import sys
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import NormalizedName, canonicalize_name
from PySide6.QtCore import QRectF

ROOT = Path(__file__).resolve().parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
LOCK = {
    canonicalize_name(pin.name): str(pin.specifier).removeprefix("==")
    for line in (ROOT / "requirements.lock").read_text("utf-8").splitlines()
    if line and not line.startswith("#")
    for pin in [Requirement(line)]
}


def closure() -> dict[NormalizedName, str]:
    """Installed versions of all that the project asks for, and of all that these ask for."""
    found: dict[NormalizedName, str] = {}
    todo = [
        Requirement(text)
        for text in PROJECT["dependencies"] + PROJECT["optional-dependencies"]["dev"]
    ]
    while todo:
        wanted = todo.pop()
        name = canonicalize_name(wanted.name)
        distribution = importlib.metadata.distribution(name)
        if name in found and not wanted.extras:
            continue
        found[name] = distribution.version
        for text in distribution.requires or ():
            need = Requirement(text)
            extras = wanted.extras or {""}
            if need.marker is None or any(need.marker.evaluate({"extra": e}) for e in extras):
                todo.append(need)
    return found


def test_the_lock_pins_what_is_installed():
    installed = closure()
    assert {name: LOCK.get(name) for name in installed} == installed


def test_the_lock_keeps_to_what_the_project_asks_for():
    for text in PROJECT["dependencies"] + PROJECT["optional-dependencies"]["dev"]:
        wanted = Requirement(text)
        assert LOCK[canonicalize_name(wanted.name)] in wanted.specifier


def test_calls_into_qt_lose_no_reference_to_none():
    rectangle = QRectF(0, 0, 1, 1)
    before = sys.getrefcount(None)
    for _ in range(1000):
        rectangle.setTop(0.5)
    assert sys.getrefcount(None) == pytest.approx(before, abs=100)
