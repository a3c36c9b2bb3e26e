"""How the application puts on the light or the dark look."""

from collections.abc import Generator
from contextlib import contextmanager
from importlib import resources

from PySide6.QtCore import QByteArray, QObject, Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QPalette
from PySide6.QtWidgets import QApplication

from gui.widgets.colours import DARK, LIGHT, THEMES, Theme
from gui.widgets.states import Tone
from gui.widgets.style_sheet import style_sheet

FAMILY = "DejaVu Sans"
POINT_SIZE = 9.5


_PAPER: list[Theme] = []


@contextmanager
def paper_look() -> Generator[None]:
    """Paint in the light look inside the block, whatever the screen wears: paper is white."""
    _PAPER.append(LIGHT)
    try:
        yield
    finally:
        _PAPER.pop()


def current_theme() -> Theme:
    """Return the look that the application wears, read from its palette."""
    if _PAPER:
        return _PAPER[-1]
    window = QApplication.palette().color(QPalette.ColorRole.Window)
    return DARK if window.lightness() < 128 else LIGHT


def apply_theme(app: QApplication, choice: str) -> Theme:
    """Put a look on the whole application.

    Parameters
    ----------
    choice : ``"light"``, ``"dark"``, or ``"system"``, which also follows later changes

    Returns
    -------
    Theme
        The look now worn. Widgets learn of it by `QEvent.Type.PaletteChange`.

    Raises
    ------
    KeyError
        There is no such look.
    """
    follower = app.findChild(_SystemFollower)
    if follower is None:
        follower = _SystemFollower(app)
        app.setStyle("Fusion")
        load_fonts()
    follower.active = choice == "system"
    hints = app.styleHints()
    if choice == "system":
        hints.unsetColorScheme()
        theme = DARK if hints.colorScheme() == Qt.ColorScheme.Dark else LIGHT
    else:
        theme = THEMES[choice]
        hints.setColorScheme(Qt.ColorScheme.Dark if theme is DARK else Qt.ColorScheme.Light)
    _wear(app, theme)
    return theme


def _wear(app: QApplication, theme: Theme) -> None:
    font = QFont(FAMILY)
    font.setPointSizeF(POINT_SIZE)
    app.setFont(font)
    app.setPalette(_palette(theme))
    app.setStyleSheet(style_sheet(theme))


def load_fonts() -> None:
    """Make the shipped fonts known, so that no screen depends on what a machine has."""
    folder = resources.files("resources") / "fonts"
    for name in ("DejaVuSans.ttf", "DejaVuSans-Bold.ttf"):
        QFontDatabase.addApplicationFontFromData(QByteArray((folder / name).read_bytes()))


class _SystemFollower(QObject):
    """Changes the look when the desktop does, as long as the choice is "system"."""

    def __init__(self, app: QApplication) -> None:
        super().__init__(app)
        self.active = False
        self._app = app
        app.styleHints().colorSchemeChanged.connect(self._on_scheme)

    def _on_scheme(self, scheme: Qt.ColorScheme) -> None:
        if self.active:
            _wear(self._app, DARK if scheme == Qt.ColorScheme.Dark else LIGHT)


def _palette(theme: Theme) -> QPalette:
    role = QPalette.ColorRole
    colours = {
        role.Window: theme.window,
        role.WindowText: theme.text,
        role.Base: theme.base,
        role.AlternateBase: theme.alternate,
        role.Text: theme.text,
        role.PlaceholderText: theme.muted,
        role.Button: theme.raised,
        role.ButtonText: theme.text,
        role.BrightText: theme.tones[Tone.BAD],
        role.ToolTipBase: theme.raised,
        role.ToolTipText: theme.text,
        role.Highlight: theme.accent,
        role.HighlightedText: theme.on_accent,
        role.Accent: theme.accent,
        role.Link: theme.accent,
        role.LinkVisited: theme.accent,
        role.Light: theme.raised,
        role.Midlight: theme.grid,
        role.Mid: theme.line,
        role.Dark: theme.line,
        role.Shadow: theme.line,
    }
    palette = QPalette()
    for name, colour in colours.items():
        palette.setColor(name, QColor(colour))
    for name in (role.WindowText, role.Text, role.ButtonText, role.HighlightedText):
        palette.setColor(QPalette.ColorGroup.Disabled, name, QColor(theme.disabled))
    palette.setColor(QPalette.ColorGroup.Disabled, role.Highlight, QColor(theme.line))
    return palette
