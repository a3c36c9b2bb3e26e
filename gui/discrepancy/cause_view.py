"""A small picture of each kind of cause: what bends, what turns, what drifts, what went wrong."""

import math
from collections.abc import Callable

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from gui.widgets.theme import current_theme

KINDS = {
    "second_order_nonlinearity": "parabola",
    "cross_axis_nonlinearity": "parabola",
    "g_squared_sensitivity": "parabola",
    "third_order_nonlinearity": "cubic",
    "odd_quadratic_nonlinearity": "cubic",
    "cross_coupling": "cross",
    "scale_factor_asymmetry": "kink",
    "bias_asymmetry": "step",
    "dead_band": "dead",
    "saturation": "clip",
    "hysteresis": "loop",
    "settling_lag": "lag",
    "mounting_angle": "tilt",
    "shaft_tilt": "tilt",
    "wobble": "tilt",
    "remount_bias": "offsets",
    "run_bias": "offsets",
    "run_scale_factor": "fan",
    "head_eccentricity": "dial",
    "head_ellipticity": "dial",
    "head_periodic_error": "gear",
    "bias_drift": "ramp",
    "bias_temperature": "warmth",
    "scale_factor_temperature": "warmth",
    "temperature_rate": "warmth",
    "thermal_lag": "warmth",
    "thermal_hysteresis": "loop",
    "warm_up": "lag",
    "bias_jump": "step",
    "telegraph": "telegraph",
    "pickup": "sine",
    "table_slip": "clip",
    "wrong_rate": "odd_one",
    "amplitude_scale_factor": "fan",
    "magnetic_sensitivity": "magnet",
    "earth_rate": "earth",
    "outlier": "odd_one",
    "wrong_angle": "odd_one",
    "wrong_stop": "odd_one",
    "short_accumulation": "lag",
    "stuck_reading": "stuck",
    "quadrature_leakage": "fan",
    "phase_error": "fan",
    "damping_anisotropy": "fan",
    "resonator_frequency": "warmth",
    "amplitude_error": "fan",
    "quantization": "stairs",
    "missing_codes": "stairs",
    "angle_random_walk": "noise",
    "bias_instability": "noise",
    "rate_random_walk": "noise",
    "markov": "noise",
    "variance_burst": "burst",
    "dropouts": "gap",
    "stale_temperature": "stuck",
    "clipping": "clip",
    "positions_swapped": "swap",
    "mount_reversed": "swap",
    "rate_sign_reversed": "swap",
    "channels_permuted": "swap",
}
"""Which picture an effect has; others have a wave with a question mark."""


class CauseView(QWidget):
    """The picture of an effect."""

    def __init__(self, lines: float = 3.0, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._effect = ""
        side = round(lines * self.fontMetrics().height())
        self._side = QSize(round(1.3 * side), side)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def render(self, effect: str, name: str) -> None:
        """Show the picture of an effect."""
        self._effect = effect
        self.setAccessibleName(name)
        self.update()

    def sizeHint(self) -> QSize:
        return self._side

    def minimumSizeHint(self) -> QSize:
        return self._side

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        painter = QPainter(self)
        paint_cause(painter, QRectF(self.rect()), self._effect)
        painter.end()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.update()


def paint_cause(painter: QPainter, rect: QRectF, effect: str) -> None:
    """Draw the picture of an effect inside a rectangle."""
    theme = current_theme()
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    side = min(rect.width() / 1.3, rect.height())
    painter.translate(rect.center())
    painter.scale(0.5 * side, 0.5 * side)
    painter.setPen(QPen(QColor(theme.line), 0.05))
    painter.setBrush(QColor(theme.base))
    painter.drawRoundedRect(QRectF(-1.27, -0.97, 2.54, 1.94), 0.12, 0.12)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    quiet = QPen(QColor(theme.muted), 0.045)
    strong = QPen(QColor(theme.accent), 0.11)
    strong.setCapStyle(Qt.PenCapStyle.RoundCap)
    strong.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    _PICTURES[KINDS.get(effect, "unknown")](painter, quiet, strong)
    painter.restore()


_Picture = Callable[[QPainter, QPen, QPen], None]


def _axes(painter: QPainter, quiet: QPen) -> None:
    painter.setPen(quiet)
    painter.drawLine(QPointF(-1.1, 0), QPointF(1.1, 0))
    painter.drawLine(QPointF(0, -0.8), QPointF(0, 0.8))


def _curve_of(law: Callable[[float], float]) -> _Picture:
    """A law over the input, y upwards, both from -1 to 1."""

    def paint(painter: QPainter, quiet: QPen, strong: QPen) -> None:
        _axes(painter, quiet)
        painter.setPen(strong)
        path = QPainterPath()
        for place in range(49):
            x = -1.0 + place / 24.0
            at = QPointF(x, -0.72 * law(x))
            path.lineTo(at) if place else path.moveTo(at)
        painter.drawPath(path)

    return paint


def _loop(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    _axes(painter, quiet)
    painter.setPen(strong)
    path = QPainterPath(QPointF(-0.9, 0.65))
    path.cubicTo(QPointF(-0.1, 0.6), QPointF(0.6, 0.2), QPointF(0.9, -0.65))
    path.cubicTo(QPointF(0.1, -0.6), QPointF(-0.6, -0.2), QPointF(-0.9, 0.65))
    painter.drawPath(path)


def _tilt(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    painter.setPen(quiet)
    painter.drawLine(QPointF(-1.1, 0.62), QPointF(1.1, 0.62))
    painter.save()
    painter.rotate(-14)
    painter.setPen(strong)
    painter.drawRect(QRectF(-0.55, -0.42, 1.1, 0.8))
    painter.drawLine(QPointF(0, -0.02), QPointF(0, -0.8))
    painter.restore()


def _offsets(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    painter.setPen(quiet)
    painter.drawLine(QPointF(-1.1, 0.75), QPointF(1.1, 0.75))
    painter.setPen(strong)
    for place, level in enumerate((0.35, -0.45, 0.05)):
        left = -1.0 + 0.72 * place
        painter.drawLine(QPointF(left, level), QPointF(left + 0.52, level))


def _fan(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    _axes(painter, quiet)
    painter.setPen(strong)
    for slope in (0.4, 0.7):
        painter.drawLine(QPointF(-0.95, 0.95 * slope), QPointF(0.95, -0.95 * slope))


def _dial(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    painter.setPen(quiet)
    painter.drawEllipse(QPointF(0, 0), 0.78, 0.78)
    for number in range(12):
        angle = math.radians(30 * number)
        tip = QPointF(math.cos(angle), math.sin(angle))
        painter.drawLine(tip * 0.66, tip * 0.78)
    painter.setPen(strong)
    painter.drawEllipse(QPointF(0.2, -0.1), 0.5, 0.5)
    painter.drawPoint(QPointF(0.2, -0.1))


def _gear(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    painter.setPen(quiet)
    painter.drawEllipse(QPointF(0, 0), 0.3, 0.3)
    painter.setPen(strong)
    path = QPainterPath()
    for place in range(145):
        angle = math.radians(2.5 * place)
        radius = 0.64 + 0.13 * math.sin(10 * angle)
        at = QPointF(radius * math.cos(angle), radius * math.sin(angle))
        path.lineTo(at) if place else path.moveTo(at)
    painter.drawPath(path)


def _warmth(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    painter.setPen(quiet)
    painter.drawRoundedRect(QRectF(-0.22, -0.8, 0.44, 1.2), 0.22, 0.22)
    for y in (-0.5, -0.25, 0.0):
        painter.drawLine(QPointF(0.32, y), QPointF(0.55, y))
    painter.setPen(strong)
    painter.setBrush(strong.color())
    painter.drawEllipse(QPointF(0, 0.52), 0.22, 0.22)
    painter.drawLine(QPointF(0, 0.5), QPointF(0, -0.3))


def _cross(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    _axes(painter, quiet)
    painter.setPen(strong)
    path = QPainterPath()
    for place in range(97):
        angle = math.radians(3.75 * place)
        radius = 0.85 * abs(math.sin(2 * angle))
        at = QPointF(1.1 * radius * math.cos(angle), radius * math.sin(angle))
        path.lineTo(at) if place else path.moveTo(at)
    painter.drawPath(path)


def _points(painter: QPainter, quiet: QPen, strong: QPen, odd: QPointF) -> None:
    painter.setPen(quiet)
    painter.setBrush(quiet.color())
    for place in range(6):
        painter.drawEllipse(QPointF(-0.95 + 0.38 * place, 0.35 - 0.12 * place), 0.06, 0.06)
    painter.setPen(strong)
    painter.setBrush(strong.color())
    painter.drawEllipse(odd, 0.1, 0.1)


def _odd_one(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    _points(painter, quiet, strong, QPointF(0.2, -0.6))


def _stuck(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    _axes(painter, quiet)
    painter.setPen(strong)
    painter.drawPolyline(
        [QPointF(-1, 0.6), QPointF(-0.3, 0.1), QPointF(0.4, 0.1), QPointF(1.0, -0.6)]
    )
    painter.setBrush(strong.color())
    for x in (-0.3, 0.4):
        painter.drawEllipse(QPointF(x, 0.1), 0.09, 0.09)


def _swap(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    painter.setPen(quiet)
    painter.drawEllipse(QPointF(-0.75, 0), 0.2, 0.2)
    painter.drawEllipse(QPointF(0.75, 0), 0.2, 0.2)
    painter.setPen(strong)
    for sign in (1.0, -1.0):
        path = QPainterPath(QPointF(-0.65 * sign, -0.35 * sign))
        path.quadTo(QPointF(0, -0.95 * sign), QPointF(0.65 * sign, -0.35 * sign))
        path.moveTo(QPointF(0.36 * sign, -0.4 * sign))
        path.lineTo(QPointF(0.65 * sign, -0.35 * sign))
        path.lineTo(QPointF(0.62 * sign, -0.64 * sign))
        painter.drawPath(path)


def _magnet(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    painter.setPen(quiet)
    for radius in (0.3, 0.55):
        painter.drawArc(QRectF(-radius, -0.95, 2 * radius, 1.0), 0, 180 * 16)
    painter.setPen(strong)
    path = QPainterPath(QPointF(-0.45, -0.25))
    path.lineTo(-0.45, 0.2)
    path.arcTo(QRectF(-0.45, -0.25, 0.9, 0.95), 180, 180)
    path.lineTo(0.45, -0.25)
    painter.drawPath(path)


def _earth(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    painter.setPen(quiet)
    painter.drawEllipse(QPointF(0, 0), 0.6, 0.6)
    painter.drawEllipse(QPointF(0, 0), 0.25, 0.6)
    painter.drawLine(QPointF(-0.6, 0), QPointF(0.6, 0))
    painter.setPen(strong)
    painter.drawLine(QPointF(0, -0.88), QPointF(0, 0.88))
    painter.drawArc(QRectF(-0.85, -0.3, 1.7, 0.6), 200 * 16, 140 * 16)


def _gap(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    _axes(painter, quiet)
    painter.setPen(strong)
    for left, right in ((-1.0, -0.35), (0.3, 1.0)):
        painter.drawLine(QPointF(left, -0.35), QPointF(right, -0.35))


def _unknown(painter: QPainter, quiet: QPen, strong: QPen) -> None:
    _curve_of(lambda x: 0.5 * math.sin(4.0 * x) + 0.3 * math.cos(7.0 * x))(painter, quiet, strong)


_PICTURES: dict[str, _Picture] = {
    "parabola": _curve_of(lambda x: 1.6 * x * x - 0.8),
    "cubic": _curve_of(lambda x: 1.9 * x**3 - 0.95 * x),
    "cross": _cross,
    "kink": _curve_of(lambda x: 1.5 * abs(x) - 0.75),
    "step": _curve_of(lambda x: 0.6 if x > 0 else -0.6),
    "dead": _curve_of(lambda x: math.copysign(max(abs(x) - 0.35, 0.0), x) * 1.4),
    "clip": _curve_of(lambda x: max(-0.6, min(0.6, 1.1 * x))),
    "loop": _loop,
    "lag": _curve_of(lambda x: 0.9 * math.exp(-2.4 * (x + 1.0))),
    "tilt": _tilt,
    "offsets": _offsets,
    "fan": _fan,
    "dial": _dial,
    "gear": _gear,
    "ramp": _curve_of(lambda x: 0.8 * x),
    "warmth": _warmth,
    "telegraph": _curve_of(lambda x: 0.6 if math.sin(7.0 * x) > 0.2 else -0.6),
    "sine": _curve_of(lambda x: 0.8 * math.sin(3.0 * math.pi * x)),
    "stairs": _curve_of(lambda x: 0.4 * math.floor(2.5 * x + 0.5)),
    "noise": _curve_of(lambda x: 0.45 * (math.sin(37.0 * x) + math.sin(23.0 * x + 1.0))),
    "burst": _curve_of(lambda x: (0.8 if abs(x) < 0.35 else 0.2) * math.sin(40.0 * x)),
    "gap": _gap,
    "odd_one": _odd_one,
    "stuck": _stuck,
    "swap": _swap,
    "magnet": _magnet,
    "earth": _earth,
    "unknown": _unknown,
}
