"""What the archive told -> the right-hand side and the picture."""

import numpy as np
from PySide6.QtCore import QCoreApplication

from core.archive.entry import Entry
from core.archive.history import History
from core.archive.importing import DAMAGED_FILE, UNKNOWN, FileReport
from core.arrays import frozen, frozen_int
from core.errors import Note, Severity
from gui.archive.questions import Details, Parameter, Redecoded
from gui.archive.state import HistoryState
from gui.archive.texts import (
    compared_row,
    degrees,
    local,
    parameter_row,
    reasons,
    redone_row,
    spoken,
    statistics_rows,
)
from gui.widgets.number_text import fixed
from gui.widgets.states import FindingsState, TableState

_FILES_SHOWN = 200
_VERDICTS = {"damaged": Severity.ERROR, "bad": Severity.ERROR, "doubt": Severity.WARNING}


def of_details(details: Details, history: History | None, followed: str) -> FindingsState:
    """Return the tables of what is chosen, and the statistics of the parameter that is followed."""
    tables = [_compared(details)] if details.compared else _single(details)
    if history is not None:
        tables.append(_statistics(history, followed))
    entry = details.entries[0]
    notes = list(details.compared.notes if details.compared else ())
    if not details.compared and entry.remark:
        notes.append(Note(_VERDICTS.get(entry.verdict, Severity.INFO), "remark", entry.remark))
    if details.why_not:
        notes.append(Note(Severity.WARNING, "elsewhere", details.why_not))
    if history is not None:
        notes += history.notes
    return FindingsState(_title(details), _source(details), tuple(tables), tuple(notes))


def _title(details: Details) -> str:
    if details.compared is not None:
        first, second = details.compared.first, details.compared.second
        one, other = local(first.measured)[:10], local(second.measured)[:10]
        if first.serial == second.serial:
            return f"{first.serial}: {one} → {other}"
        return f"{first.serial} {one} → {second.serial} {other}"
    entry = details.entries[0]
    return f"{entry.serial}, {local(entry.measured)}"


def _source(details: Details) -> str:
    compared = details.compared
    if compared is not None:
        text = QCoreApplication.translate(
            "Archive", "{marked} of {all} parameters differ by more than 2 u"
        )
        return text.format(marked=compared.marked, all=len(compared.rows))
    entry = details.entries[0]
    return "\n".join(filter(None, (entry.what, str(details.path or entry.path))))


def _single(details: Details) -> list[TableState]:
    entry = details.entries[0]
    tables = [_facts(entry)]
    if details.quantities:
        limited = any(details.limits)
        header = (
            QCoreApplication.translate("Archive", "channel"),
            QCoreApplication.translate("Archive", "parameter"),
            QCoreApplication.translate("Archive", "value"),
            "U",
            QCoreApplication.translate("Archive", "unit"),
            QCoreApplication.translate("Archive", "limits"),
        )
        rows = [
            parameter_row(quantity, limit)
            for quantity, limit in zip(details.quantities, details.limits, strict=True)
        ]
        width = len(header) if limited else len(header) - 1
        tables.insert(
            0,
            TableState(
                QCoreApplication.translate("Archive", "Parameters, U for 95 %"),
                _rule() if limited else "",
                header[:width],
                tuple(row[:width] for row in rows),
                words=2,
            ),
        )
    if details.proposals:
        tables.append(_proposals(details))
    return tables


def _rule() -> str:
    return QCoreApplication.translate(
        "Archive", "pass: value ± U within the limits; fail: beyond; else undecided (JCGM 106)"
    )


def _facts(entry: Entry) -> TableState:
    rows = [
        (QCoreApplication.translate("Archive", "verdict"), entry.verdict),
        (QCoreApplication.translate("Archive", "sensor"), entry.sensor),
        (QCoreApplication.translate("Archive", "operator"), entry.operator),
        (QCoreApplication.translate("Archive", "device file"), entry.profile),
        (QCoreApplication.translate("Archive", "temperature, °C"), degrees(entry.temperature_c)),
        (_counted(entry.kind), str(entry.count) if entry.count else ""),
    ]
    known = tuple(row for row in rows if row[1])
    return TableState(
        QCoreApplication.translate("Archive", "What it is"),
        "",
        (QCoreApplication.translate("Archive", "kind"), entry.kind),
        known,
        words=2,
    )


def _counted(kind: str) -> str:
    if kind == "calibration":
        return QCoreApplication.translate("Archive", "sensors")
    if kind == "session":
        return QCoreApplication.translate("Archive", "positions")
    return QCoreApplication.translate("Archive", "rows")


def _proposals(details: Details) -> TableState:
    rows = tuple(
        (
            local(one.entry.measured),
            f"{fixed(one.days, 1)}",
            degrees(one.entry.temperature_c),
            one.entry.verdict,
        )
        for one in details.proposals
    )
    header = (
        QCoreApplication.translate("Archive", "measured"),
        QCoreApplication.translate("Archive", "days later"),
        "°C",
        QCoreApplication.translate("Archive", "verdict"),
    )
    title = QCoreApplication.translate("Archive", "Nearest calibrations by date and temperature")
    return TableState(title, "", header, rows)


def _compared(details: Details) -> TableState:
    header = (
        QCoreApplication.translate("Archive", "channel"),
        QCoreApplication.translate("Archive", "parameter"),
        "",
        "d / u",
        "d",
        "U",
        QCoreApplication.translate("Archive", "unit"),
        QCoreApplication.translate("Archive", "first"),
        QCoreApplication.translate("Archive", "second"),
    )
    rows = tuple(compared_row(row) for row in details.compared.rows) if details.compared else ()
    return TableState(
        QCoreApplication.translate("Archive", "d = second minus first"),
        QCoreApplication.translate("Archive", "u² = u₁² + u₂²;  U = 2 u;  differs: |d| > 2 u"),
        header,
        rows,
        words=3,
    )


def _statistics(history: History, followed: str) -> TableState:
    title = QCoreApplication.translate("Archive", "History of {name}, {n} calibrations")
    return TableState(
        title.format(name=followed, n=history.n),
        "",
        (
            "",
            QCoreApplication.translate("Archive", "value"),
            "U",
            QCoreApplication.translate("Archive", "unit"),
        ),
        tuple(statistics_rows(history)),
    )


def of_import(reports: tuple[FileReport, ...]) -> FindingsState:
    """Return what became of every file; doubtful ones first."""
    order = {DAMAGED_FILE: 0, UNKNOWN: 1}
    ranked = sorted(reports, key=lambda report: order.get(report.outcome, 2))
    rows = tuple((report.outcome, report.what, report.path.name) for report in ranked)
    counts: dict[str, int] = {}
    for report in reports:
        counts[report.outcome] = counts.get(report.outcome, 0) + 1
    header = (
        "",
        QCoreApplication.translate("Archive", "what"),
        QCoreApplication.translate("Archive", "file"),
    )
    table = TableState(
        QCoreApplication.translate("Archive", "Files"), "", header, rows[:_FILES_SHOWN], words=3
    )
    told = ", ".join(f"{count} {outcome}" for outcome, count in counts.items())
    title = QCoreApplication.translate("Archive", "Import")
    nothing = QCoreApplication.translate("Archive", "no files")
    return FindingsState(title, told or nothing, (table,) if rows else (), ())


def of_redecoded(redecoded: Redecoded) -> FindingsState:
    """Return a session decoded again beside what is stored."""
    found = redecoded.found
    same = sum(one.same for one in found)
    told = QCoreApplication.translate("Archive", "{same} of {all} positions give the same means")
    header = (
        QCoreApplication.translate("Archive", "position"),
        "",
        QCoreApplication.translate("Archive", "samples"),
        QCoreApplication.translate("Archive", "again"),
        QCoreApplication.translate("Archive", "largest d / se"),
    )
    title = QCoreApplication.translate("Archive", "Decoded again from the raw bytes")
    table = TableState(title, "", header, tuple(redone_row(one) for one in found), words=2)
    entry = redecoded.entry
    return FindingsState(
        f"{entry.serial}, {local(entry.measured)}",
        told.format(same=same, all=len(found)),
        (table,),
        tuple(Note(Severity.WARNING, "not_decoded", why) for why in reasons(found)),
    )


def name_of(parameter: Parameter) -> str:
    """A parameter as it is chosen."""
    return f"{parameter.channel}  {spoken(parameter.name)}"


def picture_of(history: History, parameter: Parameter, chosen: tuple[int, ...]) -> HistoryState:
    """Return the history as it is drawn."""
    moments = [reading.entry.when for reading in history.readings]
    limit = history.limit
    return HistoryState(
        title=f"{parameter.serial}  {name_of(parameter)}",
        unit=history.unit,
        seconds=frozen([np.nan if when is None else when.timestamp() for when in moments]),
        values=frozen([reading.quantity.value for reading in history.readings]),
        expanded=frozen([reading.quantity.expanded() for reading in history.readings]),
        counted=frozen_int([int(one) for one in history.counted]),
        chosen=frozen_int(
            [i for i, reading in enumerate(history.readings) if reading.entry.id in chosen]
        ),
        mean=history.mean,
        spread=history.repeatability,
        low=-np.inf if limit is None else limit.low,
        high=np.inf if limit is None else limit.high,
    )
