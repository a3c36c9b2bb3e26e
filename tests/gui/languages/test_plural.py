"""Words follow the numbers before them, as Ukrainian and Russian want it."""

import re
from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from gui.languages.choice import Languages
from gui.languages.plural import FORMS, inflected
from gui.languages.shown import SHOWN, shown
from gui.languages.ts_file import read_ts
from gui.languages.update import ts_files


@pytest.fixture
def languages(qtbot: QtBot) -> Iterator[Languages]:
    one = Languages("en")
    yield one
    one.choose("en")


@pytest.mark.parametrize(
    ("number", "word"),
    [
        ("0", "рядків"),
        ("1", "рядок"),
        ("2", "рядки"),
        ("4", "рядки"),
        ("5", "рядків"),
        ("11", "рядків"),
        ("12", "рядків"),
        ("14", "рядків"),
        ("21", "рядок"),
        ("22", "рядки"),
        ("111", "рядків"),
        ("121", "рядок"),
        ("12 481", "рядок"),
        ("2,5", "рядки"),
    ],
)
def test_the_word_follows_its_number(number: str, word: str):
    assert inflected(f"{number} [рядок|рядки|рядків]") == f"{number} {word}"


def test_each_word_follows_the_number_before_it():
    words = "1 з 5 [рядка|рядків|рядків] на 2 [кут|кути|кутів] з [a] [[limit]]"
    assert inflected(words) == "1 з 5 рядків на 2 кути з [a] [[limit]]"


def test_a_word_without_a_number_is_that_of_many():
    assert inflected("кілька [рядок|рядки|рядків]") == "кілька рядків"


@pytest.mark.parametrize(
    ("language", "told"),
    [
        ("uk", ["1 рядок", "2 рядки", "5 рядків", "21 рядок"]),
        ("ru", ["1 строка", "2 строки", "5 строк", "21 строка"]),
    ],
)
def test_states_are_told_so(languages: Languages, language: str, told: list[str]):
    languages.choose(language)
    english = [f"{n} rows; a record over temperature needs at least 30" for n in (1, 2, 5, 21)]
    assert [shown(text).partition(";")[0] for text in english] == told


@pytest.mark.parametrize("path", ts_files(), ids=lambda path: path.name)
def test_forms_stand_where_they_are_chosen(path):
    for message in read_ts(path):
        if "|" not in message.translation or "|" in message.source:
            continue
        assert message.context == SHOWN, message
        forms = FORMS.findall(message.translation)
        assert forms, message
        for match in FORMS.finditer(message.translation):
            assert re.search(r"\{\w+\} $", message.translation[: match.start()]), message
