import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget

from gui.widgets.action_bar import ActionBar
from gui.widgets.fields import ChoiceField, NumberField
from gui.widgets.states import ActionBarState, measuring_actions


class Page(QWidget):
    def __init__(self) -> None:
        super().__init__()
        self.seconds = NumberField(1.0, 600.0, 1, "s")
        self.count = NumberField(1, 9)
        self.choice = ChoiceField()
        self.choice.addItems(["None", "Auto", "Manual"])
        self.bar = ActionBar()
        self.pressed: list[str] = []
        self.bar.triggered.connect(self.pressed.append)
        self.bar.render(ActionBarState(measuring_actions(("accumulate",))))
        layout = QVBoxLayout(self)
        for part in (self.seconds, self.count, self.choice, self.bar):
            layout.addWidget(part)


@pytest.fixture
def page(qtbot):
    widget = Page()
    qtbot.addWidget(widget)
    with qtbot.waitActive(widget):
        widget.show()
        widget.activateWindow()
    return widget


def turn(widget):
    place = QPointF(5, 5)
    QApplication.sendEvent(
        widget,
        QWheelEvent(
            place,
            QPointF(widget.mapToGlobal(QPoint(5, 5))),
            QPoint(),
            QPoint(0, -120),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        ),
    )


def test_space_is_the_default_action_in_number_fields(page, qtbot):
    for field in (page.seconds, page.count):
        field.setFocus()
        qtbot.keyClick(field, Qt.Key.Key_Space)
    assert page.pressed == ["accumulate", "accumulate"]


def test_numbers_are_typed_and_taken_over_at_the_end(page, qtbot):
    told = []
    page.seconds.valueChanged.connect(told.append)
    page.seconds.setFocus()
    page.seconds.selectAll()
    qtbot.keyClicks(page.seconds, "30")
    assert told == []
    qtbot.keyClick(page.seconds, Qt.Key.Key_Return)
    assert told == [30.0]
    assert page.seconds.text().endswith(" s")


def test_the_wheel_changes_only_what_is_in_use(page):
    page.seconds.setValue(10.0)
    page.count.setValue(5)
    page.bar.setFocus()
    for field in (page.seconds, page.count, page.choice):
        turn(field)
    assert (page.seconds.value(), page.count.value(), page.choice.currentIndex()) == (10.0, 5, 0)
    page.seconds.setFocus()
    turn(page.seconds)
    page.choice.setFocus()
    turn(page.choice)
    assert page.seconds.value() == 9.0
    assert page.choice.currentIndex() == 1


def test_a_choice_that_does_not_fit_ends_in_dots(qtbot):
    choice, twin = ChoiceField(), ChoiceField()
    choice.addItems(["short", "a choice of which the end would not be seen"])
    twin.addItem("")
    for field in (choice, twin):
        qtbot.addWidget(field)
        field.setFixedWidth(160)
        field.show()
    assert not choice.is_cut()
    choice.setCurrentIndex(1)
    assert choice.is_cut()
    metrics, elide = choice.fontMetrics(), Qt.TextElideMode.ElideRight
    twin.setItemText(0, metrics.elidedText(choice.currentText(), elide, choice.room()))
    assert twin.currentText().endswith("…")
    assert not twin.is_cut()
    assert choice.grab().toImage() == twin.grab().toImage()
