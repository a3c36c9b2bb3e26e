"""Hands and eyes of an operator at the real window, for the tests."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QPushButton
from pytestqt.exceptions import TimeoutError
from pytestqt.qtbot import QtBot

from core.plans.plan import Step
from drivers.virtual.pty_process import PtyProcess
from gui.app import Application
from gui.dividing_head.tab import HeadTab

SPEED = 20
"""The rig's time goes so much faster than ours."""


class Driver:
    """Hands and eyes of an operator at the window."""

    def __init__(self, app: Application, qtbot: QtBot) -> None:
        self.app = app
        self.bot = qtbot
        tab = app.tabs["Dividing head"]
        assert isinstance(tab, HeadTab)
        self.tab = tab

    def connect(self, port: str) -> None:
        """Device Properties: type the port, Scan, OK."""
        window = self.app.window
        self.click(window.strip._properties)
        self.until(lambda: bool(self.app.devices.state.ports))
        row = window.devices._rows[0]
        line = row.port.lineEdit()
        assert line is not None
        line.selectAll()
        self.bot.keyClicks(line, port)
        self.bot.keyClick(line, Qt.Key.Key_Tab)
        self.click(window.devices._scan)
        self.until(lambda: bool(self.app.devices.state.rows[0].profile_id), 20_000)
        self.click(window.devices._ok)
        self.until(lambda: self.tab.bench.linked)

    def click(self, widget: object) -> None:
        """Press the left mouse button on a widget."""
        self.bot.mouseClick(widget, Qt.MouseButton.LeftButton)

    def key(self, key: Qt.Key, modifier: Qt.KeyboardModifier | None = None) -> None:
        """Press a key where the focus is."""
        target = QApplication.focusWidget() or self.app.window
        self.bot.keyClick(target, key, modifier or Qt.KeyboardModifier.NoModifier)

    def until(self, condition: Callable[[], bool], milliseconds: int = 15_000) -> None:
        """Wait; no modal dialog may come up meanwhile."""

        def come() -> bool:
            assert QApplication.activeModalWidget() is None
            return condition()

        try:
            self.bot.waitUntil(come, timeout=milliseconds)
        except TimeoutError as error:
            stage = self.tab.presenter.state.stage
            pytest.fail(f"{error}; stage: {stage}; banner: {self.app.messages.current}")

    def press(self, action: str) -> None:
        """A button of the row of actions."""
        self.click(self.tab.view.action_bar.button(action))

    def answer(self, text: str) -> None:
        """A button of the banner."""

        def buttons() -> list[QPushButton]:
            found = self.app.window.banner.findChildren(QPushButton)
            return [b for b in found if b.isVisible() and b.text() == text]

        self.until(lambda: bool(buttons()))
        self.click(buttons()[0])

    @property
    def count(self) -> int:
        """Positions that count."""
        return len(self.tab.sitting.keeper.positions)

    @property
    def step(self) -> Step:
        """The step that the stage asks for."""
        status = self.tab.sitting.walk.status
        assert status is not None
        assert status.step is not None
        return status.step

    def set_head(self, rig: PtyProcess, step: Step) -> None:
        """Do what a step asks of the head, and wait until all is at rest."""
        rig.order(remount=step.mount)
        rig.order(turn=step.head_deg)
        self.until(lambda: not self._moves(rig))
        # What rings dies away, and what is under way arrives.
        self.bot.wait(round(1000 * 1.5 / SPEED) + 150)

    @staticmethod
    def _moves(rig: PtyProcess) -> bool:
        state = rig.order(state=True)["state"]
        assert isinstance(state, dict)
        return bool(state["moving"])

    def measure(self, rig: PtyProcess) -> None:
        """Set the step that the stage asks for, and accumulate it."""
        before = self.count
        self.set_head(rig, self.step)
        self.key(Qt.Key.Key_Space)
        self.until(lambda: self.tab.sitting.walk.measuring)
        self.until(lambda: self.count == before + 1)
