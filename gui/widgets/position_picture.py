"""The drawn picture of how the unit must stand on the dividing head.

Seen along the shaft from its free end: what turns clockwise in the picture turns with the head.
"""

import math
from itertools import product

import numpy as np
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
    QPolygonF,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from core.arrays import FloatArray
from gui.widgets.colours import Theme
from gui.widgets.pose_geometry import AxisMark, axis_marks, case_axes
from gui.widgets.states import Pose, Tone
from gui.widgets.table_picture import describe_table, paint_table
from gui.widgets.theme import current_theme

SMALL = 96
"""Pictures below this many pixels leave out scale, gravity and digits."""

# Lengths in half widths of the picture.
_DIAL = 0.66
_SMALL_DIAL = 0.80
_HALF_CASE = np.array([0.25, 0.20, 0.13])
_PLATE = (0.40, 0.035)
_SHAFT = 0.10
_AXIS = 0.35


class PositionPicture(QWidget):
    """A picture of one pose; empty until `set_pose`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._pose: Pose | None = None
        self._axes: FloatArray | None = None
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)
        self.setMinimumSize(48, 48)

    def set_pose(self, pose: Pose | None, axes: FloatArray | None = None) -> None:
        """Show a pose.

        Parameters
        ----------
        pose : None leaves the picture empty
        axes : (3, 3) rows X, Y, Z of the case in base components s, l, v, where they do not
            follow from the pose alone (a base plate that stands askew)

        Raises
        ------
        ValueError
            The pose names no mount.
        """
        if pose == self._pose and axes is None:
            return
        self._axes = case_axes(pose) if pose is not None and axes is None else axes
        self._pose = pose
        self.setAccessibleName("" if pose is None else describe(pose))
        self.setToolTip(self.accessibleName())
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(280, 280)

    def heightForWidth(self, width: int) -> int:
        return width

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        if self._pose is None or self._axes is None:
            return
        painter = QPainter(self)
        paint_pose(painter, QRectF(self.rect()), self._pose, current_theme(), axes=self._axes)
        painter.end()


def angle_text(angle_deg: float) -> str:
    """Return an angle as the head's scale shows it, ``"22.5°"``."""
    return f"{angle_deg:.6g}°".replace("-", "\N{MINUS SIGN}")


def describe(pose: Pose) -> str:
    """Return the picture in words, for the tool tip and for a screen reader."""
    if pose.rate_dps is not None:
        return describe_table(pose)
    parts = [_mount_text(pose), angle_text(pose.head_deg)]
    parts += [f"{mark.name} {_direction(mark)}" for mark in axis_marks(case_axes(pose))]
    return ", ".join(parts)


def _mount_text(pose: Pose) -> str:
    """``X_from@90`` as it stands under the picture: "X from ODH @ 90"."""
    place, _, reindex = pose.mount.partition("@")
    words = f"{place.replace('_', ' ')} ODH"
    return f"{words} @ {reindex}" if reindex else words


def _direction(mark: AxisMark) -> str:
    if not mark.in_plane:
        if mark.toward > 0:
            return QCoreApplication.translate("PositionPicture", "from the head")
        return QCoreApplication.translate("PositionPicture", "to the head")
    words: list[str] = []
    if mark.up > 0.5:
        words.append(QCoreApplication.translate("PositionPicture", "up"))
    elif mark.up < -0.5:
        words.append(QCoreApplication.translate("PositionPicture", "down"))
    if mark.right > 0.5:
        words.append(QCoreApplication.translate("PositionPicture", "right"))
    elif mark.right < -0.5:
        words.append(QCoreApplication.translate("PositionPicture", "left"))
    return " ".join(words)


def paint_pose(
    painter: QPainter,
    rect: QRectF,
    pose: Pose,
    theme: Theme,
    *,
    axes: FloatArray | None = None,
) -> None:
    """Draw a pose, on the head or on the table, into the largest square amid `rect`."""
    if pose.rate_dps is not None:
        paint_table(painter, rect, pose, theme)
        return
    _Drawing(painter, rect, theme).draw(pose, case_axes(pose) if axes is None else axes)


class _Drawing:
    """One picture: unit coordinates, right and up positive, the shaft at the origin."""

    def __init__(self, painter: QPainter, rect: QRectF, theme: Theme) -> None:
        self._painter = painter
        self._theme = theme
        self._centre = rect.center()
        self._half = min(rect.width(), rect.height()) / 2.0
        self._small = 2.0 * self._half < SMALL
        self._stretch = 1.3 if self._small else 1.0

    def draw(self, pose: Pose, axes: FloatArray) -> None:
        self._painter.save()
        self._painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._head(pose.head_deg)
        angle = math.radians(pose.head_deg)
        normal = np.array([0.0, math.sin(angle), math.cos(angle)])
        reach = (float(np.abs(axes @ normal) @ _HALF_CASE) + _PLATE[1]) * self._stretch
        # In the large picture the plate passes through the shaft; in the small one the case
        # stands in the middle, where its axes have most room.
        self._plate(pose.head_deg, reach if self._small else 0.0)
        origin = normal * (0.0 if self._small else reach)
        self._case(axes, origin)
        self._axes(axis_marks(axes), QPointF(float(origin[1]), float(origin[2])))
        if not self._small:
            self._captions(pose)
        self._painter.restore()

    def _at(self, right: float, up: float) -> QPointF:
        return QPointF(self._centre.x() + right * self._half, self._centre.y() - up * self._half)

    def _pen(self, colour: str, width: float) -> QPen:
        pen = QPen(QColor(colour), max(1.0, width * self._half))
        pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        return pen

    def _font(self, height: float, *, bold: bool = False) -> QFont:
        font = QFont(self._painter.font())
        font.setPixelSize(max(9, round(height * self._half)))
        font.setBold(bold)
        return font

    def _text(self, at: QPointF, text: str, colour: str, font: QFont) -> None:
        self._painter.setFont(font)
        self._painter.setPen(QColor(colour))
        box = QRectF(0, 0, 4 * self._half, 2 * self._half)
        box.moveCenter(at)
        self._painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)

    def _head(self, head_deg: float) -> None:
        painter, theme = self._painter, self._theme
        radius = _SMALL_DIAL if self._small else _DIAL
        circle = QRectF(self._at(-radius, radius), self._at(radius, -radius))
        if not self._small:
            foot = QPolygonF([self._at(-0.34, -0.55), self._at(0.34, -0.55), self._at(0.48, -0.98)])
            foot.append(self._at(-0.48, -0.98))
            painter.setPen(self._pen(theme.line, 0.008))
            painter.setBrush(QColor(theme.raised))
            painter.drawPolygon(foot)
        painter.setPen(self._pen(theme.line, 0.012))
        painter.setBrush(QColor(theme.base))
        painter.drawEllipse(circle)
        for degrees in range(0, 360, 90 if self._small else 15):
            self._tick(degrees, radius)
        self._mark(head_deg, radius)
        if not self._small:
            painter.setPen(self._pen(theme.muted, 0.012))
            painter.setBrush(QColor(theme.grid))
            shaft = QRectF(self._at(-_SHAFT, _SHAFT), self._at(_SHAFT, -_SHAFT))
            painter.drawEllipse(shaft)

    def _tick(self, degrees: int, radius: float) -> None:
        main = degrees % 90 == 0
        right, up = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
        inner = radius - (0.08 if main else 0.04)
        self._painter.setPen(
            self._pen(self._theme.muted if main else self._theme.line, 0.014 if main else 0.008)
        )
        self._painter.drawLine(
            self._at(right * radius, up * radius), self._at(right * inner, up * inner)
        )
        if main and not self._small:
            at = self._at(right * (radius + 0.23), up * (radius + 0.20))
            self._text(at, str(degrees), self._theme.muted, self._font(0.085))

    def _mark(self, head_deg: float, radius: float) -> None:
        """The angle to set: a triangle outside the scale that points at it."""
        accent = self._theme.tones[Tone.ACTION]
        size = 0.16 if self._small else 0.12
        self._painter.save()
        self._painter.translate(self._centre)
        self._painter.rotate(head_deg)
        self._painter.scale(self._half, self._half)
        self._painter.setPen(Qt.PenStyle.NoPen)
        self._painter.setBrush(QColor(accent))
        tip = -(radius + 0.015)
        self._painter.drawPolygon(
            QPolygonF(
                [
                    QPointF(0.0, tip),
                    QPointF(-0.6 * size, tip - size),
                    QPointF(0.6 * size, tip - size),
                ]
            )
        )
        self._painter.restore()

    def _plate(self, head_deg: float, below: float) -> None:
        length, thick = (value * self._stretch for value in _PLATE)
        self._painter.save()
        self._painter.translate(self._centre)
        self._painter.rotate(head_deg)
        self._painter.setPen(self._pen(self._theme.muted, 0.01))
        self._painter.setBrush(QColor(self._theme.line))
        half = self._half
        self._painter.drawRect(
            QRectF(-length * half, (below - thick) * half, 2 * length * half, 2 * thick * half)
        )
        self._painter.restore()

    def _case(self, axes: FloatArray, origin: FloatArray) -> None:
        """The case as a box: those of its six faces that look at the viewer."""
        painter, theme = self._painter, self._theme
        painter.setPen(self._pen(theme.muted, 0.014))
        for axis, sign in product(range(3), (1.0, -1.0)):
            facing = sign * float(axes[axis, 0])
            if facing < 1e-6:
                continue
            middle = sign * _HALF_CASE[axis] * axes[axis]
            j, k = (axis + 1) % 3, (axis + 2) % 3
            side, other = _HALF_CASE[j] * axes[j], _HALF_CASE[k] * axes[k]
            corners = [
                origin + self._stretch * (middle + a * side + b * other)
                for a, b in ((1, 1), (1, -1), (-1, -1), (-1, 1))
            ]
            shade = QColor(theme.raised)
            painter.setBrush(shade.darker(100 + round(18 * (1.0 - facing))))
            painter.drawPolygon(QPolygonF([self._at(float(c[1]), float(c[2])) for c in corners]))

    def _axes(self, marks: tuple[AxisMark, ...], origin: QPointF) -> None:
        free = QPointF(-sum(m.right for m in marks), -sum(m.up for m in marks))
        size = math.hypot(free.x(), free.y()) or 1.0
        for mark in marks:
            if mark.in_plane:
                self._arrow(mark, origin)
        for mark in marks:
            if not mark.in_plane:
                self._circled(mark, origin, QPointF(free.x() / size, free.y() / size))

    def _arrow(self, mark: AxisMark, origin: QPointF) -> None:
        painter, colour = self._painter, self._theme.text
        length = _AXIS * (1.48 if self._small else 1.0)
        right, up = mark.right * length, mark.up * length
        size = math.hypot(mark.right, mark.up)
        along = QPointF(mark.right / size, mark.up / size)
        width = 0.05 if self._small else 0.024
        head = 0.17 if self._small else 0.10
        x, y = origin.x() + right, origin.y() + up
        painter.setPen(self._pen(colour, width))
        painter.drawLine(
            self._at(origin.x(), origin.y()),
            self._at(x - along.x() * 0.8 * head, y - along.y() * 0.8 * head),
        )
        path = QPainterPath(self._at(x, y))
        for side in (0.45, -0.45):
            path.lineTo(
                self._at(
                    x - head * along.x() - side * head * along.y(),
                    y - head * along.y() + side * head * along.x(),
                )
            )
        path.closeSubpath()
        painter.fillPath(path, QColor(colour))
        gap = 0.16 if self._small else 0.09
        self._label(QPointF(x + gap * along.x(), y + gap * along.y()), mark.name)

    def _circled(self, mark: AxisMark, origin: QPointF, free: QPointF) -> None:
        painter, colour = self._painter, self._theme.text
        radius = 0.14 if self._small else 0.075
        painter.setPen(self._pen(colour, 0.05 if self._small else 0.022))
        painter.setBrush(QColor(self._theme.base))
        x, y = origin.x(), origin.y()
        painter.drawEllipse(
            QRectF(self._at(x - radius, y + radius), self._at(x + radius, y - radius))
        )
        if mark.toward > 0:
            painter.setBrush(QColor(colour))
            dot = 0.25 * radius
            painter.drawEllipse(QRectF(self._at(x - dot, y + dot), self._at(x + dot, y - dot)))
        else:
            arm = radius * math.sqrt(0.5)
            painter.drawLine(self._at(x - arm, y - arm), self._at(x + arm, y + arm))
            painter.drawLine(self._at(x - arm, y + arm), self._at(x + arm, y - arm))
        gap = 0.32 if self._small else 0.18
        self._label(QPointF(x + gap * free.x(), y + gap * free.y()), mark.name)

    def _label(self, at: QPointF, name: str) -> None:
        """The name of an axis, with a rim that keeps it apart from lines it may lie on."""
        font = self._font(0.32 if self._small else 0.13, bold=True)
        metrics = QFontMetricsF(font)
        place = self._at(at.x(), at.y())
        path = QPainterPath()
        path.addText(
            place.x() - metrics.horizontalAdvance(name) / 2,
            place.y() + metrics.capHeight() / 2,
            font,
            name,
        )
        self._painter.strokePath(path, self._pen(self._theme.base, 0.09 if self._small else 0.04))
        self._painter.fillPath(path, QColor(self._theme.text))

    def _captions(self, pose: Pose) -> None:
        painter, theme = self._painter, self._theme
        corner = QRectF(self._at(-1.0, 1.0), self._at(0.2, 0.75))
        painter.setFont(self._font(0.20, bold=True))
        painter.setPen(QColor(theme.text))
        left = Qt.AlignmentFlag.AlignLeft
        painter.drawText(corner, left | Qt.AlignmentFlag.AlignTop, angle_text(pose.head_deg))
        painter.setFont(self._font(0.10))
        painter.setPen(QColor(theme.muted))
        foot = QRectF(self._at(-1.0, -0.80), self._at(0.2, -1.0))
        painter.drawText(foot, left | Qt.AlignmentFlag.AlignBottom, _mount_text(pose))
        painter.setPen(self._pen(theme.muted, 0.018))
        painter.drawLine(self._at(0.90, -0.62), self._at(0.90, -0.93))
        path = QPainterPath(self._at(0.90, -0.99))
        path.lineTo(self._at(0.855, -0.90))
        path.lineTo(self._at(0.945, -0.90))
        painter.fillPath(path, QColor(theme.muted))
        self._text(self._at(0.79, -0.78), "g", theme.muted, self._font(0.11, bold=True))
