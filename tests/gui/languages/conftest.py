"""The language of the window, for a test."""

from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from gui.languages.choice import Languages


@pytest.fixture
def speaking(qtbot: QtBot) -> Iterator[Callable[[str], None]]:
    """Take a language; English comes back."""
    languages = Languages("en")
    yield languages.choose
    languages.choose("en")
