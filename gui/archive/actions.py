"""The row of actions below the archive, and why one cannot be done now."""

from PySide6.QtCore import QCoreApplication

from gui.archive.questions import Details, can_be_certified
from gui.widgets.states import ActionItem


def items_of(
    details: Details | None, chosen: tuple[int, ...], running: str, *, empty: bool
) -> tuple[ActionItem, ...]:
    """Return the buttons.

    Parameters
    ----------
    details : of what is chosen; None while they are not known
    chosen : numbers of the chosen entries
    running : what the archive is working at
    empty : nothing is in it
    """
    one = details if chosen else None
    opens = one is not None and one.opening is not None
    session = one is not None and len(chosen) == 1 and one.entries[0].kind == "session"
    nothing = QCoreApplication.translate("Archive", "Nothing is chosen.")
    here = QCoreApplication.translate("Archive", "All that there is of it is shown here.")
    busy = running in ("rebuild", "import")
    wait = QCoreApplication.translate("Archive", "The archive is being worked at.")
    return (
        ActionItem(
            "open",
            QCoreApplication.translate("Archive", "Open"),
            "Space",
            opens,
            opens,
            nothing if one is None else here,
        ),
        ActionItem(
            "certificate",
            QCoreApplication.translate("Archive", "Certificate"),
            enabled=one is not None and len(chosen) == 1 and can_be_certified(one),
            why_not=QCoreApplication.translate(
                "Archive", "Choose a session, a run, an old file, a record or a calibration."
            ),
        ),
        ActionItem(
            "import",
            QCoreApplication.translate("Archive", "Import Folder"),
            "Ctrl+I",
            empty,
            not busy,
            wait,
        ),
        ActionItem(
            "reprocess",
            QCoreApplication.translate("Archive", "Decode Again"),
            "F5",
            False,
            session,
            QCoreApplication.translate(
                "Archive", "Choose a session: its raw bytes are decoded again and compared."
            ),
        ),
        ActionItem("refresh", QCoreApplication.translate("Archive", "Refresh"), "Ctrl+R"),
        ActionItem(
            "rebuild",
            QCoreApplication.translate("Archive", "Rebuild Index"),
            "",
            False,
            not busy,
            wait,
        ),
    )
