"""Keys that widgets answer themselves; a test presses every one of them on its widget."""

from PySide6.QtCore import QCoreApplication

Own = dict[str, tuple[str, tuple[tuple[str, str], ...]]]
"""By the widget's class: where its keys work (empty: in its whole tab), and pairs of keys, apart by
spaces and in portable text, and what they do."""


def own_keys() -> Own:
    """The keys in the language of the window."""
    return {
        "MeasuringView": (
            "",
            (
                ("Esc", QCoreApplication.translate("Keys", "Stop the accumulation")),
                ("Ctrl+Z", QCoreApplication.translate("Keys", "Take the last one back")),
            ),
        ),
        "LiveView": ("", (("Esc", QCoreApplication.translate("Keys", "Stop the record")),)),
        "AllanView": ("", (("Esc", QCoreApplication.translate("Keys", "Stop the live curve")),)),
        "ActionBar": ("", (("Ctrl+H", QCoreApplication.translate("Keys", "Hands-free")),)),
        "ArchiveView": ("", (("Ctrl+F", QCoreApplication.translate("Keys", "Search")),)),
        "LogDrawer": ("", (("Ctrl+L", QCoreApplication.translate("Keys", "Show the log")),)),
        "DevicesView": (
            QCoreApplication.translate("Keys", "Device Properties"),
            (
                ("Return", QCoreApplication.translate("Keys", "OK")),
                ("Esc", QCoreApplication.translate("Keys", "Close")),
            ),
        ),
        "DistanceView": (
            QCoreApplication.translate("Keys", "Distance view"),
            (("Esc", QCoreApplication.translate("Keys", "Leave it")),),
        ),
        "StepList": (
            QCoreApplication.translate("Keys", "List of steps"),
            (
                ("Up Down", QCoreApplication.translate("Keys", "Look at another step")),
                ("Return", QCoreApplication.translate("Keys", "Make it the current step")),
                ("1 … 9", QCoreApplication.translate("Keys", "Pick a step by its place")),
            ),
        ),
        "StripCanvas": (
            QCoreApplication.translate("Keys", "Charts over time"),
            (
                ("Left Right", QCoreApplication.translate("Keys", "Move in time")),
                ("+ -", QCoreApplication.translate("Keys", "Zoom in and out")),
                ("Home", QCoreApplication.translate("Keys", "Show everything")),
                ("End", QCoreApplication.translate("Keys", "Follow the newest samples")),
                ("Up Down", QCoreApplication.translate("Keys", "Other channels")),
                ("A B", QCoreApplication.translate("Keys", "Set a cursor at the pointer")),
                (
                    "Ctrl+Left Ctrl+Right",
                    QCoreApplication.translate("Keys", "Move the cursor by a sample"),
                ),
                ("C", QCoreApplication.translate("Keys", "Clear the cursors")),
            ),
        ),
        "Plot": (
            QCoreApplication.translate("Keys", "Plots"),
            (("Home", QCoreApplication.translate("Keys", "Show everything")),),
        ),
        "AllanPlot": (
            QCoreApplication.translate("Keys", "Allan plot"),
            (("Left Right", QCoreApplication.translate("Keys", "Read the curve by points")),),
        ),
        "KnotPlot": (
            QCoreApplication.translate("Keys", "Plot of the drift table"),
            (
                ("PgUp PgDown", QCoreApplication.translate("Keys", "Choose a knot")),
                ("Left Right", QCoreApplication.translate("Keys", "Move the knot")),
            ),
        ),
        **dict.fromkeys(
            ("MatrixView", "_View", "_LogTable"),
            (
                QCoreApplication.translate("Keys", "Matrices, tables, log"),
                (("Ctrl+C", QCoreApplication.translate("Keys", "Copy")),),
            ),
        ),
        "_Table": (
            QCoreApplication.translate("Keys", "Table of means"),
            (("Ctrl+V", QCoreApplication.translate("Keys", "Paste a column of references")),),
        ),
        "Dial": (
            QCoreApplication.translate("Keys", "Dial of the simulated rig"),
            (
                ("Left Right", QCoreApplication.translate("Keys", "Turn by a step")),
                (
                    "Shift+Left Shift+Right",
                    QCoreApplication.translate("Keys", "Turn by a fine step"),
                ),
                ("PgUp PgDown", QCoreApplication.translate("Keys", "Turn by a quarter")),
                ("Home", QCoreApplication.translate("Keys", "Turn to zero")),
            ),
        ),
        "PreferencesView": (
            QCoreApplication.translate("Keys", "Preferences"),
            (("Esc", QCoreApplication.translate("Keys", "Close")),),
        ),
        "CandidateView": (
            QCoreApplication.translate("Keys", "Candidates"),
            (("Return", QCoreApplication.translate("Keys", "Choose it")),),
        ),
        "BytesView": (
            QCoreApplication.translate("Keys", "Bytes of a board"),
            (
                ("Left Right", QCoreApplication.translate("Keys", "Point at another byte")),
                ("Shift+Left Shift+Right", QCoreApplication.translate("Keys", "Select bytes")),
                ("Return", QCoreApplication.translate("Keys", "Add a field")),
                ("Del", QCoreApplication.translate("Keys", "Remove the field")),
            ),
        ),
        "PreviewView": (
            QCoreApplication.translate("Keys", "Preview of a certificate"),
            (("PgUp PgDown", QCoreApplication.translate("Keys", "Turn the page")),),
        ),
        "Callout": (
            QCoreApplication.translate("Keys", "Tour"),
            (
                ("Return", QCoreApplication.translate("Keys", "Go on")),
                ("Esc", QCoreApplication.translate("Keys", "Leave it")),
            ),
        ),
        "Banner": (
            QCoreApplication.translate("Keys", "Message"),
            (("Esc", QCoreApplication.translate("Keys", "Close")),),
        ),
    }
