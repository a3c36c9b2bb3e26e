"""The tour: offered once, started from the menu at any time, left at any time."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, QTimer

from core.errors import Severity
from gui.main_window import MainWindow
from gui.measuring.view import MeasuringView
from gui.messages import Messages
from gui.settings import Settings
from gui.tour.steps import Place, tour_steps
from gui.tour.view import Callout, Frame
from gui.widgets.states import BannerAction, BannerState

_SOURCE = "tour"
_SECTION = "tour"
_FOLLOW_MS = 200
"""So often the callout looks whether what it points at has moved."""


class Tour(QObject):
    """Callouts over the first tab, beside the work and never in its way.

    Parameters
    ----------
    window : of the program
    page : the tab that is shown, of the dividing head
    messages : where it is offered
    settings : where it is remembered that it was
    connect : connects the simulated rig, if nothing is connected
    """

    _number = -1
    """The step on the screen; of the class, since a filter may be asked while Python lets it go."""

    def __init__(
        self,
        window: MainWindow,
        page: MeasuringView,
        messages: Messages,
        settings: Settings,
        connect: Callable[[], None],
    ) -> None:
        super().__init__(window)
        self._window = window
        self._page = page
        self._messages = messages
        self._settings = settings
        self._connect = connect
        self._number = -1
        self.callout = Callout(window)
        self.frame = Frame(window)
        self.callout.onward.connect(self._on_next)
        self.callout.back.connect(self._on_back)
        self.callout.left.connect(self.leave)
        self._timer = QTimer(self, interval=_FOLLOW_MS)
        self._timer.timeout.connect(self._stand)
        window.menu.tour.triggered.connect(self.start)
        window.installEventFilter(self)
        messages.action.connect(self._on_action)

    @property
    def number(self) -> int:
        """The step that is shown, from 0; -1 while there is no tour."""
        return self._number

    def offer(self) -> None:
        """Offer the tour, if it never was."""
        if self._settings.section(_SECTION).get("offered") is True:
            return
        self._settings.store(_SECTION, {"offered": True})
        self._messages.show(
            _SOURCE,
            BannerState(
                Severity.INFO,
                "New to CalRig?",
                "A tour on the simulated rig shows the window in two minutes; it also waits in"
                " Menu, Help.",
                "",
                (BannerAction("start", "Start the tour"), BannerAction("leave", "Not now")),
            ),
        )

    def start(self) -> None:
        """Begin with the first step."""
        self._messages.clear(_SOURCE)
        self._connect()
        self._window.tabs.setCurrentWidget(self._page)
        self._timer.start()
        self._go(0)

    def leave(self) -> None:
        """End the tour; what was measured meanwhile stays."""
        self._number = -1
        self._timer.stop()
        self.callout.hide()
        self.frame.hide()
        self._page.steps.setFocus(Qt.FocusReason.OtherFocusReason)

    def _go(self, number: int) -> None:
        steps = tour_steps()
        self._number = number
        step = steps[number]
        self.callout.show_step(step.title, step.text, number + 1, len(steps))
        self._stand()
        self.callout.next.setFocus(Qt.FocusReason.OtherFocusReason)

    def _on_next(self) -> None:
        if self._number + 1 < len(tour_steps()):
            self._go(self._number + 1)
        else:
            self.leave()

    def _on_back(self) -> None:
        self._go(max(0, self._number - 1))

    def _on_action(self, source: str, key: str) -> None:
        if source == _SOURCE:
            if key == "start":
                self.start()
            else:
                self._messages.clear(_SOURCE)

    def _stand(self) -> None:
        """Frame what the step speaks of; in another tab the callout waits in the middle."""
        area = self._area(tour_steps()[self._number].place)
        if area is None:
            self.frame.hide()
            area = QRect(self._window.rect().center(), self._window.rect().center())
        else:
            self.frame.surround(area)
        self.callout.stand_beside(area)
        self.callout.raise_()

    def _area(self, place: Place) -> QRect | None:
        window, page = self._window, self._page
        widget = {
            Place.STRIP: window.strip,
            Place.STEPS: page.steps,
            Place.STAGE: page.stage,
            Place.SETTINGS: page.settings,
            Place.ACTIONS: page.action_bar,
            Place.RIG: window.rig_dock,
            Place.TABS: window.tabs.tabBar(),
            Place.MENU: window.menu_button,
        }[place]
        if not widget.isVisible():
            return None
        area = QRect(widget.mapTo(window, QPoint()), widget.size())
        # What a scroll area hides is not framed.
        around = widget.parentWidget()
        while around is not None and around is not window:
            area &= QRect(around.mapTo(window, QPoint()), around.size())
            around = around.parentWidget()
        return area

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if self._number >= 0 and event.type() == QEvent.Type.Resize:
            self._stand()
        elif self._number >= 0 and event.type() == QEvent.Type.LanguageChange:
            QTimer.singleShot(0, self, lambda: self._go(self._number))
        return super().eventFilter(watched, event)
