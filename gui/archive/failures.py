"""What could not be done with the archive, and what to do about it."""

from PySide6.QtCore import QCoreApplication

from core.errors import Note


def failure_of(key: str) -> tuple[str, str]:
    """Return what failed and what to do.

    Parameters
    ----------
    key : of the question to the archive
    """
    again = QCoreApplication.translate(
        "Archive",
        "The sessions are untouched. When the cause is gone press Refresh (Ctrl+R).",
    )
    table = {
        "list": (QCoreApplication.translate("Archive", "The archive cannot be searched"), again),
        "refresh": (QCoreApplication.translate("Archive", "The archive cannot be opened"), again),
        "rebuild": (
            QCoreApplication.translate("Archive", "The index cannot be made"),
            QCoreApplication.translate(
                "Archive",
                "The sessions are untouched. When the cause is gone press Refresh (Ctrl+R): what is"
                " missing in the list comes back from the files.",
            ),
        ),
        "details": (
            QCoreApplication.translate("Archive", "The entry cannot be shown"),
            QCoreApplication.translate(
                "Archive", "The list is looked up again; choose the entry once more."
            ),
        ),
        "history": (
            QCoreApplication.translate("Archive", "The history cannot be shown"),
            again,
        ),
        "import": (
            QCoreApplication.translate("Archive", "The folder cannot be imported"),
            QCoreApplication.translate(
                "Archive",
                "What was taken in stays. Put right what is named and import the folder again: it"
                " goes on where it was broken off.",
            ),
        ),
        "reprocess": (
            QCoreApplication.translate("Archive", "The session cannot be decoded"),
            QCoreApplication.translate(
                "Archive",
                "The stored means stay as they are. The raw bytes (.calrec) belong into the"
                " session's folder or into the folder raw.",
            ),
        ),
    }
    return table[key]


def remedy_of(note: Note) -> str:
    """Return what to do about what happened when the archive was opened."""
    remedies = {
        "index_damaged": QCoreApplication.translate(
            "Archive",
            "Nothing has to be done. If it happens again, have the disk checked.",
        ),
        "read_only_folder": QCoreApplication.translate(
            "Archive",
            "Searching works as always. To measure, choose a folder that can be written to.",
        ),
        "newer_schema": QCoreApplication.translate(
            "Archive",
            "Update CalRig on this computer; until then measure as always, the newer program finds"
            " the sessions.",
        ),
    }
    return remedies.get(note.subject, "")


def no_tab_remedy() -> str:
    """Return what to do with a file that no tab takes."""
    return QCoreApplication.translate(
        "Archive", "Open it by Load Data of the tab in which it was measured."
    )
