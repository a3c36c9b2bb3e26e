"""The application: makes every part and joins them; nothing else knows more than its own part."""

import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QByteArray, QObject, QStandardPaths, QTimer, Signal
from PySide6.QtWidgets import QApplication, QWidget

from core.errors import FormatError, LabError, Severity
from gui.garbage import Collector
from gui.hooks import hook_errors, hook_signals
from gui.jobs import Jobs
from gui.languages.choice import SYSTEM, Languages
from gui.languages.shown import shown
from gui.main_window import MainWindow, Tab
from gui.messages import Messages
from gui.settings import Settings, folder_of, number_of, text_of
from gui.widgets.sound import Cue, Sounds
from gui.widgets.states import BannerAction, BannerState
from gui.widgets.theme import apply_theme
from gui.widgets.window_menu import LOOKS, VOLUMES

if TYPE_CHECKING:
    from core.plans.plan import Plan, Step
    from drivers.profile import Profile
    from gui.tab_maker import TabMaker

TABS: dict[str, str] = {
    "Dividing head": "gui.dividing_head.tab",
    "Rate table": "gui.rate_table.tab",
    "Accuracy": "gui.accuracy.tab",
    "Live": "gui.live.tab",
    "Allan": "gui.allan.tab",
    "Thermal": "gui.thermal.tab",
    "Drift": "gui.drift.tab",
    "Methods": "gui.methods.tab",
    "Model vs data": "gui.discrepancy.tab",
    "Archive": "gui.archive.tab",
    "Teach a board": "gui.frames.tab",
    "Certificates": "gui.certificate.tab",
}
"""Every tab of the window: its title and the module that makes it."""

_WITHOUT_RIG = ("Thermal", "Drift", "Model vs data", "Archive", "Teach a board", "Certificates")
"""Tabs without a use for the rig: there its dock gives its room to tables."""
_WELCOME, _PROPERTIES = "welcome", "properties"
_CUES = {"start": Cue.START, "done": Cue.DONE, "error": Cue.ERROR}


@dataclass(frozen=True, slots=True)
class Options:
    """How the program is started.

    Parameters
    ----------
    simulated : device of the simulated rig (``"pointer"``) or its whole address; empty for none
    root : folder of all sessions; None for the user's own
    settings : file of the preferences; None for the user's own
    quiet : no sounds and no offer of a tour, whatever the preferences say
    """

    simulated: str = ""
    root: Path | None = None
    settings: Path | None = None
    quiet: bool = False


class Application(QObject):
    """All parts of the program.

    Parameters
    ----------
    qt : Qt's application
    options : how it was started
    """

    usable = Signal()
    """The tab on the screen is there, and the ports of the last time are being opened."""
    ready = Signal()
    """All tabs are there, and what helps beside them."""

    def __init__(self, qt: QApplication, options: Options) -> None:
        super().__init__()
        self._collector = Collector(self)
        self._qt = qt
        self._options = options
        self.settings = Settings(options.settings or _settings_path())
        self._root = options.root or folder_of(self.settings) or _default_root()
        self.messages = Messages(self)
        self.jobs = Jobs(self)
        self.sounds = Sounds(parent=self)
        self.tabs: dict[str, Tab] = {}
        self._made = False
        self._maker: TabMaker | None = None
        self._rig_panel: QWidget | None = None
        section = self.settings.section("window")
        look = text_of(section, "look", "system")
        self._look = look if look in LOOKS else "system"
        apply_theme(qt, self._look)
        self.languages = Languages(text_of(section, "language", SYSTEM), self)
        self.window = MainWindow(self.messages)
        for title in TABS:
            self.window.tabs.addTab(QWidget(), shown(title))
        self.window.menu.put_tabs(tuple(TABS))
        self._restore()

    def start(self) -> None:
        """Show the empty window; the parts come once it stands on the screen."""
        self.window.painted.connect(self._make_parts)
        self.window.show()

    def close(self) -> None:
        """Let go of everything; may be called again."""
        if self._maker is not None:
            self._maker.stop()
        for tab in self.tabs.values():
            tab.close()
        if self._made:
            self.connection.close()
        self.jobs.close()
        self.sounds.stop()
        self._remember()
        self._collector.close()

    def open_simulated(self, device: str) -> None:
        """Connect to the simulated rig."""
        from drivers.virtual.address import rig_of
        from gui.devices.setup import DeviceSetup

        url = device if "://" in device else f"sim://{device}"
        try:
            rig = rig_of(url)
        except ValueError as error:
            remedy = "Start with pointer, clbacc, or a whole sim:// address."
            banner = BannerState(Severity.ERROR, "No such rig", f"{error}.", remedy)
            self.messages.show("rig", banner)
            return
        profile = rig.profile
        name = rig.identity.get("serial") or profile.name
        self.connection.open([DeviceSetup(url, profile.port.bauds[0], profile.id, name)])

    # --- joining ----------------------------------------------------------------------------------

    def _make_parts(self) -> None:
        """Import and make what stands behind the tab on the screen: numpy, the drivers."""
        from gui.devices.adc import AdcPresenter
        from gui.devices.adc_view import AdcPanel
        from gui.devices.connection import Connection
        from gui.devices.presenter import DevicesPresenter
        from gui.devices.setup import setups_of_section
        from gui.devices.stopping import Stopping
        from gui.devices.view import DevicesView
        from gui.handing import Handing
        from gui.nearest import NearestCalibrations
        from gui.services import Services
        from gui.tab_maker import TabMaker

        self.connection = Connection(self._profiles, self._raw_folder, self.messages, self)
        self.devices = DevicesPresenter(
            self.connection, self._profiles, self.jobs, self.messages, self._why_busy, self
        )
        self.devices.show_setups(setups_of_section(self.settings.section("devices")))
        self.window.put_devices(DevicesView(self.devices))
        self.stopping = Stopping(self.connection, self.messages, self._why_busy, self)
        near = NearestCalibrations(lambda: self._root).find
        self.adc = AdcPresenter(self.connection, self.jobs, near, self)
        self.window.put_adc(AdcPanel(self.adc))
        self._connect()
        handing = Handing(self._all_tabs, self._show_tab)
        services = Services(
            self.connection,
            self.jobs,
            self.messages,
            self.settings,
            self._profiles,
            lambda: self._root,
            self._play,
            handing.open_plan,
            handing.open_file,
            handing.certify,
            handing.read_measured,
            self._why_busy,
            handing.calibrate_with,
            handing.grade_plan,
            near,
        )
        self._maker = TabMaker(TABS, self.tabs, self.window, services, self)
        self._maker.complete.connect(self._on_complete)
        self._maker.make_current()
        self._made = True
        QTimer.singleShot(0, self._open_ports)

    def _connect(self) -> None:
        window, connection = self.window, self.connection
        connection.strip.connect(window.strip.render)
        connection.changed.connect(self._on_port)
        connection.properties_wanted.connect(window.devices.open)
        window.strip.device_chosen.connect(connection.select)
        window.tabs.currentChanged.connect(self._on_tab)
        window.stop_requested.connect(self.stopping.stop)
        window.start_requested.connect(self.stopping.start)
        connection.changed.connect(self._on_welcomed)
        self.messages.action.connect(self._on_action)
        self.devices.accepted.connect(self._remember)

    def _restore(self) -> None:
        section = self.settings.section("window")
        geometry = text_of(section, "geometry")
        if not (geometry and self.window.restoreGeometry(QByteArray.fromHex(geometry.encode()))):
            self.window.take_first_size()
        menu = self.window.menu
        menu.show_look(self._look)
        self.sounds.set_volume(number_of(section, "volume", VOLUMES["normal"], 0.0, 1.0))
        menu.show_volume(self.sounds.volume)
        menu.look_chosen.connect(self._on_look)
        menu.show_language(self.languages.choice)
        menu.language_chosen.connect(self._on_language)
        menu.volume_chosen.connect(self._on_volume)
        self.window.closing.connect(self.close)
        for doubt in (self.settings.doubt, self.languages.doubt):
            if doubt:
                self.messages.log(Severity.WARNING, doubt)

    def _open_ports(self) -> None:
        setups = self.devices.state.rows
        known = all(setup.url and setup.profile_id for setup in setups)
        if self._options.simulated:
            self.open_simulated(self._options.simulated)
        elif known and not any(setup.simulated for setup in setups):
            self.connection.open(setups)
        else:
            self.messages.show(_WELCOME, _welcome())
        self.usable.emit()
        if self._maker is not None:
            self._maker.make_rest()

    def _on_complete(self) -> None:
        from gui.guidance import Guidance

        self.guidance = Guidance(
            self.window,
            self.messages,
            self.settings,
            lambda: self._root,
            self.tabs,
            self._connect_rig,
        )
        if not self._options.quiet:
            self.guidance.tour.offer()
        self._collector.settle()
        self.ready.emit()

    def _remember(self) -> None:
        """Keep what was chosen at once: a program may end without being closed."""
        if self._made:
            from gui.devices.setup import setups_to_section

            setups = self.connection.setups or self.devices.state.rows
            self.settings.store("devices", setups_to_section(setups))
        geometry = bytes(self.window.saveGeometry().toHex().data()).decode()
        self.settings.store(
            "window",
            {
                "look": self._look,
                "volume": self.sounds.volume,
                "geometry": geometry,
                "language": self.languages.choice,
            },
        )
        try:
            self.settings.save()
        except LabError as error:
            self.messages.log(Severity.WARNING, str(error))

    # --- what the parts ask -----------------------------------------------------------------------

    def _profiles(self) -> "Mapping[str, Profile]":
        from drivers.profile import load_profiles

        try:
            return load_profiles(self._root / "devices")
        except FormatError as error:
            self.messages.tell_error("profiles", "A device file is refused", error)
            return load_profiles()

    def _raw_folder(self) -> Path:
        return self._root / "raw"

    def _all_tabs(self) -> "Mapping[str, Tab]":
        return self.tabs if self._maker is None else self._maker.all()

    def _show_tab(self, tab: Tab) -> None:
        self.window.tabs.setCurrentWidget(tab.widget)

    def _why_busy(self) -> str:
        return next((why for tab in self.tabs.values() if (why := tab.why_busy())), "")

    def _play(self, cue: str) -> None:
        if not self._options.quiet:
            self.sounds.play(_CUES[cue])

    def _connect_rig(self) -> None:
        """Give the tour its device; one that is connected is left alone."""
        if self.connection.link is None:
            self.open_simulated("pointer")

    def _wanted(self) -> "tuple[Plan, Step] | None":
        widget = self.window.tabs.currentWidget()
        tab = next((tab for tab in self.tabs.values() if tab.widget is widget), None)
        return None if tab is None else tab.wanted()

    def _on_port(self) -> None:
        link = self.connection.link
        if link is None or not link.setup.simulated:
            self.window.show_rig(None)
            return
        if self._rig_panel is None:
            from gui.rig.presenter import RigPresenter
            from gui.rig.view import RigPanel

            self.rig = RigPresenter(self.connection, self._wanted, self)
            self._rig_panel = RigPanel(self.rig)
            self.rig.follow()
        self.window.show_rig(self._rig_panel)

    def _on_tab(self) -> None:
        here = self.window.tabs.currentIndex()
        self.window.make_room(here >= 0 and tuple(TABS)[here] in _WITHOUT_RIG)

    def _on_welcomed(self) -> None:
        if self.connection.link is not None:
            self.messages.clear(_WELCOME)

    def _on_action(self, source: str, key: str) -> None:
        if source == _WELCOME:
            if key == _PROPERTIES:
                self.window.devices.open()
            else:
                self.open_simulated(key)

    def _on_look(self, look: str) -> None:
        self._look = look
        self.window.menu.show_look(look)
        apply_theme(self._qt, look)
        self._remember()

    def _on_language(self, choice: str) -> None:
        """Speak another language; what paints its words itself is painted once Qt has told all."""
        self.languages.choose(choice)
        self._remember()
        QTimer.singleShot(0, lambda: [widget.update() for widget in self._qt.allWidgets()])

    def _on_volume(self, volume: float) -> None:
        """Take a loudness, and let it be heard."""
        self.sounds.set_volume(volume)
        self._play("done")
        self._remember()


def run(options: Options) -> int:
    """Open the window and stay until it is closed; return the exit code."""
    qt = QApplication(sys.argv[:1])
    qt.setApplicationName("CalRig")
    qt.setApplicationDisplayName("CalRig")
    application = Application(qt, options)
    hook_errors(application.messages)
    hook_signals(application.window)
    application.start()
    code = qt.exec()
    application.close()
    return code


def _welcome() -> BannerState:
    return BannerState(
        Severity.INFO,
        "No device is connected",
        "Choose the port of the unit in Device Properties; or try the program on its simulated"
        " rig, which speaks the same protocols.",
        "",
        (
            BannerAction(_PROPERTIES, "Device Properties"),
            BannerAction("pointer", "Simulated PW09"),
            BannerAction("clbacc", "Simulated assembly"),
        ),
    )


def _default_root() -> Path:
    from core.records.session.find import default_root

    return default_root()


def _settings_path() -> Path:
    place = QStandardPaths.StandardLocation.GenericConfigLocation
    return Path(QStandardPaths.writableLocation(place)) / "calrig" / "settings.json"
