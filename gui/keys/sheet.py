"""What can be pressed where, collected from the window as it is."""

from collections.abc import Iterator
from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication, QObject
from PySide6.QtGui import QAction, QKeySequence, QShortcut
from PySide6.QtWidgets import QAbstractButton, QMainWindow, QTabWidget, QWidget

from gui.keys.own_keys import Own, own_keys


@dataclass(frozen=True, slots=True)
class KeyLine:
    """Keys as the system calls them, and what they do."""

    keys: str
    text: str


@dataclass(frozen=True, slots=True)
class KeyGroup:
    """Where the keys work, and which."""

    title: str
    lines: tuple[KeyLine, ...]


@dataclass(frozen=True, slots=True)
class KeySheet:
    """Keys of the whole window, of each tab, and of what has the focus; equal ones together."""

    groups: tuple[KeyGroup, ...]


def sheet_of(window: QMainWindow, tabs: QTabWidget) -> KeySheet:
    """Collect the keys of every button, menu and widget.

    Parameters
    ----------
    window : of the program
    tabs : those of the window; what stands in none of them works everywhere
    """
    own = own_keys()
    pages = [tabs.widget(place) for place in range(tabs.count())]
    places: dict[str, dict[KeyLine, None]] = {QCoreApplication.translate("Keys", "Everywhere"): {}}
    everywhere = next(iter(places))
    places |= {tabs.tabText(place): {} for place in range(tabs.count())}
    for child, line in _pressed(window):
        page = next((i for i, one in enumerate(pages) if _within(child, one)), None)
        places[everywhere if page is None else tabs.tabText(page)][line] = None
    focused: dict[str, dict[KeyLine, None]] = {}
    for widget in window.findChildren(QWidget):
        page = next((i for i, one in enumerate(pages) if _within(widget, one)), None)
        here = everywhere if page is None else tabs.tabText(page)
        for where, line in _answered(widget, own):
            (focused.setdefault(where, {}) if where else places[here])[line] = None
    alike: dict[tuple[KeyLine, ...], list[str]] = {}
    for title, lines in (*places.items(), *focused.items()):
        alike.setdefault(tuple(lines), []).append(title)
    groups = (KeyGroup(", ".join(titles), lines) for lines, titles in alike.items() if lines)
    return KeySheet(tuple(groups))


def _pressed(window: QMainWindow) -> Iterator[tuple[QObject, KeyLine]]:
    """Keys of menus and buttons."""
    for action in window.findChildren(QAction):
        # One that stands in no menu and on no widget is never asked.
        if not action.shortcut().isEmpty() and action.associatedObjects():
            yield action, KeyLine(_native(action.shortcut()), action.text().replace("&", ""))
    for shortcut in window.findChildren(QShortcut):
        button = shortcut.parent()
        if isinstance(button, QAbstractButton) and not shortcut.key().isEmpty():
            yield button, KeyLine(_native(shortcut.key()), button.text())
    for button in window.findChildren(QAbstractButton):
        if not button.shortcut().isEmpty() and button.text():
            yield button, KeyLine(_native(button.shortcut()), button.text().replace("&", ""))


def _answered(widget: QWidget, own: Own) -> Iterator[tuple[str, KeyLine]]:
    """Keys of the widget itself, by what it is."""
    for kind in type(widget).__mro__:
        where, lines = own.get(kind.__name__, ("", ()))
        for keys, text in lines:
            if kind.__name__ == "ActionBar" and not _has_hands_free(widget):
                continue
            yield where, KeyLine(" ".join(map(_name, keys.split())), text)


def _has_hands_free(bar: QWidget) -> bool:
    return any(s.isEnabled() and s.parent() is bar for s in bar.findChildren(QShortcut))


def _within(child: QObject | None, page: QWidget | None) -> bool:
    while child is not None and child is not page:
        child = child.parent()
    return child is not None


def _name(key: str) -> str:
    return key if key == "…" else _native(QKeySequence(key))


def _native(sequence: QKeySequence) -> str:
    return sequence.toString(QKeySequence.SequenceFormat.NativeText)
