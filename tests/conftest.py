"""What holds for every test: no screen, nothing left behind, the same examples each time in CI."""

import gc
import os
import sys
import threading
import time
from collections.abc import Iterator

import hypothesis
import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the launcher sets it

hypothesis.settings.register_profile("desk", deadline=None)
hypothesis.settings.register_profile("ci", deadline=None, derandomize=True, database=None)
hypothesis.settings.load_profile("ci" if os.environ.get("CI") else "desk")

PATIENCE = 2.0
"""Seconds that a thread which was told to end may take."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the files that take long, so that none of them is left for one process alone."""
    long = {item.path for item in items if item.get_closest_marker("slow") is not None}
    items.sort(key=lambda item: item.path not in long)


@pytest.fixture(autouse=True)
def no_thread_left() -> Iterator[None]:
    """Fail a test that leaves a thread running."""
    before = _threads()
    yield
    deadline = time.monotonic() + PATIENCE
    while (left := _threads() - before) and time.monotonic() < deadline:
        left.pop().join(0.01)
    assert not left, f"threads left running: {sorted(thread.name for thread in left)}"


def _threads() -> set[threading.Thread]:
    # Python keeps a dummy for each thread of Qt's in which it ever ran, even after that has ended.
    return {
        thread for thread in threading.enumerate() if not isinstance(thread, threading._DummyThread)
    }


@pytest.fixture(autouse=True)
def no_window_left() -> Iterator[None]:
    """Fail a test that leaves a top-level widget; ``qtbot.addWidget`` takes care of one."""
    before = _windows().keys()
    yield
    if _windows().keys() - before:
        # What nobody holds any more may still hang in a reference cycle, as pyqtgraph's menus do.
        gc.collect()
    left = [name for address, name in _windows().items() if address not in before]
    assert not left, f"windows left: {left}"


def _windows() -> dict[int, str]:
    """Names of all top-level widgets by their addresses in Qt."""
    widgets = sys.modules.get("PySide6.QtWidgets")
    if widgets is None or widgets.QApplication.instance() is None:
        return {}
    core = sys.modules["PySide6.QtCore"]
    core.QCoreApplication.sendPostedEvents(None, core.QEvent.Type.DeferredDelete)
    address = sys.modules["shiboken6"].getCppPointer
    return {
        address(widget)[0]: f"{type(widget).__name__} {widget.windowTitle()!r}"
        for widget in widgets.QApplication.topLevelWidgets()
    }
