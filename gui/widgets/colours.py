"""Every colour of the program: one table for the light and one for the dark look."""

from collections.abc import Mapping
from dataclasses import dataclass

from PySide6.QtGui import QColor

from gui.widgets.states import Tone


@dataclass(frozen=True, slots=True)
class Theme:
    """One look; every colour of the program comes from here.

    Parameters
    ----------
    window, base, raised : background of the window, of fields and charts, of buttons and headers
    line, field : borders; borders of fields, whose contrast is at least 3:1
    grid : of charts; opaque, because translucent lines are drawn pixel by pixel and cost a chart
        tens of milliseconds a frame
    text, muted : what is read, and what only labels it
    accent, on_accent : the one colour of the program, and text on it
    tones : colour of each `Tone`; readable as text on `window` and `base`
    tints : background for each tone
    curves : seven colours that stay apart for the colour-blind
    """

    name: str
    window: str
    base: str
    alternate: str
    raised: str
    line: str
    field: str
    grid: str
    text: str
    muted: str
    disabled: str
    accent: str
    on_accent: str
    tones: Mapping[Tone, str]
    tints: Mapping[Tone, str]
    curves: tuple[str, ...]


LIGHT = Theme(
    name="light",
    window="#f3f4f6",
    base="#ffffff",
    alternate="#f7f8fa",
    raised="#fdfdfe",
    line="#c9ced6",
    field="#868e99",
    grid="#e4e7eb",
    text="#1a1f26",
    muted="#59636f",
    disabled="#9aa2ac",
    accent="#1f5fae",
    on_accent="#ffffff",
    tones={
        Tone.IDLE: "#59636f",
        Tone.ACTION: "#1f5fae",
        Tone.BUSY: "#59636f",
        Tone.DOUBT: "#8a6000",
        Tone.GOOD: "#00705a",
        Tone.BAD: "#9b1c31",
    },
    tints={
        Tone.IDLE: "#ffffff",
        Tone.ACTION: "#e6effa",
        Tone.BUSY: "#ffffff",
        Tone.DOUBT: "#fcf1da",
        Tone.GOOD: "#e0f3ee",
        Tone.BAD: "#fbe8eb",
    },
    curves=("#003fa2", "#c18900", "#03aa66", "#9c2d6a", "#201c1d", "#8693c1", "#a51e00"),
)

DARK = Theme(
    name="dark",
    window="#1d2025",
    base="#15181c",
    alternate="#1a1d22",
    raised="#2a2e35",
    line="#434a54",
    field="#6b7480",
    grid="#2a2f36",
    text="#e8ebef",
    muted="#a2abb6",
    disabled="#69717c",
    accent="#5aa2f0",
    on_accent="#0d1218",
    tones={
        Tone.IDLE: "#a2abb6",
        Tone.ACTION: "#6fb0f5",
        Tone.BUSY: "#a2abb6",
        Tone.DOUBT: "#e3b04b",
        Tone.GOOD: "#3fcaa6",
        Tone.BAD: "#ff8a6b",
    },
    tints={
        Tone.IDLE: "#15181c",
        Tone.ACTION: "#1a2a3d",
        Tone.BUSY: "#15181c",
        Tone.DOUBT: "#352a12",
        Tone.GOOD: "#12302a",
        Tone.BAD: "#3b1d17",
    },
    curves=("#47ceff", "#ebce0e", "#158856", "#af669e", "#f4f4e8", "#856fff", "#d16915"),
)

THEMES: dict[str, Theme] = {"light": LIGHT, "dark": DARK}
"""Names that a setting may hold besides ``"system"``."""


def blend(colour: str, ground: str, share: float) -> QColor:
    """Return a colour mixed into the ground, opaque."""
    one, other = QColor(colour), QColor(ground)
    return QColor(
        round(share * one.red() + (1.0 - share) * other.red()),
        round(share * one.green() + (1.0 - share) * other.green()),
        round(share * one.blue() + (1.0 - share) * other.blue()),
    )
