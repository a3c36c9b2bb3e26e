"""The window's menu: where to go, how it looks and sounds, and what helps."""

from collections.abc import Sequence
from typing import cast

from PySide6.QtCore import QEvent, Signal
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMenu, QTabWidget, QWidget

from gui.languages.choice import LANGUAGES, SYSTEM
from gui.languages.shown import shown

LOOKS = ("light", "dark", "system")
VOLUMES = {"off": 0.0, "quiet": 0.25, "normal": 0.6, "loud": 1.0}
"""Loudness of the sounds by the name of its step."""
_DIGITS = 10


class WindowMenu(QMenu):
    """Groups of actions; the window gives them their meaning.

    Parameters
    ----------
    tabs : those that the group *Go to* leads to
    """

    look_chosen = Signal(str)
    language_chosen = Signal(str)
    volume_chosen = Signal(float)

    def __init__(self, tabs: QTabWidget, parent: QWidget) -> None:
        super().__init__(parent)
        self._tabs = tabs
        self.go_to, self.look, self.sounds, self.help = (QMenu(self) for _ in range(4))
        self.language = QMenu(self)
        self.distance, self.preferences = QAction(self), QAction(self)
        self.keys, self.tour = QAction(self), QAction(self)
        self._next, self._before = QAction(self), QAction(self)
        self._places: list[QAction] = []
        self.looks = {name: QAction(self, checkable=True) for name in LOOKS}
        self.volumes = {name: QAction(self, checkable=True) for name in VOLUMES}
        self.languages = {
            code: QAction(LANGUAGES.get(code, ""), self, checkable=True)
            for code in (SYSTEM, *LANGUAGES)
        }
        self._titles: tuple[str, ...] = ()
        self._groups = (QActionGroup(self), QActionGroup(self), QActionGroup(self))
        self._build()
        self._retranslate()

    def _build(self) -> None:
        for action, key in (
            (self.distance, "F11"),
            (self.preferences, "Ctrl+,"),
            (self.keys, "F1"),
            (self._next, "Ctrl+Tab"),
            (self._before, "Ctrl+Shift+Tab"),
        ):
            action.setShortcut(QKeySequence(key))
        self._next.triggered.connect(self._on_next)
        self._before.triggered.connect(self._on_before)
        self.go_to.addSeparator()
        self.go_to.addActions([self._next, self._before])
        for group, menu, actions in (
            (self._groups[0], self.look, self.looks),
            (self._groups[1], self.sounds, self.volumes),
            (self._groups[2], self.language, self.languages),
        ):
            for name, action in actions.items():
                action.setData(name)
                group.addAction(action)
                menu.addAction(action)
        told = (self._on_look, self._on_volume, self._on_language)
        for group, slot in zip(self._groups, told, strict=True):
            group.triggered.connect(slot)
        self.help.addActions([self.keys, self.tour])
        self.addMenu(self.go_to)
        self.addAction(self.distance)
        self.addSeparator()
        self.addMenu(self.look)
        self.addMenu(self.sounds)
        self.addMenu(self.language)
        self.docks = self.addSeparator()
        """What shows and hides the docks stands before this line."""
        self.addAction(self.preferences)
        self.addMenu(self.help)

    def put_tabs(self, titles: Sequence[str]) -> None:
        """Lead to these tabs: the first nine by Ctrl and their digit, the tenth by Ctrl+0."""
        self._titles = tuple(titles)
        for old in self._places:
            self.go_to.removeAction(old)
            old.deleteLater()
        self._places = []
        before = self.go_to.actions()[0]
        for place, title in enumerate(titles):
            action = QAction(shown(title), self)
            if place < _DIGITS:
                action.setShortcut(QKeySequence(f"Ctrl+{(place + 1) % _DIGITS}"))
            action.triggered.connect(self._on_place)
            self.go_to.insertAction(before, action)
            self._places.append(action)

    def show_look(self, look: str) -> None:
        """Mark the look that is worn."""
        self.looks[look].setChecked(True)

    def show_language(self, choice: str) -> None:
        """Mark the language that was chosen."""
        self.languages[choice].setChecked(True)

    def show_volume(self, volume: float) -> None:
        """Mark the step nearest to a loudness."""
        name = min(VOLUMES, key=lambda one: abs(VOLUMES[one] - volume))
        self.volumes[name].setChecked(True)

    def _on_place(self) -> None:
        self._tabs.setCurrentIndex(self._places.index(cast(QAction, self.sender())))

    def _on_look(self, action: QAction) -> None:
        self.look_chosen.emit(action.data())

    def _on_volume(self, action: QAction) -> None:
        self.volume_chosen.emit(VOLUMES[action.data()])

    def _on_language(self, action: QAction) -> None:
        self.language_chosen.emit(action.data())

    def _on_next(self) -> None:
        self._step(1)

    def _on_before(self) -> None:
        self._step(-1)

    def _step(self, way: int) -> None:
        self._tabs.setCurrentIndex((self._tabs.currentIndex() + way) % self._tabs.count())

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self.go_to.setTitle(self.tr("Go to"))
        self.look.setTitle(self.tr("Look"))
        self.sounds.setTitle(self.tr("Sounds"))
        self.help.setTitle(self.tr("Help"))
        self.distance.setText(self.tr("Distance view"))
        self.preferences.setText(self.tr("Preferences"))
        self.keys.setText(self.tr("Keys"))
        self.tour.setText(self.tr("Tour of the window"))
        self._next.setText(self.tr("Next tab"))
        self._before.setText(self.tr("Tab before"))
        looks = {
            "light": self.tr("Light"),
            "dark": self.tr("Dark"),
            "system": self.tr("As the system"),
        }
        volumes = {
            "off": self.tr("Off"),
            "quiet": self.tr("Quiet"),
            "normal": self.tr("Normal"),
            "loud": self.tr("Loud"),
        }
        for name, action in self.looks.items():
            action.setText(looks[name])
        for name, action in self.volumes.items():
            action.setText(volumes[name])
        # The word that finds it again stands beside it in English.
        own = self.tr("Language")
        self.language.setTitle(own if own == "Language" else f"{own} (Language)")
        self.languages[SYSTEM].setText(self.tr("As the system"))
        for action, title in zip(self._places, self._titles, strict=True):
            action.setText(shown(title))
