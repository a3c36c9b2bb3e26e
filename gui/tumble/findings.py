"""A study -> tables of the right-hand side: what is well determined comes first."""

from PySide6.QtCore import QCoreApplication

from core.errors import Note
from core.fit.estimate import Estimate
from core.procedures.fourier.study import TumbleStudy
from core.procedures.fourier.tumble import TumbleResult
from core.procedures.propagation import Spread
from gui.widgets.number_text import decimals_of, fixed, significant, value_and_uncertainty
from gui.widgets.states import FindingsState, TableState

_LAW = "u = C0 + C1 sin α + C2 cos α + C3 sin 2α + C4 cos 2α"
_MOST_DECIMALS = 6
_THIRD = " + C5 sin 3α + C6 cos 3α"


def findings_of(study: TumbleStudy, title: str, source: str) -> FindingsState:
    """All tables and doubts of a study."""
    tables: list[TableState] = []
    notes: list[Note] = []
    for mount, tumble in zip(study.mounts, study.tumbles, strict=True):
        tables.append(_determined(tumble, mount if len(study.mounts) > 1 else ""))
        notes += [note for note in tumble.notes if note not in notes]
    if study.split is not None:
        notes += study.split.notes
        if study.split.separable:
            tables.append(_split(study))
    if study.flip is not None:
        tables.append(_flip(study))
    overlaps = [tumble for tumble in study.tumbles if tumble.overlap is not None]
    if overlaps:
        tables.append(_overlap(study))
    if study.pairs:
        tables.append(_pairs(study))
    return FindingsState(title, source, tuple(tables), tuple(notes))


def _shown(unit: str) -> str:
    return unit.replace("m/s^2", "m/s²").replace("deg", "°").replace(")^2", ")²")


def _row(name: str, found: Estimate) -> tuple[str, ...]:
    value, half = value_and_uncertainty(found.value, found.expanded())
    return name, value, half, _shown(found.unit)


def _header() -> tuple[str, ...]:
    return (
        QCoreApplication.translate("Tumble", "Quantity"),
        QCoreApplication.translate("Tumble", "Value"),
        "±U (95 %)",
        QCoreApplication.translate("Tumble", "Unit"),
    )


def _determined(tumble: TumbleResult, mount: str) -> TableState:
    title = QCoreApplication.translate("Tumble", "Well determined (14)")
    rows = [
        _row(QCoreApplication.translate("Tumble", "U0, with K2·g²/2"), tumble.bias),
        _row(QCoreApplication.translate("Tumble", "Sensitivity"), tumble.sensitivity),
        _row(QCoreApplication.translate("Tumble", "Misalignment, whole"), tumble.misalignment),
    ]
    for harmonic in tumble.harmonics[1:]:
        rows.append(_row(f"sin {harmonic.order}α", harmonic.sine))
        rows.append(_row(f"cos {harmonic.order}α", harmonic.cosine))
    law = _LAW + (_THIRD if len(tumble.harmonics) > 2 else "")
    return TableState(f"{title}, {mount}" if mount else title, law, _header(), tuple(rows))


def _split(study: TumbleStudy) -> TableState:
    parts = study.split
    if parts is None:
        raise ValueError("a study without a split has no table of it")
    named = (
        ("α0", parts.alpha0),
        ("k_x", parts.k_x),
        ("k_y", parts.k_y),
        ("k_xy", parts.k_xy),
    )
    return TableState(
        QCoreApplication.translate("Tumble", "Split (18), if K2 = 0"),
        "tan 2α0 = C4/C3,  k_xy = sign(C3)·2/g²·√(C3² + C4²)",
        (
            QCoreApplication.translate("Tumble", "Quantity"),
            QCoreApplication.translate("Tumble", "Value"),
            QCoreApplication.translate("Tumble", "from"),
            QCoreApplication.translate("Tumble", "to (95 %)"),
        ),
        tuple(_spread(name, spread) for name, spread in named),
    )


def _spread(name: str, spread: Spread) -> tuple[str, ...]:
    half = 0.5 * (spread.high - spread.low)
    unit, factor = _shown(spread.unit), 1.0
    if half > 0 and decimals_of(half) > _MOST_DECIMALS:
        # So many zeros would hide the digits, and push the limits out of sight.
        unit, factor = f"10⁻⁶ {unit}", 1e6
    words = f"{name}, {unit}"
    if not half > 0:
        return words, significant(spread.value, 7), "", ""
    decimals = decimals_of(half * factor)
    numbers = (spread.value, spread.low, spread.high)
    return words, *(fixed(number * factor, decimals) for number in numbers)


def _flip(study: TumbleStudy) -> TableState:
    flip = study.flip
    if flip is None:
        raise ValueError("a study without a flip has no table of it")
    rows = (
        _row(QCoreApplication.translate("Tumble", "Fixture"), flip.fixture),
        _row(QCoreApplication.translate("Tumble", "Sensor in its case"), flip.misalignment),
        _row("U0", flip.bias),
        _row("k", flip.k),
        _row(QCoreApplication.translate("Tumble", "k across"), flip.k_cross),
        _row("k_xy", flip.product),
        _row("K2", flip.quadratic),
    )
    return TableState(
        QCoreApplication.translate("Tumble", "Fixture and sensor apart"),
        QCoreApplication.translate(
            "Tumble", "Half sum and half difference of the two mounts; nothing is assumed of K2"
        ),
        _header(),
        rows,
    )


def _overlap(study: TumbleStudy) -> TableState:
    rows: list[tuple[str, ...]] = []
    template = QCoreApplication.translate("Tumble", "{pairs} angles twice")
    for mount, tumble in zip(study.mounts, study.tumbles, strict=True):
        if tumble.overlap is None:
            continue
        name = template.format(pairs=tumble.overlap.pairs)
        rows.append(
            _row(f"{name}, {mount}" if len(study.mounts) > 1 else name, tumble.overlap.drift)
        )
    return TableState(
        QCoreApplication.translate("Tumble", "Drift over a full turn"),
        QCoreApplication.translate("Tumble", "Angles that came again, e.g. 5° and 365°"),
        _header(),
        tuple(rows),
    )


def _pairs(study: TumbleStudy) -> TableState:
    rows: list[tuple[str, ...]] = []
    for pair in study.pairs:
        rows.append(_row(f"U0, {pair.axis.upper()}", pair.bias))
        rows.append(_row(f"k_{pair.axis}", pair.response))
    return TableState(
        QCoreApplication.translate("Tumble", "Test turns (4), (5), (8), (11)"),
        "U0 = (u↑ + u↓)/2,  k = (u↑ − u↓)/(2g)",
        _header(),
        tuple(rows),
    )
