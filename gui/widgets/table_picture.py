"""The drawn picture of the rate table, seen from above: which way it turns, what points up."""

import math

from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen, QPolygonF

from gui.widgets.colours import Theme
from gui.widgets.states import Pose, Tone

_SMALL = 96
"""Pictures below this many pixels leave out letters and digits."""
# Lengths in half widths of the picture.
_TABLE = 0.62
_ARROW = 0.80
_CASE = (0.30, 0.22)
_HEAD = 0.13
_SPAN = 280.0
"""How far the arrow goes round, degrees; its gap is at the bottom."""


def describe_table(pose: Pose) -> str:
    """Return the picture in words, for the tool tip and for a screen reader."""
    rate = pose.rate_dps or 0.0
    if rate > 0:
        way = QCoreApplication.translate("TablePicture", "counter-clockwise seen from above")
    elif rate < 0:
        way = QCoreApplication.translate("TablePicture", "clockwise seen from above")
    else:
        way = QCoreApplication.translate("TablePicture", "the table stands")
    return f"{up_words(pose.mount)}, {rate_words(rate)}, {way}"


def up_words(mount: str) -> str:
    """``Z_from`` as it stands on the table: "Z up"; ``Z_to``: "Z down"."""
    axis, _, sense = mount.partition("@")[0].partition("_")
    if sense == "to":
        return QCoreApplication.translate("TablePicture", "{axis} down").format(axis=axis)
    return QCoreApplication.translate("TablePicture", "{axis} up").format(axis=axis)


def rate_words(rate_dps: float) -> str:
    """A rate with its sign: "+40 deg/s"."""
    sign = "" if rate_dps == 0 else ("+" if rate_dps > 0 else "\N{MINUS SIGN}")
    return f"{sign}{abs(rate_dps):g} deg/s"


def paint_table(painter: QPainter, rect: QRectF, pose: Pose, theme: Theme) -> None:
    """Draw the table into the largest square in the middle of `rect`."""
    side = min(rect.width(), rect.height())
    unit = side / 2.0
    centre = rect.center()
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.translate(centre)
    line = max(1.0, side / 140.0)
    painter.setPen(QPen(QColor(theme.muted), line))
    painter.setBrush(QColor(theme.base))
    painter.drawEllipse(QPointF(0, 0), _TABLE * unit, _TABLE * unit)
    case = QRectF(-_CASE[0] * unit, -_CASE[1] * unit, 2 * _CASE[0] * unit, 2 * _CASE[1] * unit)
    painter.setPen(QPen(QColor(theme.text), line))
    painter.setBrush(QColor(theme.window))
    painter.drawRoundedRect(case, 0.04 * unit, 0.04 * unit)
    _axis(painter, pose.mount, unit, theme, lettered=side >= _SMALL)
    if pose.rate_dps:
        _arrow(painter, pose.rate_dps > 0, unit, theme)
    painter.restore()


def _axis(painter: QPainter, mount: str, unit: float, theme: Theme, *, lettered: bool) -> None:
    """The axis that stands upright: a dot comes towards the eye, a cross goes away."""
    away = mount.partition("@")[0].endswith("_to")
    place = QPointF(-0.12 * unit if lettered else 0.0, 0.0)
    radius = (0.09 if lettered else 0.13) * unit
    painter.setPen(QPen(QColor(theme.text), max(1.0, unit / 60.0)))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawEllipse(place, radius, radius)
    if away:
        reach = radius * math.sqrt(0.5)
        for sense in (1, -1):
            painter.drawLine(
                place + QPointF(-reach, -sense * reach), place + QPointF(reach, sense * reach)
            )
    else:
        painter.setBrush(QColor(theme.text))
        painter.drawEllipse(place, 0.35 * radius, 0.35 * radius)
    if lettered:
        font = QFont(painter.font())
        font.setBold(True)
        font.setPixelSize(max(9, round(0.22 * unit)))
        painter.setFont(font)
        box = QRectF(0.02 * unit, -0.2 * unit, 0.28 * unit, 0.4 * unit)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, mount[:1])


def _arrow(painter: QPainter, to_the_left: bool, unit: float, theme: Theme) -> None:
    """An arc around the table with its head at the end that goes on."""
    colour = QColor(theme.tones[Tone.ACTION])
    radius = _ARROW * unit
    pen = QPen(colour, max(1.5, 0.05 * unit))
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    painter.setPen(pen)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    begin = 90.0 - _SPAN / 2.0
    painter.drawArc(
        QRectF(-radius, -radius, 2 * radius, 2 * radius), round(16 * begin), round(16 * _SPAN)
    )
    end = math.radians(begin + _SPAN if to_the_left else begin)
    sense = 1.0 if to_the_left else -1.0
    tip = QPointF(radius * math.cos(end), -radius * math.sin(end))
    ahead = QPointF(-sense * math.sin(end), -sense * math.cos(end))
    across = QPointF(math.cos(end), -math.sin(end))
    head = _HEAD * unit
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour)
    painter.drawPolygon(
        QPolygonF([tip + ahead * 1.6 * head, tip + across * head, tip - across * head])
    )
