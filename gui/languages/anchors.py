"""English labels of the old programs, by which operators find their way in every language."""

from gui.languages.shown import originals, shown

BUTTONS = frozenset(
    {
        "Accumulate Data",
        "Process Data",
        "Load Data",
        "START sampling process",
        "STOP sampling process",
    }
)
"""Those of ClbAcc, Pointer, ClbDUS and CVGCom: they stand in small letters below the words."""
LABELS = BUTTONS | {
    # Device Properties
    "Device Properties",
    "Number of Devices",
    "Device name",
    "No Name",
    "Port Name",
    "BaudRate",
    "Scan",
    "Properties",
    # ClbAcc and Pointer on the dividing head
    "Settings",
    "Main Graph",
    "Accumulation Time, sec",
    "Temperatures, °C",
    "Positions",
    "Base orientation",
    "α, ang. min.",
    "β, ang. min.",
    "γ, deg.",
    "ψ, deg.",
    "Termo calibration",
    "Tilter",
    "None",
    "Auto",
    "Manual",
    "Tilter No.",
    "Position",
    "Accelerations",
    "Angular Rates",
    "Mean ({unit})",
    "STD ({unit})",
    "Termo (code)",
    # Pointer, Accuracy
    "Accuracy",
    "Pitch",
    "Roll",
    "Heading",
    "Angles",
    "Inter",
    "Mags/Accels",
    "Tilter axes aligned",
    "Min",
    "Max",
    # ClbDUS
    "View ADC Data",
    "Stop Device",
    # CVGCom
    "Device and Port Settings",
    "Table",
    "Charts",
    "Point on chart",
    "Decimation (table)",
    "Full time scale",
    "Auto tracking",
    "X Cursor",
    "Edit mode",
    "Select all",
    "Deselect all",
    "Select interval",
    "Show intervals",
    "Packed count {n}",
    "Device #",
    "Profile #",
    "Scale factor",
    "Static",
    "Dynamic",
    "Sampling frequency",
}
"""All that are translated here; they are told by the tool tip."""


_SIGNS = " ✓▴▾"
"""What stands before or behind the words of a button."""


def anchor(label: str) -> str:
    """Return the label that stands below its translation; empty where it is not needed."""
    return label if label in BUTTONS and shown(label) != label else ""


def beside(words: str, text: str = "") -> str:
    """Return words, or the text of their tool tip, with their old label behind."""
    label = old_label(words)
    text = text or words
    return f"{text} ({label})" if label else text


def old_label(words: str) -> str:
    """Return what the old programs call a thing that the window names so; empty for English."""
    words = words.strip(_SIGNS)
    found = {label for label in originals(words) if label in LABELS and label != words}
    return " / ".join(sorted(label.partition(" {")[0].partition(" ({")[0] for label in found))
