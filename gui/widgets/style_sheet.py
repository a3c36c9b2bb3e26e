"""The few places where Fusion with a palette is not enough: spacing, buttons, tabs, tables."""

from importlib import resources
from pathlib import Path

from gui.widgets.colours import Theme
from gui.widgets.states import Tone

_SHEET = """
QToolTip {{ color: {text}; background: {raised}; border: 1px solid {line}; padding: 0.3em; }}

QPushButton {{
    background: {raised}; color: {text}; border: 1px solid {line}; border-radius: 0.3em;
    padding: 0.35em 0.9em; min-height: 1.3em;
}}
QPushButton:hover {{ border-color: {muted}; }}
QPushButton:pressed, QPushButton:checked {{ background: {pressed}; }}
QPushButton:checked {{ border-color: {accent}; color: {accent}; }}
QPushButton:focus {{ border-color: {accent}; }}
QPushButton:disabled {{ background: {window}; color: {disabled}; border-color: {pressed}; }}
QPushButton[primary="true"] {{
    background: {accent}; color: {on_accent}; border-color: {accent}; font-weight: bold;
}}
QPushButton[primary="true"]:hover {{ border-color: {text}; }}
QPushButton[primary="true"]:focus {{ border-color: {text}; }}
QPushButton[primary="true"]:disabled {{
    background: {window}; color: {disabled}; border-color: {line};
}}
QPushButton[big="true"] {{ padding: 0.55em 1.3em; min-height: 1.6em; }}
QToolButton {{ border: 1px solid transparent; border-radius: 0.3em; padding: 0.2em; }}
QToolButton:hover {{ background: {pressed}; }}
QToolButton:focus {{ border-color: {accent}; }}

QLineEdit, QPlainTextEdit, QAbstractSpinBox, QComboBox {{
    background: {base}; color: {text}; border: 1px solid {field}; border-radius: 0.25em;
    padding: 0.1em 0.3em; min-height: 1.45em;
    selection-background-color: {accent}; selection-color: {on_accent};
}}
QLineEdit:focus, QPlainTextEdit:focus, QAbstractSpinBox:focus, QComboBox:focus {{
    border-color: {accent};
}}
QLineEdit:disabled, QAbstractSpinBox:disabled, QComboBox:disabled, QLineEdit:read-only {{
    background: {window}; color: {disabled}; border-color: {line};
}}
QLineEdit:read-only {{ color: {text}; }}
QAbstractSpinBox QLineEdit, QComboBox QLineEdit {{
    border: none; background: transparent; padding: 0; min-height: 0;
}}
QAbstractSpinBox {{ padding-right: 1.5em; }}
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button {{
    subcontrol-origin: border; border: none; width: 1.4em; background: transparent;
}}
QAbstractSpinBox::up-button {{ subcontrol-position: top right; }}
QAbstractSpinBox::down-button {{ subcontrol-position: bottom right; }}
QAbstractSpinBox::up-button:hover, QAbstractSpinBox::down-button:hover {{ background: {pressed}; }}
QAbstractSpinBox::up-arrow {{ image: url("{icons}/up-{name}.svg"); width: 0.8em; height: 0.8em; }}
QAbstractSpinBox::down-arrow, QComboBox::down-arrow {{
    image: url("{icons}/down-{name}.svg"); width: 0.8em; height: 0.8em;
}}
QComboBox {{ padding-right: 1.6em; }}
QComboBox::drop-down {{ border: none; width: 1.5em; }}
QComboBox QAbstractItemView {{
    background: {base}; border: 1px solid {line}; selection-background-color: {accent};
    selection-color: {on_accent}; outline: 0;
}}

QCheckBox, QRadioButton {{ spacing: 0.45em; }}
QCheckBox::indicator, QRadioButton::indicator, QGroupBox::indicator, QListView::indicator {{
    width: 1em; height: 1em; background: {base}; border: 1px solid {field};
}}
QCheckBox::indicator, QGroupBox::indicator, QListView::indicator {{ border-radius: 0.2em; }}
QRadioButton::indicator {{ border-radius: 0.55em; }}
QCheckBox::indicator:focus, QRadioButton::indicator:focus {{ border-color: {accent}; }}
QCheckBox::indicator:checked, QGroupBox::indicator:checked, QListView::indicator:checked {{
    background: {accent}; border-color: {accent}; image: url("{icons}/check-{name}.svg");
}}
QRadioButton::indicator:checked {{
    background: {accent}; border-color: {accent}; image: url("{icons}/dot-{name}.svg");
}}
QCheckBox::indicator:disabled, QRadioButton::indicator:disabled {{
    background: {window}; border-color: {line};
}}
QCheckBox:focus, QRadioButton:focus {{ color: {accent}; }}

QToolButton[popupMode="1"], QToolButton[popupMode="2"] {{ padding-right: 1.3em; }}
QToolButton::menu-indicator {{
    image: url("{icons}/down-{name}.svg"); width: 0.8em; height: 0.8em;
    subcontrol-origin: border; subcontrol-position: center right; right: 0.35em;
}}

QScrollBar:vertical {{ background: transparent; width: 0.85em; margin: 0; }}
QScrollBar:horizontal {{ background: transparent; height: 0.85em; margin: 0; }}
QScrollBar::handle {{ background: {line}; border-radius: 0.25em; margin: 0.15em; }}
QScrollBar::handle:vertical {{ min-height: 2em; }}
QScrollBar::handle:horizontal {{ min-width: 2em; }}
QScrollBar::handle:hover {{ background: {field}; }}
QScrollBar::add-line, QScrollBar::sub-line {{ width: 0; height: 0; }}
QScrollBar::add-page, QScrollBar::sub-page {{ background: transparent; }}

QTabWidget::pane {{ border: none; border-top: 1px solid {line}; }}
QTabBar {{ qproperty-drawBase: 0; }}
QTabBar::tab {{
    color: {muted}; background: transparent; padding: 0.45em 0.6em; border: none;
    border-bottom: 0.2em solid transparent;
}}
QTabBar::tab:hover {{ color: {text}; }}
QTabBar::tab:selected {{ color: {text}; border-bottom-color: {accent}; }}
QTabBar::tab:focus {{ color: {accent}; }}

QGroupBox {{ border: none; margin-top: 1.5em; padding: 0; }}
QGroupBox::title {{
    subcontrol-origin: margin; subcontrol-position: top left; color: {muted}; padding: 0;
}}

QTableView, QListView, QTreeView {{
    border: 1px solid {line}; background: {base}; alternate-background-color: {alternate};
    gridline-color: {grid};
}}
QTableView {{ outline: 0; }}
QTableView::item {{ padding: 0 0.5em; border: none; }}
QTableView::item:selected {{ background: {chosen}; color: {text}; }}
QHeaderView {{ background: {window}; border: none; }}
QHeaderView::section {{
    background: {window}; color: {muted}; border: none; border-bottom: 1px solid {line};
    padding: 0.3em 0.6em;
}}
QTableCornerButton::section {{ background: {window}; border: none; }}
QSplitter::handle {{ background: {window}; }}
QStatusBar::item {{ border: none; }}
"""


def _icons() -> str:
    """Folder of the signs in fields, as a style sheet wants it on every system."""
    return Path(str(resources.files("resources") / "icons")).as_posix()


def style_sheet(theme: Theme) -> str:
    """Return the style sheet of a look."""
    return _SHEET.format(
        name=theme.name,
        icons=_icons(),
        text=theme.text,
        muted=theme.muted,
        disabled=theme.disabled,
        window=theme.window,
        base=theme.base,
        alternate=theme.alternate,
        raised=theme.raised,
        pressed=theme.grid,
        line=theme.line,
        field=theme.field,
        chosen=theme.tints[Tone.ACTION],
        grid=theme.grid,
        accent=theme.accent,
        on_accent=theme.on_accent,
    )
