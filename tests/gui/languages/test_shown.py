"""Words of states and errors come out in the language of the window."""

import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from gui.languages import update
from gui.languages.anchors import LABELS, anchor, beside, old_label
from gui.languages.shown import SHOWN, Book, shown, shown_number, speak
from gui.languages.ts_file import Message, read_ts

WORDS = {
    "row": "рядок",
    "check only": "лише перевірка",
    "dial {angle}": "лімб {angle}",
    "No device is connected": "Пристрою немає",
    "{name} is connected": "{name} під'єднано",
    "position": "положення",
    "nothing was measured": "нічого не виміряно",
    "{count} rows": "рядків: {count}",
    "{path}: the file has {rows} rows, {wanted} are needed": (
        "{path}: у файлі {rows} рядків, потрібно {wanted}"
    ),
    "The head moved ({names} changed); wait.": "Головка рухалася (змінилися {names}); зачекайте.",
    "the residuals are {times} times larger; {meaning}": "залишки у {times} раза більші; {meaning}",
    "the model lacks something": "моделі чогось бракує",
    ", upper limit: not detected": ", верхня межа: не виявлено",
    "Accumulate Data": "Накопичити дані",
    "a = Q (2.5)": "a = Q (2.5)",
}


@pytest.fixture
def ukrainian() -> Iterator[None]:
    speak(Book([Message(SHOWN, en, "", uk) for en, uk in WORDS.items()], ","))
    yield
    speak(None)


@pytest.mark.usefixtures("ukrainian")
@pytest.mark.parametrize(
    ("english", "told"),
    [
        ("nothing was measured", "нічого не виміряно"),
        ("Nothing was measured.", "Нічого не виміряно."),
        ("a.txt: the file has 3 rows, 4.5 are needed", "a.txt: у файлі 3 рядків, потрібно 4,5"),
        ("The head moved (a_x, a_y changed); wait.", "Головка рухалася (змінилися a_x, a_y); зачекайте."),  # noqa: E501
        ("the residuals are 2.5 times larger; the model lacks something",
         "залишки у 2,5 раза більші; моделі чогось бракує"),
        ("X: the residuals are 2.5 times larger; nothing was measured",
         "X: залишки у 2,5 раза більші; нічого не виміряно"),
        ("12 rows, 25.0 °C … 70.0 °C, check only", "рядків: 12, 25,0 °C … 70,0 °C, лише перевірка"),
        ("N_gyro, upper limit: not detected", "N_gyro, верхня межа: не виявлено"),
        ("Position 3", "Положення 3"),
        ("30.5° (dial 330°)", "30,5° (лімб 330°)"),
        ("11:35:33  No device is connected. Wait", "11:35:33  Пристрою немає. Wait"),
        ("PW09 is connected", "PW09 під'єднано"),
        ("  check only", "  лише перевірка"),
        ("a = Q (2.5)", "a = Q (2.5)"),
    ],
)  # fmt: skip
def test_a_text_is_made_anew_in_the_language(english: str, told: str):
    assert shown(english) == told


@pytest.mark.usefixtures("ukrainian")
@pytest.mark.parametrize("text", ["", " ", "SN-1.25.3", "x_1.5.txt", "127.0.0.1", "Оператор 1"])
def test_what_nobody_knows_stays(text: str):
    assert shown(text) == text


@pytest.mark.usefixtures("ukrainian")
def test_telling_twice_changes_nothing():
    for english in WORDS:
        assert shown(shown(english)) == shown(english)


@pytest.mark.usefixtures("ukrainian")
@pytest.mark.parametrize(
    ("number", "told"),
    [
        ("−0.123", "−0,123"),
        ("1.5e−6", "1,5e−6"),
        ("12.5 mg", "12,5 mg"),
        ("1.0 ± 0.25", "1,0 ± 0,25"),
        ("file_1.5.txt", "file_1.5.txt"),
        ("2.12.1", "2.12.1"),
        ("2026-11-22", "2026-11-22"),
    ],
)
def test_numbers_have_the_mark_of_the_language(number: str, told: str):
    assert shown_number(number) == told


def test_english_is_left_alone():
    speak(None)
    assert shown("12.5 rows") == "12.5 rows"
    assert shown_number("1.5") == "1.5"
    assert anchor("Accumulate Data") == ""


@pytest.mark.usefixtures("ukrainian")
def test_old_labels_stand_below_their_translation():
    assert anchor("Accumulate Data") == "Accumulate Data"
    assert anchor("nothing was measured") == ""
    assert beside("✓ Накопичити дані") == "✓ Накопичити дані (Accumulate Data)"
    assert beside("Накопичити дані", "Натисніть тут") == "Натисніть тут (Accumulate Data)"
    assert beside("положення", "Де стоїть") == "Де стоїть"


@pytest.mark.parametrize("path", update.ts_files(), ids=lambda path: path.name)
def test_every_old_label_is_translated_and_found_again(path: Path):
    messages = read_ts(path)
    translated = {m.source for m in messages if m.translation}
    assert translated >= LABELS
    speak(Book(messages, ","))
    for message in messages:
        if message.source in LABELS and message.translation != message.source:
            words = message.translation.replace("{unit}", "mg").replace("{n}", "12")
            assert message.source.partition(" ({")[0].partition(" {")[0] in old_label(words)
    speak(None)
    assert old_label("Курс") == ""


def test_a_long_text_takes_less_than_five_milliseconds():
    book = Book(read_ts(update.FOLDER / "calrig_uk.ts"), ",")
    note = (
        "rows 1, 2 give a bias of 12.5 mg, rows 3 one of 14.2 mg: 1.7 mg = 1.7 mg apart. A"
        " second-order nonlinearity, a drift or a wrong position would do this; measure more"
        " positions to tell which"
    )
    texts = [f"{note} {number}. Something nobody knows {number}." for number in range(40)]
    book.translate("warm up the patterns of row 1")
    best = min(_seconds(book, text) for text in texts)
    assert best < 5e-3


def _seconds(book: Book, text: str) -> float:
    start = time.perf_counter()
    book.translate(text)
    return time.perf_counter() - start
