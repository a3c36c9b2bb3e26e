"""The line of names above a plot."""

from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from gui.widgets.colours import THEMES
from gui.widgets.legend import POINT, Legend, LegendEntry
from gui.widgets.theme import apply_theme


def test_names_stand_in_the_colours_of_the_look(qtbot: QtBot) -> None:
    qt = QApplication.instance()
    assert isinstance(qt, QApplication)
    legend = Legend()
    qtbot.addWidget(legend)
    legend.show()
    legend.set_entries((LegendEntry("a < b", 1), LegendEntry("cooled", 0, POINT)))
    for look in ("dark", "light"):
        apply_theme(qt, look)
        assert THEMES[look].curves[1] in legend.text()
        assert "a&nbsp;&lt;&nbsp;b" in legend.text()
        assert legend.text().count(POINT) == 1
