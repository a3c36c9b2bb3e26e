"""The window: device strip, tabs, banner, log; the rig's dock at the right."""

from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, runtime_checkable

from PySide6.QtCore import QEvent, QLocale, QSignalBlocker, QSize, Qt, QTimer, Signal
from PySide6.QtGui import (
    QAction,
    QCloseEvent,
    QHelpEvent,
    QIcon,
    QKeySequence,
    QPaintEvent,
    QShortcut,
)
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QMainWindow,
    QTabWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from gui.languages.anchors import beside
from gui.languages.shown import shown
from gui.messages import Messages
from gui.widgets.banner import Banner
from gui.widgets.device_strip import DeviceStrip
from gui.widgets.log_drawer import LogDrawer
from gui.widgets.old_label_tip import show_old_label
from gui.widgets.window_menu import WindowMenu

if TYPE_CHECKING:
    # Known to the tabs alone: the empty window is painted before they are imported.
    from core.certificates.measured import Measured
    from core.plans.plan import Plan, Step
    from gui.devices.view import DevicesView
    from gui.preferences.view import PreferencesView
    from gui.services import Addition, Services


_FIRST, _SMALLEST = QSize(1280, 800), QSize(1000, 640)


class Tab(Protocol):
    """One tab of the window."""

    @property
    def widget(self) -> QWidget:
        """What is shown."""
        ...

    def after_paint(self) -> None:
        """The window is on the screen: what is slow to import may come now."""
        ...

    def why_busy(self) -> str:
        """Why the ports cannot be let go of now; empty if they can."""
        ...

    def wanted(self) -> "tuple[Plan, Step] | None":
        """What the operator of the rig has to set now; None for nothing."""
        ...

    def close(self) -> None:
        """The window closes: end what runs, keep what was measured."""
        ...


@runtime_checkable
class PlanTab(Protocol):
    """A tab that measures by plans."""

    def open_plan(self, plan: "Plan") -> bool:
        """Take a plan; False if its test is another one, or something is being measured."""
        ...


@runtime_checkable
class LoadTab(Protocol):
    """A tab that works with files."""

    def load(self, path: Path) -> None:
        """Take a file, or a session's folder."""
        ...


@runtime_checkable
class CalibratingTab(Protocol):
    """A tab that calibrates, and takes effects into its models."""

    def calibrate_with(self, addition: "Addition", show: bool) -> bool:
        """Calibrate a run with further effects.

        Parameters
        ----------
        addition : the run and the effects
        show : take a run that is not on the page too

        Returns
        -------
        False if its tests are others, or the page shows something else.
        """
        ...


@runtime_checkable
class GradingTab(Protocol):
    """A tab that tells what a plan can show."""

    def grade_plan(self, plan: "Plan", passes: int) -> None:
        """Tell what a plan can show that is walked so often."""
        ...


@runtime_checkable
class CertifyingTab(Protocol):
    """A tab that makes certificates."""

    def certify(self, measured: "Measured") -> None:
        """Begin a certificate of results."""
        ...


class TabModule(Protocol):
    """The module of a tab, named in the table of tabs."""

    def make_tab(self, services: "Services") -> Tab:
        """Build the tab."""
        ...


class MainWindow(QMainWindow):
    """Parts in their places; what they show comes from the application.

    Parameters
    ----------
    messages : what banner and log show
    """

    stop_requested = Signal()
    start_requested = Signal()
    closing = Signal()
    painted = Signal()
    """The window stands on the screen for the first time."""

    def __init__(self, messages: Messages) -> None:
        super().__init__()
        self._messages = messages
        self._was_painted = False
        self.strip = DeviceStrip()
        self.tabs = QTabWidget()
        self.tabs.setDocumentMode(True)
        self.banner = Banner()
        self.log = LogDrawer()
        self.menu_button = QToolButton()
        self.menu_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.menu = WindowMenu(self.tabs, self)
        self.menu_button.setMenu(self.menu)
        self.tabs.setCornerWidget(self.menu_button, Qt.Corner.TopRightCorner)
        self.rig_dock = QDockWidget(self)
        self.rig_dock.setObjectName("rig")
        self.rig_dock.setFeatures(
            QDockWidget.DockWidgetFeature.DockWidgetClosable
            | QDockWidget.DockWidgetFeature.DockWidgetMovable
        )
        self.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self.rig_dock)
        self.rig_dock.hide()
        self._adc = QDockWidget(self)
        self._adc.setObjectName("adc")
        self.addDockWidget(Qt.DockWidgetArea.BottomDockWidgetArea, self._adc)
        self._adc.hide()
        self._stop, self._start = QAction(self), QAction(self)
        self._titles: dict[int, str] = {}
        self._hidden: tuple[QDockWidget, ...] = ()
        self._before_distant = self.windowState()
        self._roomy = self._rig_was_open = False
        self._build()
        self._build_menu()
        self._connect()
        self._retranslate()

    def _build(self) -> None:
        centre = QWidget()
        column = QVBoxLayout(centre)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.strip)
        column.addWidget(self.tabs, 1)
        column.addWidget(self.banner)
        column.addWidget(self.log)
        self._column = column
        self.setCentralWidget(centre)
        self.setMinimumSize(_SMALLEST)
        self.setWindowIcon(QIcon(str(resources.files("resources") / "icons" / "calrig.svg")))

    def take_first_size(self) -> None:
        """Take the size of a first start: all of a screen that has little more room than that."""
        self.resize(_FIRST)
        room = self.screen().availableGeometry().size()
        frame = QSize(0, 3 * self.fontMetrics().height())
        fits = (_FIRST + frame).boundedTo(room) == _FIRST + frame
        if not fits and _SMALLEST.boundedTo(room) == _SMALLEST:
            self.setWindowState(Qt.WindowState.WindowMaximized)

    def _build_menu(self) -> None:
        menu = self.menu
        rig, adc = self.rig_dock.toggleViewAction(), self._adc.toggleViewAction()
        rig.setVisible(False)
        adc.setShortcut(QKeySequence("Ctrl+D"))
        menu.insertActions(menu.docks, [rig, adc])
        self.strip.menu.addAction(adc)
        self.strip.menu.addSeparator()
        self.strip.menu.addAction(self._stop)
        self.strip.menu.addAction(self._start)
        self._stop.triggered.connect(self.stop_requested)
        self._start.triggered.connect(self.start_requested)

    def _connect(self) -> None:
        self._messages.shown.connect(self.banner.render)
        self._messages.logged.connect(self.log.append)
        self.banner.action.connect(self._messages.press)
        self.banner.closed.connect(self._messages.dismiss)

    def put_tab(self, place: int, page: QWidget, title: str) -> None:
        """Put a tab's page where its empty one stood."""
        current = self.tabs.currentIndex()
        empty = self.tabs.widget(place)
        # Nobody changes the tab: what stands in front stays there.
        with QSignalBlocker(self.tabs):
            self.tabs.removeTab(place)
            self.tabs.insertTab(place, page, shown(title))
            self._titles[place] = title
            self._tell_english(place)
            self.tabs.setCurrentIndex(current)
        if empty is not None:
            empty.deleteLater()

    def _name_tabs(self) -> None:
        """Tabs in the language of the window."""
        for place, title in self._titles.items():
            self.tabs.setTabText(place, shown(title))
            self._tell_english(place)

    def _tell_english(self, place: int) -> None:
        """The English title stays in the tool tip."""
        title = self._titles[place]
        self.tabs.setTabToolTip(place, title if shown(title) != title else "")

    def put_devices(self, devices: "DevicesView") -> None:
        """Put Device Properties below the strip, closed."""
        self.devices = devices
        devices.hide()
        self._column.insertWidget(1, devices)
        self.strip.properties_requested.connect(self.toggle_devices)
        escape = QShortcut(QKeySequence("Esc"), devices)
        escape.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        escape.activated.connect(devices.hide)

    def toggle_devices(self) -> None:
        """Open or close Device Properties."""
        if self.devices.isVisible():
            self.devices.hide()
        else:
            self.devices.open()

    def put_preferences(self, panel: "PreferencesView") -> None:
        """Put Preferences below the strip, closed."""
        self.preferences = panel
        panel.hide()
        self._column.insertWidget(1, panel)
        self.menu.preferences.triggered.connect(self.toggle_preferences)

    def toggle_preferences(self) -> None:
        """Open or close Preferences."""
        if self.preferences.isVisible():
            self.preferences.hide()
        else:
            self.preferences.open()

    def put_adc(self, panel: QWidget) -> None:
        """Put View ADC Data into its dock, which stands in every tab."""
        self._adc.setWidget(panel)

    def show_rig(self, panel: QWidget | None) -> None:
        """Dock the rig, or take it away."""
        if panel is not None and self.rig_dock.widget() is not panel:
            self.rig_dock.setWidget(panel)
            width = panel.minimumSizeHint().width()
            self.resizeDocks([self.rig_dock], [width], Qt.Orientation.Horizontal)
        self._rig_was_open = panel is not None
        self.rig_dock.setVisible(panel is not None and not self._roomy)
        self.rig_dock.toggleViewAction().setVisible(panel is not None)

    def make_room(self, needed: bool) -> None:
        """Take the rig away where it is of no use, and bring it back as it was elsewhere."""
        if needed == self._roomy:
            return
        self._roomy = needed
        if needed:
            self._rig_was_open = self.rig_dock.isVisible()
            focus, page = QApplication.focusWidget(), self.tabs.currentWidget()
            if page is not None and focus is not None and self.rig_dock.isAncestorOf(focus):
                # Else Qt hands the keys to the device strip, where digits choose a device.
                (page.focusWidget() or page).setFocus(Qt.FocusReason.OtherFocusReason)
            self.rig_dock.hide()
        elif self._rig_was_open:
            self.rig_dock.show()

    def set_distant(self, distant: bool) -> None:
        """Give the whole screen to what is laid over the window, or take it back."""
        if distant:
            self._before_distant = self.windowState()
            self._hidden = tuple(d for d in (self.rig_dock, self._adc) if d.isVisible())
            for dock in self._hidden:
                dock.hide()
            self.setWindowState(self._before_distant | Qt.WindowState.WindowFullScreen)
        else:
            self.setWindowState(self._before_distant)
            for dock in self._hidden:
                if dock is self.rig_dock and self._roomy:
                    self._rig_was_open = True
                else:
                    dock.show()
            self._hidden = ()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._was_painted:
            self._was_painted = True
            QTimer.singleShot(0, self.painted.emit)

    def closeEvent(self, event: QCloseEvent) -> None:
        self.closing.emit()
        super().closeEvent(event)

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            return show_old_label(event)
        return super().event(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self.setWindowTitle("CalRig")
        # All widgets inside, also those to come, write numbers like the window.
        self.setLocale(QLocale())
        self._name_tabs()
        self.menu_button.setText(self.tr("Menu"))
        # A button drops its key with every change of its text.
        self.menu_button.setShortcut(QKeySequence("F10"))
        self.menu_button.setToolTip(self.tr("Look, sounds, keys, preferences (F10)"))
        self.rig_dock.setWindowTitle(self.tr("Simulated rig"))
        self._adc.setWindowTitle(beside(self.tr("View ADC Data")))
        self._stop.setText(beside(self.tr("Stop Device")))
        self._start.setText(self.tr("Start Device"))
