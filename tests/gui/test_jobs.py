"""Worker threads and where their results arrive."""

import threading

import pytest
from PySide6.QtCore import QObject
from pytestqt.qtbot import QtBot

from core.errors import LabError, StorageError
from gui.jobs import Jobs


class Receiver(QObject):
    """Notes what arrives and in which thread."""

    def __init__(self) -> None:
        super().__init__()
        self.came: list[object] = []
        self.threads: list[threading.Thread] = []

    def take(self, result: object) -> None:
        self.came.append(result)
        self.threads.append(threading.current_thread())

    def refuse(self, error: LabError) -> None:
        self.take(error)


def test_the_work_runs_elsewhere_and_its_result_arrives_here(qtbot: QtBot):
    jobs, receiver = Jobs(), Receiver()
    worker: list[threading.Thread] = []

    def work() -> int:
        worker.append(threading.current_thread())
        return 42

    jobs.start("sum", work, receiver.take, receiver.refuse)
    qtbot.waitUntil(lambda: receiver.came == [42])
    assert receiver.threads == [threading.main_thread()]
    assert worker[0] is not threading.main_thread()
    jobs.close()


def test_an_error_for_the_operator_arrives_as_one(qtbot: QtBot):
    jobs, receiver = Jobs(), Receiver()

    def work() -> None:
        raise StorageError("the disk is full")

    jobs.start("store", work, receiver.take, receiver.refuse)
    qtbot.waitUntil(lambda: len(receiver.came) == 1)
    assert isinstance(receiver.came[0], StorageError)
    jobs.close()


def test_a_fault_of_the_program_is_raised_in_the_window_s_thread(qtbot: QtBot):
    jobs, receiver = Jobs(), Receiver()
    hooked: list[threading.ExceptHookArgs] = []
    before, threading.excepthook = threading.excepthook, hooked.append
    try:
        with qtbot.captureExceptions() as faults:
            jobs.start("break", lambda: 1 // 0, receiver.take, receiver.refuse)
            qtbot.waitUntil(lambda: bool(faults))
    finally:
        threading.excepthook = before
    assert faults[0][0] is ZeroDivisionError
    assert receiver.came == []
    jobs.close()


def test_a_function_is_refused_since_it_would_run_in_the_worker():
    jobs, receiver = Jobs(), Receiver()
    with pytest.raises(TypeError, match="would run in the worker"):
        jobs.start("no", lambda: 1, lambda _: None, receiver.refuse)
