"""The sheet of keys as HTML."""

from html import escape

from PySide6.QtCore import QCoreApplication

from gui.keys.sheet import KeyGroup, KeySheet


def sheet_title() -> str:
    """What stands over the sheet."""
    return QCoreApplication.translate("Keys", "Keys of CalRig")


def sheet_sections(sheet: KeySheet) -> tuple[str, ...]:
    """The sheet in pieces, a group each."""
    title = f"<h1>{escape(sheet_title())}</h1>"
    return (title, *(_group(group) for group in sheet.groups))


def _group(group: KeyGroup) -> str:
    rows = "".join(
        f"<tr><td width='38%'><b>{escape(line.keys)}</b></td><td>{escape(line.text)}</td></tr>"
        for line in group.lines
    )
    return f"<h3>{escape(group.title)}</h3><table width='100%' cellpadding='3'>{rows}</table>"
