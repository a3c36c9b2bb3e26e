"""What the common widgets show, as plain data: presenters build it, `render` draws it."""

from collections.abc import Collection
from dataclasses import dataclass, replace
from datetime import datetime
from enum import Enum

from PySide6.QtCore import QCoreApplication

from core.errors import Note, Severity


class Tone(Enum):
    """How urgent something is; colour and icon follow from it."""

    IDLE = "idle"
    ACTION = "action"
    """The operator has to do something."""
    BUSY = "busy"
    DOUBT = "doubt"
    GOOD = "good"
    BAD = "bad"


@dataclass(frozen=True, slots=True)
class Pose:
    """How the unit stands on the dividing head, or on the rate table.

    Parameters
    ----------
    mount : as `core.plans.orientation.Mount` reads it, e.g. ``"X_from"``, ``"Y_to@90"``
    head_deg : angle of the dividing head
    tilt_deg : psi, theta, gamma of the tilter between plate and case
    rate_dps : rate of the table, counter-clockwise from above; None on the head
    """

    mount: str
    head_deg: float
    tilt_deg: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rate_dps: float | None = None


@dataclass(frozen=True, slots=True)
class StageState:
    """What the operator has to know from three metres away.

    Parameters
    ----------
    headline : a few words, "Turn to 90°", "Measuring", "Link lost"
    detail : one or two sentences below it
    progress : 0 to 1, None while nothing is timed
    remaining_s : seconds left, shown in the ring
    pose : the picture beside the line, None for none
    next_pose, next_label : what comes after, shown small; empty label for nothing
    """

    headline: str
    detail: str = ""
    tone: Tone = Tone.IDLE
    progress: float | None = None
    remaining_s: float | None = None
    pose: Pose | None = None
    next_pose: Pose | None = None
    next_label: str = ""


class StepMark(Enum):
    """Where a step of a plan stands."""

    TO_COME = "to come"
    NOW = "now"
    DONE = "done"
    PROBLEM = "problem"


@dataclass(frozen=True, slots=True)
class StepState:
    """One row of a step list.

    Parameters
    ----------
    label : "1  X from ODH  0°"
    mark : done, now, to come, problem
    pose : its small picture, None where there is nothing to picture
    values : summary of what was measured, or of what is wrong
    replicates : accepted measurements of this step
    group : heading above the first row of each group
    """

    label: str
    mark: StepMark = StepMark.TO_COME
    pose: Pose | None = None
    values: str = ""
    replicates: int = 0
    group: str = ""


@dataclass(frozen=True, slots=True)
class BannerAction:
    """A button of a banner: `key` comes back in its signal."""

    key: str
    text: str


@dataclass(frozen=True, slots=True)
class BannerState:
    """What happened, what it means, what to do."""

    severity: Severity
    what: str
    meaning: str = ""
    remedy: str = ""
    actions: tuple[BannerAction, ...] = ()
    closable: bool = True


@dataclass(frozen=True, slots=True)
class TableState:
    """A table of results as texts; numbers have the digits that their uncertainties allow.

    Parameters
    ----------
    title : over it
    equation : what the numbers are parameters of; empty where it needs none
    header : (c,) names of the columns with their units
    rows : (n, c) texts
    words : number of columns, from the left, that hold words; the others hold numbers
    """

    title: str
    equation: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    words: int = 1


@dataclass(frozen=True, slots=True)
class FindingsState:
    """The right-hand side of an analysis: what was found.

    Parameters
    ----------
    title, source : of what, and from what
    tables : from above
    notes : every doubt
    """

    title: str
    source: str
    tables: tuple[TableState, ...]
    notes: tuple[Note, ...]


@dataclass(frozen=True, slots=True)
class MatrixState:
    """A matrix with the equation that it stands in.

    Parameters
    ----------
    symbol : what stands before the bracket, ``"K ="``
    cells : rows of pairs: value, uncertainty (empty for none)
    unit, equation : below the matrix, beside it
    columns : names of the columns; empty for none
    """

    symbol: str
    cells: tuple[tuple[tuple[str, str], ...], ...]
    unit: str = ""
    equation: str = ""
    columns: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ResidualSeries:
    """Residuals of one sensor.

    Parameters
    ----------
    name : of the sensor
    values : (n,) one a position; NaN where there is none
    u95 : (n,) half width of the interval that 95 % of them should lie in; empty where unknown
    """

    name: str
    values: tuple[float, ...]
    u95: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class ResidualState:
    """Residuals by position.

    Parameters
    ----------
    positions : (n,) labels under the axis
    series : one a sensor
    unit : of the residuals
    """

    positions: tuple[str, ...]
    series: tuple[ResidualSeries, ...]
    unit: str = ""


@dataclass(frozen=True, slots=True)
class LogEntry:
    """One line of the log."""

    at: datetime
    severity: Severity
    text: str
    source: str = ""


class LinkMark(Enum):
    """State of the link to a device."""

    OFFLINE = "offline"
    OPENING = "opening"
    STREAMING = "streaming"
    SILENT = "silent"
    """Open, and nothing comes."""
    LOST = "lost"


@dataclass(frozen=True, slots=True)
class DeviceStripState:
    """The line that says whether the device is there and well.

    Parameters
    ----------
    devices : names of all configured devices; `current` is the one the numbers are of
    baud : 0 where the port has none (a simulated rig)
    rate_hz : measured rate, None while unknown
    temperature_c : None where the device sends none
    """

    devices: tuple[str, ...] = ()
    current: int = 0
    port: str = ""
    baud: int = 0
    link: LinkMark = LinkMark.OFFLINE
    rate_hz: float | None = None
    frames: int = 0
    received_bytes: int = 0
    bad_checksum: int = 0
    lost: int = 0
    garbage: int = 0
    temperature_c: float | None = None


@dataclass(frozen=True, slots=True)
class ActionItem:
    """One button of an action bar.

    Parameters
    ----------
    key : comes back in the signal
    text : the words on it
    shortcut : in `QKeySequence` portable text, empty for none
    default : the main one, drawn so; its shortcut is Space in every tab
    enabled, why_not : whether it can be pressed, and if not the reason (tool tip)
    """

    key: str
    text: str
    shortcut: str = ""
    default: bool = False
    enabled: bool = True
    why_not: str = ""


@dataclass(frozen=True, slots=True)
class ActionBarState:
    """All buttons of a tab; `hands_free` is None where there is no such mode."""

    items: tuple[ActionItem, ...]
    hands_free: bool | None = None


def measuring_actions(
    enabled: Collection[str], *, running: bool = False, why_not: str = ""
) -> tuple[ActionItem, ...]:
    """The six actions of every measuring tab, in their fixed places.

    Parameters
    ----------
    enabled : keys that can be pressed now, of ``accumulate``, ``repeat``, ``discard``, ``load``,
        ``process``, ``export``
    running : the first button stops instead of starting; its key is then ``stop``
    why_not : reason shown on the ones that cannot be pressed
    """
    # Stop does not answer to Space: a pedal that bounces must not end what it has just begun.
    first = (
        ActionItem("stop", QCoreApplication.translate("ActionBar", "Stop"), "Esc")
        if running
        else ActionItem(
            "accumulate",
            QCoreApplication.translate("ActionBar", "Accumulate Data"),
            "Space",
            default=True,
        )
    )
    others = (
        ActionItem("repeat", QCoreApplication.translate("ActionBar", "Repeat"), "Backspace"),
        ActionItem("discard", QCoreApplication.translate("ActionBar", "Discard"), "Delete"),
        ActionItem("load", QCoreApplication.translate("ActionBar", "Load Data"), "Ctrl+O"),
        ActionItem("process", QCoreApplication.translate("ActionBar", "Process Data"), "F5"),
        ActionItem("export", QCoreApplication.translate("ActionBar", "Export"), "Ctrl+E"),
    )
    return tuple(
        item
        if item.key == "stop" or item.key in enabled
        else replace(item, enabled=False, why_not=why_not)
        for item in (first, *others)
    )
