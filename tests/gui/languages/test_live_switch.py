"""The whole window changes its language while it runs, and back again."""

import re
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtWidgets import QAbstractButton, QApplication, QLabel, QWidget
from pytestqt.qtbot import QtBot

from gui.app import Application, Options
from gui.languages import update
from gui.languages.anchors import old_label
from gui.languages.choice import LANGUAGES
from gui.languages.shown import SHOWN
from gui.languages.ts_file import read_ts
from gui.widgets.action_bar import ActionBar
from tests.gui.languages.window_words import words_of

CYRILLIC = re.compile("[А-Яа-яІіЇїЄєҐґ]")
PHRASE = re.compile(r"\b[a-z]{3,} [a-z]{3,}\b")
STRANGE = {"uk": re.compile("[ЫыЭэЪъЁё]"), "ru": re.compile("[ІіЇїЄєҐґ]")}
"""Letters of the other language."""
KEPT = re.compile(
    r"English|Українська|Русский|ODH|\.txt|\.json|://"
    r"|Accumulate Data|Process Data|Load Data|sampling process"
)
"""Names, labels of the old programs, and what the file dialog filters by."""


@pytest.fixture
def start(qtbot: QtBot, tmp_path: Path) -> Iterator[Callable[[], Application]]:
    """Open the window, always on the same preferences; in English the first time."""
    settings = tmp_path / "set.json"
    settings.write_text('{"window": {"language": "en"}}', encoding="utf-8")
    opened: list[Application] = []

    def begin() -> Application:
        qt = QApplication.instance()
        assert isinstance(qt, QApplication)
        app = Application(qt, Options(root=tmp_path / "data", settings=settings, quiet=True))
        qtbot.addWidget(app.window)
        opened.append(app)
        with qtbot.waitSignal(app.ready, timeout=60_000):
            app.start()
        return app

    yield begin
    for app in opened:
        app.languages.choose("en")
        app.close()


def english_left(app: Application, language: str) -> list[tuple[str, str]]:
    """Texts that have a translation and are on the screen in English, or look like English."""
    messages = read_ts(update.FOLDER / f"calrig_{language}.ts")
    english = {m.source for m in messages if m.translation != m.source}
    translated = {m.translation for m in messages}
    return [
        (kind, text)
        for kind, text in words_of(app.window)
        if not KEPT.search(text)
        and text not in translated
        and (text in english or (PHRASE.search(text) and not CYRILLIC.search(text)))
    ]


def cyrillic_left(app: Application) -> list[tuple[str, str]]:
    """Texts with Cyrillic letters; a language's own name is one in every language."""
    own = set(LANGUAGES.values())
    return [
        (k, text) for k, text in words_of(app.window) if CYRILLIC.search(text) and text not in own
    ]


def others_left(app: Application, language: str) -> list[tuple[str, str]]:
    """Texts with letters that the language does not have."""
    strange, own = STRANGE[language], set(LANGUAGES.values())
    return [
        (k, text) for k, text in words_of(app.window) if strange.search(text) and text not in own
    ]


def nothing_left(app: Application, language: str) -> None:
    """Cards that are built anew go when Qt finds time for it: asked again until then."""
    if language == "en":
        assert cyrillic_left(app) == []
    else:
        assert english_left(app, language) == []
        assert others_left(app, language) == []


def without_old_label(app: Application) -> list[tuple[str, str]]:
    """Labels and buttons that had an English name in the old programs, and hide it.

    The window tells it for all that have no tool tip; buttons of actions show it below.
    """
    hidden: list[tuple[str, str]] = []
    found: set[str] = set()
    for widget in app.window.findChildren(QWidget):
        text = widget.text() if isinstance(widget, QLabel | QAbstractButton) else ""
        label = old_label(text)
        found.add(label)
        below = isinstance(widget.parentWidget(), ActionBar)
        if label and not below and widget.toolTip() and label not in widget.toolTip():
            hidden.append((text, widget.toolTip()))
    assert len(found) > 40
    return hidden


def switch(app: Application, language: str, qtbot: QtBot) -> None:
    app.window.menu.languages[language].trigger()
    qtbot.wait(100)


def test_nothing_of_the_other_language_is_left(start: Callable[[], Application], qtbot: QtBot):
    app = start()
    for tab in app.tabs.values():
        app.window.tabs.setCurrentWidget(tab.widget)
        qtbot.wait(30)
    opening = ("WordLabel", "The archive is being opened …")
    qtbot.waitUntil(lambda: opening not in set(words_of(app.window)), timeout=30_000)
    qtbot.wait(100)
    before = set(words_of(app.window))
    for language in ("uk", "ru"):
        switch(app, language, qtbot)
        qtbot.waitUntil(partial(nothing_left, app, language), timeout=10_000)
        assert without_old_label(app) == []
    switch(app, "en", qtbot)
    qtbot.waitUntil(partial(nothing_left, app, "en"), timeout=10_000)
    # Results that come meanwhile add words; none may stay away.
    assert before - set(words_of(app.window)) == set()


def test_the_language_is_remembered(start: Callable[[], Application], qtbot: QtBot):
    first = start()
    switch(first, "uk", qtbot)
    first.window.close()
    second = start()
    assert second.languages.choice == "uk"
    assert second.window.menu.languages["uk"].isChecked()
    assert second.window.tabs.tabText(0) == "Ділильна головка"
    assert second.window.tabs.tabToolTip(0) == "Dividing head"


@pytest.mark.parametrize("path", update.ts_files(), ids=lambda path: path.name)
def test_states_are_in_one_context(path: Path):
    messages = read_ts(path)
    shown = [m for m in messages if m.context == SHOWN]
    assert len(shown) > 1000
    assert len({m.source for m in shown}) == len(shown)
