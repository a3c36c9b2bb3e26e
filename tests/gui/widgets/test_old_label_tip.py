"""Operators find the old English words again under the mouse, in every language."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QHelpEvent, QStandardItemModel
from PySide6.QtWidgets import QApplication, QComboBox, QLabel, QTableView, QToolTip
from pytestqt.qtbot import QtBot

from gui.languages.choice import Languages
from gui.languages.shown import shown
from gui.main_window import MainWindow
from gui.messages import Messages
from gui.widgets.old_label_tip import old_label_at


@pytest.fixture
def ukrainian(qtbot: QtBot) -> Iterator[Languages]:
    languages = Languages("uk")
    yield languages
    languages.choose("en")


@pytest.mark.usefixtures("ukrainian")
def test_labels_lists_and_headings_have_their_old_word(qtbot: QtBot):
    label = QLabel("Час накопичення, s")
    qtbot.addWidget(label)
    assert old_label_at(label, QPoint()) == "Accumulation Time, sec"
    label.setText("Щось своє")
    assert old_label_at(label, QPoint()) == ""
    combo = QComboBox()
    qtbot.addWidget(combo)
    combo.addItem(shown("Manual"))
    assert old_label_at(combo, QPoint()) == "Manual"
    view = QTableView()
    qtbot.addWidget(view)
    model = QStandardItemModel(1, 2, view)
    model.setHorizontalHeaderLabels(["Прискорення\nСереднє (code)", "Зовсім інше"])
    view.setModel(model)
    view.show()
    header = view.horizontalHeader()
    for column, old in ((0, "Mean"), (1, "")):
        at = QPoint(header.sectionViewportPosition(column) + 5, 5)
        viewport = header.viewport()
        assert old_label_at(viewport, viewport.mapToGlobal(at)) == old


def test_english_words_have_no_tip(qtbot: QtBot):
    label = QLabel("Main Graph")
    qtbot.addWidget(label)
    assert old_label_at(label, QPoint()) == ""


@pytest.mark.qt_log_ignore(r"does not support raise\(\)")
@pytest.mark.usefixtures("ukrainian")
def test_the_window_answers_for_all_that_have_no_tip_of_their_own(qtbot: QtBot):
    messages = Messages()
    window = MainWindow(messages)
    qtbot.addWidget(window)
    label = QLabel("Головний графік")
    window.tabs.addTab(label, "")
    with qtbot.waitSignal(window.painted):
        window.show()
    place = label.mapToGlobal(QPoint(20, label.height() // 2))
    ask = QHelpEvent(QHelpEvent.Type.ToolTip, label.mapFromGlobal(place), place)
    QApplication.sendEvent(label, ask)
    assert QToolTip.text() == "Main Graph"
    QToolTip.hideText()
