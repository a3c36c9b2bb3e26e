"""The language is chosen, installed and left again."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QCoreApplication, QLocale
from pytestqt.qtbot import QtBot

from gui.languages.choice import LANGUAGES, Languages, language_of_system, locale_of
from gui.languages.shown import shown
from gui.languages.update import language_of, ts_files
from gui.widgets.fields import NumberField


@pytest.fixture
def languages(qtbot: QtBot) -> Iterator[Languages]:
    one = Languages("en")
    yield one
    one.choose("en")


def test_every_language_has_its_file_and_every_file_its_language():
    assert {language_of(path) for path in ts_files()} == set(LANGUAGES) - {"en"}


def test_words_of_views_of_states_and_of_qt_change_together(languages: Languages):
    languages.choose("uk")
    assert QCoreApplication.translate("ActionBar", "Hands-free") == "Без рук"
    assert shown("nothing was measured") == "nothing was measured"
    assert shown("Accumulate Data") == "Накопичити дані"
    assert QCoreApplication.translate("QPlatformTheme", "Cancel") == "Скасувати"
    languages.choose("en")
    assert QCoreApplication.translate("ActionBar", "Hands-free") == "Hands-free"
    assert shown("Accumulate Data") == "Accumulate Data"
    assert QCoreApplication.translate("QPlatformTheme", "Cancel") == "Cancel"


def test_russian_is_whole(languages: Languages):
    languages.choose("ru")
    assert QCoreApplication.translate("ActionBar", "Hands-free") == "Без рук"
    assert shown("Accumulate Data") == "Накопить данные"
    assert shown("12.5 °C") == "12,5 °C"
    assert QCoreApplication.translate("QPlatformTheme", "Cancel") == "Отмена"
    assert QLocale().toString(12345.5, "f", 1) == "12345,5"


def test_presenters_speak_english_in_every_language(languages: Languages):
    languages.choose("uk")
    assert QCoreApplication.translate("Thermal", "Last Cycle") == "Last Cycle"
    assert shown("Last Cycle") == "Останній цикл"


def test_an_unknown_choice_stands_for_the_system(languages: Languages):
    languages.choose("tlh")
    assert languages.choice == "system"
    assert languages.spoken == language_of_system()
    assert languages.spoken in LANGUAGES


def test_the_choice_is_told(languages: Languages, qtbot: QtBot):
    with qtbot.waitSignal(languages.changed, timeout=1000):
        languages.choose("uk")


def test_numbers_follow_the_language_and_have_no_groups(languages: Languages):
    languages.choose("uk")
    assert QLocale().toString(12345.5, "f", 1) == "12345,5"
    languages.choose("en")
    assert QLocale().toString(12345.5, "f", 1) == "12345.5"
    for code in ("uk", "ru"):
        assert locale_of(code).decimalPoint() == ","


@pytest.mark.parametrize("language", ["en", "uk", "ru"])
@pytest.mark.parametrize("typed", ["3.25", "3,25", "3.25 s"])
def test_fields_take_both_marks(languages: Languages, qtbot: QtBot, language: str, typed: str):
    languages.choose(language)
    field = NumberField(0.0, 100.0, 3, "s")
    qtbot.addWidget(field)
    field.setValue(12.5)
    field.lineEdit().setText(typed)
    field.interpretText()
    assert field.value() == 3.25
    assert field.text() == ("3.250 s" if language == "en" else "3,250 s")


def test_typing_a_large_number_in_ukrainian_is_no_fraction(languages: Languages, qtbot: QtBot):
    languages.choose("uk")
    field = NumberField(0.0, 1e6, 1)
    qtbot.addWidget(field)
    field.lineEdit().setText("123456.5")
    field.interpretText()
    assert field.value() == 123456.5
