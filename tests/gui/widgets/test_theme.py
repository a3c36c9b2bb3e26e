import itertools
from importlib import resources

import numpy as np
import pytest
from PySide6.QtCore import QEvent
from PySide6.QtGui import QColor, QFontInfo, QFontMetrics, QPalette, QRawFont
from PySide6.QtWidgets import QLabel, QPushButton

from gui.widgets.colours import DARK, LIGHT, THEMES
from gui.widgets.states import Tone
from gui.widgets.style_sheet import style_sheet
from gui.widgets.theme import FAMILY, apply_theme, current_theme

BOTH = pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])

# Machado, Oliveira, Fernandes 2009, severity 1.0, on linear RGB.
VISION = {
    "normal": np.eye(3),
    "protanopia": [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    "deuteranopia": [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
    "tritanopia": [
        [1.255528, -0.076749, -0.178779],
        [-0.078411, 0.930809, 0.147602],
        [0.004733, 0.691367, 0.303900],
    ],
}


def linear(colour):
    q = QColor(colour)
    c = np.array([q.redF(), q.greenF(), q.blueF()])
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def luminance(colour):
    return float(linear(colour) @ [0.2126, 0.7152, 0.0722])


def contrast(one, other):
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


def lab(rgb):
    to_xyz = np.array(
        [
            [0.4124564, 0.3575761, 0.1804375],
            [0.2126729, 0.7151522, 0.0721750],
            [0.0193339, 0.1191920, 0.9503041],
        ]
    )
    t = to_xyz @ np.clip(rgb, 0, 1) / [0.95047, 1.0, 1.08883]
    f = np.where(t > 0.008856, np.cbrt(t), 7.787 * t + 16 / 116)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def difference(one, other, vision):
    matrix = np.array(VISION[vision])
    return float(np.linalg.norm(lab(matrix @ linear(one)) - lab(matrix @ linear(other))))


@BOTH
def test_text_is_readable(theme):
    for ground in (theme.window, theme.base, theme.alternate, theme.raised):
        assert contrast(theme.text, ground) >= 10
        assert contrast(theme.muted, ground) >= 4.5
    assert contrast(theme.on_accent, theme.accent) >= 4.5
    assert contrast(theme.field, theme.base) >= 3
    for tone in Tone:
        for ground in (theme.tints[tone], theme.window, theme.base):
            assert contrast(theme.tones[tone], ground) >= 4.5, (tone, ground)
        assert contrast(theme.text, theme.tints[tone]) >= 10


@BOTH
def test_curves_stand_out_and_apart_for_everyone(theme):
    assert len(theme.curves) == 7
    for curve in theme.curves:
        assert contrast(curve, theme.base) >= 3
    for vision in VISION:
        for one, other in itertools.combinations(theme.curves, 2):
            assert difference(one, other, vision) > 10, (vision, one, other)


@BOTH
@pytest.mark.parametrize("vision", VISION)
def test_good_doubt_and_bad_are_told_apart(theme, vision):
    shown = [theme.tones[tone] for tone in (Tone.ACTION, Tone.GOOD, Tone.DOUBT, Tone.BAD)]
    for one, other in itertools.combinations(shown, 2):
        assert difference(one, other, vision) > 10, (one, other)


@BOTH
def test_every_colour_is_opaque(theme):
    colours = [*theme.curves, *theme.tones.values(), *theme.tints.values(), theme.grid, theme.line]
    assert all(QColor(c).alpha() == 255 for c in colours)


@BOTH
def test_signs_in_fields_have_the_colours_of_the_table(theme):
    folder = resources.files("resources") / "icons"
    colours = {"check": theme.on_accent, "dot": theme.on_accent, "up": theme.muted}
    colours["down"] = theme.muted
    sheet = style_sheet(theme)
    for name, colour in colours.items():
        assert f"{name}-{theme.name}.svg" in sheet
        assert f'"{colour}"' in (folder / f"{name}-{theme.name}.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", THEMES)
def test_a_look_reaches_palette_and_font(qapp, qtbot, name):
    theme = apply_theme(qapp, name)
    assert current_theme() is theme
    assert qapp.palette().color(QPalette.ColorRole.Base) == QColor(theme.base)
    label = QLabel("Акселерометр ±σ² ° ✓ −")
    qtbot.addWidget(label)
    assert QFontInfo(label.font()).family() == FAMILY


def test_shipped_font_has_the_signs_used(qapp):
    face = QRawFont.fromFont(qapp.font())
    assert face.familyName() == FAMILY
    for sign in "±°²σχ✓✕−×½≤ЇїҐєі\N{FIGURE SPACE}\N{PUNCTUATION SPACE}\N{NARROW NO-BREAK SPACE}":
        assert face.supportsCharacter(ord(sign)), sign
    metrics = QFontMetrics(qapp.font())
    assert len({metrics.horizontalAdvance(digit) for digit in "0123456789"}) == 1


def test_widgets_hear_of_a_change(qapp, qtbot):
    heard = []

    class Listener(QPushButton):
        def changeEvent(self, event):
            super().changeEvent(event)
            if event.type() == QEvent.Type.PaletteChange:
                heard.append(current_theme().name)

    button = Listener("x")
    qtbot.addWidget(button)
    button.show()
    apply_theme(qapp, "dark")
    qtbot.waitUntil(lambda: "dark" in heard)


def test_system_follows_the_desktop(qapp):
    apply_theme(qapp, "system")
    assert current_theme() in (LIGHT, DARK)
    with pytest.raises(KeyError):
        apply_theme(qapp, "sepia")
