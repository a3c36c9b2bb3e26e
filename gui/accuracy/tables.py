"""An accuracy check as tables and verdicts: Pointer's readouts, Tables 2.5 and 2.6, errors."""

import numpy as np

from core.errors import Note
from core.procedures.accuracy import INTER, OWN, Accuracy, Trace
from core.procedures.angle_errors import PITCH
from core.procedures.conformity import Verdict
from gui.accuracy.checking import Checked
from gui.accuracy.picture import expanded, places
from gui.accuracy.state import Chip
from gui.accuracy.texts import VERDICT_TONE, kind_word, say, trace_word, verdict_word
from gui.widgets.number_text import MINUS, fixed, significant
from gui.widgets.states import TableState, Tone

_DASH = "\N{EM DASH}"
_DIGITS = 3


def title_of(found: Accuracy) -> str:
    """Unit, kind and number of angles."""
    return say("{device}: {kind} accuracy, {count} angles").format(
        device=found.device, kind=kind_word(found.kind).lower(), count=len(found.set_deg)
    )


def parts_of(found: Accuracy) -> tuple[TableState | Note, ...]:
    """Readouts, doubts and tables, in the order of reading."""
    tables = [error_table(found)]
    if found.force.size:
        tables.append(lab_table(found))
    return (readouts(found), *found.notes, *tables)


def readouts(found: Accuracy) -> TableState:
    """Min, Max, (+/-), RMS and Noise STD of every trace, with the verdict."""
    rows = tuple(
        (
            trace_word(trace.source),
            "" if trace.verdict is None else verdict_word(trace.verdict),
            *(
                _angle(value)
                for value in (
                    trace.statistics.minimum,
                    trace.statistics.maximum,
                    trace.statistics.half_span,
                    trace.statistics.rms,
                    trace.statistics.noise_std,
                )
            ),
        )
        for trace in found.traces
    )
    return TableState(
        say("{kind} Accuracy, deg").format(kind=kind_word(found.kind)),
        "",
        (say("Trace"), say("Verdict"), "Min", "Max", "(+/−)", "RMS", "Noise STD"),
        rows,
        2,
    )


def error_table(found: Accuracy) -> TableState:
    """Errors of every trace at every angle with their expanded uncertainties."""
    heads: list[str] = [say("Set")]
    columns: list[list[str]] = [_set(found)]
    for trace in found.traces:
        name = trace_word(trace.source)
        heads += [name, "±U"]
        wide = expanded(trace).tolist()
        columns.append([_angle(value) for value in trace.error.tolist()])
        columns.append([significant(u, 2) if u > 0 else _DASH for u in wide])
        if trace.verdicts:
            heads.append("")
            columns.append([_sign(verdict) for verdict in trace.verdicts])
    law = (
        say("in-plane angle atan2(a_y, a_z) less set angle: the pitch of a full turn")
        if found.full_turn
        else say("angle less set angle")
    )
    return TableState(
        say("Errors, deg, with U (95 %)"), law, tuple(heads), tuple(zip(*columns, strict=True)), 0
    )


def lab_table(found: Accuracy) -> TableState:
    """Table 2.5 (pitch) or 2.6 (roll): codes, calibrated signals, the angle by them."""
    pitch = found.kind == PITCH
    own = found.trace(OWN)
    unit = next((trace for trace in found.traces if trace.source == INTER), None)
    rows = tuple(
        (
            set_deg,
            _DASH if unit is None else fixed(float(_told(unit, found.kind)[i]), 2),
            *(fixed(float(value), 2) for value in found.codes[i]),
            *(fixed(float(value), 4) for value in found.force[i]),
            fixed(float(_told(own, found.kind)[i]), 4),
            significant(float(found.u_calibration[i]), 2),
        )
        for i, set_deg in enumerate(_set(found))
    )
    name = kind_word(found.kind)
    return TableState(
        say("Table {number}: codes, m/s², deg").format(number="2.5" if pitch else "2.6"),
        "a = Q·(U − U0)   (2.5);   θ = arcsin(a_y/|a|)   (2.9)"
        if pitch
        else "a = Q·(U − U0)   (2.5);   γ = −arctan(a_x/a_z)   (2.9), (2.10)",
        (
            say("Set"),
            say("{kind} by the unit").format(kind=name),
            "U_ax",
            "U_ay",
            "U_az",
            "a_x",
            "a_y",
            "a_z",
            say("{kind} calculated").format(kind=name),
            say("u of the calibration"),
        ),
        rows,
        0,
    )


def chips_of(found: Accuracy) -> tuple[Chip, ...]:
    """The verdict on every trace, with the row that decides."""
    return tuple(_chip(found, trace) for trace in found.traces)


def rule_of(checked: Checked) -> str:
    """The limit, the rule, what the uncertainty counts, and the calibration."""
    by = (
        say("Calibration: {name}.").format(name=checked.calibration)
        if checked.calibration
        else say("No calibration: the unit's own angles alone.")
    )
    limit = checked.found.limit
    if limit is None:
        return say("No limit is stated: there is no verdict. {calibration}").format(calibration=by)
    return say("Limit ±{limit}° at every angle. {rule}. U counts {parts}. {calibration}").format(
        calibration=by,
        limit=f"{limit.error_deg:g}",
        rule=limit.rule.text[:1].upper() + limit.rule.text[1:],
        parts=say(
            "the setting of the head, the resolution of reported angles, and the noise of the mean"
        ),
    )


def _chip(found: Accuracy, trace: Trace) -> Chip:
    place = int(np.nanargmax(np.abs(trace.error)))
    worst = say("largest error {error}° at {angle}°").format(
        error=_angle(float(trace.error[place])), angle=_set(found)[place]
    )
    name = trace_word(trace.source)
    if trace.verdict is None:
        return Chip(name, "", Tone.IDLE, worst)
    same = [i for i, verdict in enumerate(trace.verdicts) if verdict is trace.verdict]
    if trace.verdict is not Verdict.PASS:
        count = say("{count} of {total} angles").format(count=len(same), total=len(found.set_deg))
        worst = f"{worst}, {count}"
    return Chip(name, verdict_word(trace.verdict), VERDICT_TONE[trace.verdict], worst)


def _told(trace: Trace, kind: str) -> np.ndarray:
    return trace.pitch if kind == PITCH else trace.roll


def _angle(value: float) -> str:
    return fixed(value, _DIGITS + 1) if np.isfinite(value) else _DASH


def _set(found: Accuracy) -> list[str]:
    """The set angles."""
    return [f"{angle:g}".replace("-", MINUS) for angle in places(found.set_deg)[0].tolist()]


def _sign(verdict: Verdict) -> str:
    return {Verdict.PASS: "✓", Verdict.FAIL: "✗", Verdict.UNDECIDED: "?"}[verdict]
