"""English labels of the old programs, by which operators find their way in every language."""

from gui.languages.shown import shown

LABELS = frozenset(
    {
        "Accumulate Data",
        "Process Data",
        "Load Data",
        "START sampling process",
        "STOP sampling process",
    }
)
"""Buttons of ClbAcc, Pointer, ClbDUS and CVGCom as their windows name them."""


def anchor(label: str) -> str:
    """Return the label that stands below its translation; empty where it is not needed."""
    return label if label in LABELS and shown(label) != label else ""
