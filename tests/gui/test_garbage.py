"""Dead objects of Qt in reference cycles are destroyed in the thread that they live in."""

import gc
import threading

from PySide6.QtCore import QObject
from pytestqt.qtbot import QtBot

from gui.garbage import Collector


class Knot(QObject):
    """A QObject that only the cyclic collector can free."""

    def __init__(self, died: list[threading.Thread]) -> None:
        super().__init__()
        self.myself = self
        self._died = died

    def __del__(self) -> None:
        self._died.append(threading.current_thread())


def churn() -> None:
    """Allocate far beyond the thresholds of the collector."""
    for _ in range(20):
        pile = [[i] for i in range(10_000)]
        pile.clear()


def test_a_worker_frees_nothing_and_the_timer_does(qtbot: QtBot):
    collector = Collector()
    collector.settle()
    died: list[threading.Thread] = []
    try:
        for _ in range(1000):
            Knot(died)
        worker = threading.Thread(target=churn)
        worker.start()
        worker.join()
        assert died == []
        qtbot.waitUntil(lambda: len(died) == 1000, timeout=5000)
        assert set(died) == {threading.main_thread()}
    finally:
        collector.close()
    assert gc.isenabled()


def test_what_is_there_at_the_start_is_looked_at_no_more():
    collector = Collector()
    collector.settle()
    assert gc.get_freeze_count() > 1000
    collector.close()
    assert gc.get_freeze_count() == 0
