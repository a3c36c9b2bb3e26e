"""What holds for every tab: who measures where, and where sessions are kept."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, runtime_checkable

from PySide6.QtCore import QObject, Signal

from gui.measuring.site import SECTION, Site, site_of
from gui.settings import Settings, folder_of


@runtime_checkable
class SiteTab(Protocol):
    """A tab whose sessions state who measured and where."""

    def take_site(self, site: Site) -> None:
        """Measure with these from now on."""
        ...


@dataclass(frozen=True, slots=True)
class PreferencesState:
    """What the panel shows.

    Parameters
    ----------
    site : who measures, and where
    folder : of all sessions, from the next start on
    folder_now : of all sessions in this run of the program
    """

    site: Site
    folder: Path
    folder_now: Path


class Preferences(QObject):
    """Remembers what the operator prefers, and hands it to the tabs.

    Parameters
    ----------
    settings : where it is remembered
    tabs : those of the window
    root : folder of all sessions in this run
    """

    changed = Signal(object)
    """A new `PreferencesState`."""

    def __init__(
        self,
        settings: Settings,
        tabs: Iterable[object],
        root: Path,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._settings = settings
        self._tabs = tuple(tab for tab in tabs if isinstance(tab, SiteTab))
        self._root = root

    @property
    def state(self) -> PreferencesState:
        """The preferences as they are now."""
        section = self._settings.section(SECTION)
        folder = folder_of(self._settings) or self._root
        return PreferencesState(site_of(section), folder, self._root)

    def set_site(self, site: Site) -> None:
        """Who measures where: for every tab that is not in a session, and for all later ones."""
        self._store({**site.to_section()})
        for tab in self._tabs:
            tab.take_site(site)
        self.changed.emit(self.state)

    def set_folder(self, text: str) -> None:
        """Keep sessions in another folder, from the next start on; nothing is moved."""
        path = Path(text.strip()).expanduser()
        self._store({"folder": str(path) if text.strip() and path.is_absolute() else ""})
        self.changed.emit(self.state)

    def _store(self, values: dict[str, object]) -> None:
        self._settings.store(SECTION, {**self._settings.section(SECTION), **values})
