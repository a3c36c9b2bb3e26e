"""The version that results carry is the version of the package."""

import tomllib
from pathlib import Path

from core.version import VERSION


def test_the_version_is_that_of_the_package():
    text = (Path(__file__).resolve().parents[2] / "pyproject.toml").read_text("utf-8")
    assert tomllib.loads(text)["project"]["version"] == VERSION
