"""The stage of a measuring tab in a window of 1280 x 800, after another look, with little room."""

from collections.abc import Callable

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QApplication

from gui.widgets.theme import apply_theme
from tests.gui.window_driver import Driver


def test_no_line_is_cut_and_nothing_overlaps(open_app: Callable[[], Driver], qapp: QApplication):
    driver = open_app()
    window, view = driver.app.window, driver.tab.view
    window.resize(QSize(1280, 800))
    driver.app.open_simulated("pointer?speed=20")
    driver.bot.waitUntil(lambda: driver.tab.sitting.walk.status is not None, timeout=10000)
    stage, detail = view.stage, view.stage._detail
    for look in ("dark", "light"):
        apply_theme(qapp, look)
        driver.bot.wait(100)
        assert "Space" in detail.text()
        assert detail.height() >= detail.heightForWidth(detail.width())
    window.strip.menu.actions()[0].trigger()
    driver.bot.wait(100)
    assert detail.height() >= detail.heightForWidth(detail.width())
    assert stage.height() + view._lower.height() <= view._middle.height()
