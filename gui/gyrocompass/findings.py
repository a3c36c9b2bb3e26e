"""What was found -> tables and doubts of the right-hand side."""

import numpy as np
from PySide6.QtCore import QCoreApplication

from core.errors import Note, Severity
from core.fit.estimate import Estimate
from core.procedures.gyrocompass import Gyrocompass
from gui.gyrocompass.state import Advice, Found
from gui.widgets.number_text import decimals_of, fixed, significant, value_and_uncertainty
from gui.widgets.states import FindingsState, TableState


def findings_of(found: Found) -> FindingsState | None:
    """Tables and doubts; None while there is nothing to tell."""
    tables: list[TableState] = []
    notes: list[Note] = []
    if found.compass is not None:
        tables.append(_compass(found.compass))
        notes += found.compass.notes
    for why, subject in ((found.why, "run"), (found.why_no_advice, "advice")):
        if why:
            notes.append(Note(Severity.ERROR, subject, why))
    if found.advice is not None:
        tables.append(_averaging(found, found.advice))
        tables.append(_kept(found.advice))
    if not tables and not notes:
        return None
    title = QCoreApplication.translate("Gyrocompass", "Planned seeking")
    source = found.choices.noise_source
    if found.run is not None:
        title = f"{found.run.device} {found.choices.channel}".strip()
        template = QCoreApplication.translate("Gyrocompass", "{file}: {rows} readings")
        source = template.format(file=found.name, rows=len(found.run))
    return FindingsState(title, source, tuple(tables), tuple(notes))


def _row(name: str, found: Estimate) -> tuple[str, ...]:
    value, half = value_and_uncertainty(found.value, found.expanded())
    return name, value, half, found.unit.replace("deg", "°")


def _compass(compass: Gyrocompass) -> TableState:
    heading = compass.heading
    half = 0.5 * (heading.high - heading.low)
    value, width = value_and_uncertainty(heading.value, half)
    rows = [
        (QCoreApplication.translate("Gyrocompass", "Heading at 0"), value, width, "°"),
        _row(QCoreApplication.translate("Gyrocompass", "Drift"), compass.drift),
        _row(QCoreApplication.translate("Gyrocompass", "Earth, level part"), compass.level),
    ]
    if np.isfinite(compass.expected_dph):
        name = QCoreApplication.translate("Gyrocompass", "  by the latitude")
        decimals = decimals_of(compass.level.expanded())
        rows.append((name, fixed(compass.expected_dph, decimals), "", "°/h"))
    if "ramp" in compass.fit.names:
        place = compass.fit.index("ramp")
        found = Estimate(
            float(compass.fit.values[place]),
            float(compass.fit.stderr[place]),
            float(compass.fit.t_dof[place]),
            "deg/h/h",
        )
        rows.append(_row(QCoreApplication.translate("Gyrocompass", "Change of the drift"), found))
    return TableState(
        QCoreApplication.translate("Gyrocompass", "Heading and drift"),
        "ω = Ω cos φ cos ε cos(ψ + δ) + Ω sin φ sin ε + d",
        (
            QCoreApplication.translate("Gyrocompass", "Quantity"),
            QCoreApplication.translate("Gyrocompass", "Value"),
            "±U (95 %)",
            QCoreApplication.translate("Gyrocompass", "Unit"),
        ),
        tuple(rows),
    )


def _averaging(found: Found, advice: Advice) -> TableState:
    choices, curve = found.choices, advice.curve
    rows = [
        (
            QCoreApplication.translate("Gyrocompass", "As set"),
            _seconds(choices.average_s),
            significant(advice.now_deg, 2),
            "°",
        ),
        (
            QCoreApplication.translate("Gyrocompass", "Best"),
            _seconds(curve.best_s),
            significant(curve.best_deg, 2),
            "°",
        ),
    ]
    if choices.target_deg > 0:
        name = QCoreApplication.translate("Gyrocompass", "Enough for {target}°")
        reached = np.isfinite(curve.enough_s)
        never = QCoreApplication.translate("Gyrocompass", "never with this gyro")
        rows.append(
            (
                name.format(target=significant(choices.target_deg, 2)),
                _seconds(curve.enough_s) if reached else never,
                significant(choices.target_deg, 2) if reached else "",
                "°" if reached else "",
            )
        )
    law = QCoreApplication.translate(
        "Gyrocompass", "u of the heading: {count} headings, {pause} s to turn, by N, B, K"
    )
    return TableState(
        QCoreApplication.translate("Gyrocompass", "How long to average"),
        law.format(count=len(advice.headings_deg), pause=significant(choices.pause_s, 2)),
        (
            "",
            QCoreApplication.translate("Gyrocompass", "time, s"),
            QCoreApplication.translate("Gyrocompass", "u (k = 1)"),
            QCoreApplication.translate("Gyrocompass", "Unit"),
        ),
        tuple(rows),
    )


def _kept(advice: Advice) -> TableState:
    return TableState(
        QCoreApplication.translate("Gyrocompass", "Kept afterwards by the same gyro"),
        QCoreApplication.translate("Gyrocompass", "Its drift, as found, is subtracted"),
        (
            QCoreApplication.translate("Gyrocompass", "for, h"),
            QCoreApplication.translate("Gyrocompass", "u (k = 1)"),
            QCoreApplication.translate("Gyrocompass", "Unit"),
        ),
        tuple(
            (significant(hours, 2), significant(float(u), 2), "°")
            for hours, u in zip(advice.hours, advice.kept_deg, strict=True)
        ),
        0,
    )


def _seconds(value: float) -> str:
    return significant(value, 2)
