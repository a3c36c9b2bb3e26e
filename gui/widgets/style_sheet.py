"""The few places where Fusion with a palette is not enough: spacing, buttons, tabs, tables."""

from gui.widgets.colours import Theme

_SHEET = """
QToolTip {{ color: {text}; background: {raised}; border: 1px solid {line}; padding: 0.3em; }}

QPushButton {{
    background: {raised}; color: {text}; border: 1px solid {line}; border-radius: 0.3em;
    padding: 0.35em 0.9em; min-height: 1.3em;
}}
QPushButton:hover {{ border-color: {muted}; }}
QPushButton:pressed, QPushButton:checked {{ background: {pressed}; }}
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

QTabWidget::pane {{ border: none; border-top: 1px solid {line}; }}
QTabBar {{ qproperty-drawBase: 0; }}
QTabBar::tab {{
    color: {muted}; background: transparent; padding: 0.45em 1em; border: none;
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
QHeaderView {{ background: {window}; border: none; }}
QHeaderView::section {{
    background: {window}; color: {muted}; border: none; border-bottom: 1px solid {line};
    padding: 0.3em 0.6em;
}}
QTableCornerButton::section {{ background: {window}; border: none; }}
QSplitter::handle {{ background: {window}; }}
QStatusBar::item {{ border: none; }}
"""


def style_sheet(theme: Theme) -> str:
    """Return the style sheet of a look."""
    return _SHEET.format(
        text=theme.text,
        muted=theme.muted,
        disabled=theme.disabled,
        window=theme.window,
        base=theme.base,
        alternate=theme.alternate,
        raised=theme.raised,
        pressed=theme.grid,
        line=theme.line,
        grid=theme.grid,
        accent=theme.accent,
        on_accent=theme.on_accent,
    )
