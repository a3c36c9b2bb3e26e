"""The distance view: laid over the window, and fed by the tab below it."""

from typing import TypeVar

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QPoint

from gui.main_window import MainWindow
from gui.messages import Messages
from gui.widgets.distance_view import DistanceView
from gui.widgets.stage import Stage
from gui.widgets.states import BannerState
from gui.widgets.step_list import StepList

W = TypeVar("W", Stage, StepList)

_PLACED = (QEvent.Type.Resize, QEvent.Type.Move, QEvent.Type.Show, QEvent.Type.Hide)


class Distance(QObject):
    """Puts the stage of the shown tab over everything but the banner, and takes it away again.

    The row of actions stays alive below, so that every key and every pedal does what it always
    does; digits and arrows go to the list of steps.

    Parameters
    ----------
    window : of the program
    messages : whose banner stays in sight
    """

    def __init__(self, window: MainWindow, messages: Messages) -> None:
        super().__init__(window)
        self._window = window
        self._stage: Stage | None = None
        self.view = DistanceView(window)
        self.view.hide()
        self.view.left.connect(self.leave)
        self.view.typed.connect(self._on_typed)
        messages.shown.connect(self._on_banner)
        window.menu.distance.triggered.connect(self.toggle)
        window.tabs.currentChanged.connect(self._on_tab)
        for widget in (window, window.banner):
            widget.installEventFilter(self)
        self._on_tab()

    def toggle(self) -> None:
        """Open the view, or leave it."""
        if self.view.isVisible():
            self.leave()
        else:
            self.enter()

    def enter(self) -> None:
        """Show the step of the tab; nothing happens in a tab that has none."""
        stage = self._here(Stage)
        if stage is None:
            return
        self._follow(stage)
        self._window.set_distant(True)
        self._place()
        self.view.show()
        self.view.raise_()
        self.view.setFocus()

    def leave(self) -> None:
        """Back to the window as it was."""
        if not self.view.isVisible():
            return
        self._follow(None)
        self.view.hide()
        self._window.set_distant(False)
        steps = self._here(StepList)
        if steps is not None:
            steps.setFocus()

    def _here(self, kind: type[W]) -> W | None:
        page = self._window.tabs.currentWidget()
        return None if page is None else page.findChild(kind)

    def _follow(self, stage: Stage | None) -> None:
        """Show what this stage shows, from now on."""
        if self._stage is not None:
            self._stage.rendered.disconnect(self.view.render)
        self._stage = stage
        if stage is not None:
            stage.rendered.connect(self.view.render)
            self.view.set_place(self._window.tabs.tabText(self._window.tabs.currentIndex()))
            self.view.render(stage.state)

    def _place(self) -> None:
        window, banner = self._window, self._window.banner
        whole = window.rect()
        if banner.isVisible():
            whole.setBottom(banner.mapTo(window, QPoint()).y() - 1)
        self.view.setGeometry(whole)

    def _on_tab(self) -> None:
        stage = self._here(Stage)
        self._window.menu.distance.setEnabled(stage is not None)
        if self.view.isVisible():
            if stage is None:
                self.leave()
            else:
                self._follow(stage)

    def _on_banner(self, banner: BannerState | None) -> None:
        self.view.doubt(banner)

    def _on_typed(self, event: QEvent) -> None:
        steps = self._here(StepList)
        if steps is not None:
            QCoreApplication.sendEvent(steps, event)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # While Python lets go of it, it is still asked and has no members any more.
        if event.type() in _PLACED and "view" in self.__dict__ and self.view.isVisible():
            self._place()
        return super().eventFilter(watched, event)
