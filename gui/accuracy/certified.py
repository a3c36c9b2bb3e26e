"""An accuracy check as a certificate takes it."""

import numpy as np

from core.certificates.limits import Conformity, Judged
from core.certificates.measured import LEVEL, Measured
from core.fit.quantiles import student_t
from core.procedures.accuracy import ALIGNED, Trace
from core.procedures.angle_errors import PITCH
from core.procedures.calibration import Provenance
from core.procedures.conformity import worst
from core.version import SOFTWARE
from gui.accuracy.checking import Checked
from gui.accuracy.picture import expanded
from gui.accuracy.tables import parts_of
from gui.accuracy.texts import say, trace_word
from gui.measuring.printed import printed_of


def measured_of_check(checked: Checked) -> Measured:
    """A judged check, or one without limits, with where it comes from."""
    found, run = checked.found, checked.run
    known = found.temperature_c[np.isfinite(found.temperature_c)]
    name, sha256 = run.meta.get("source", checked.source), run.meta.get("source_sha256", "")
    name_of_angle = say("Pitch") if found.kind == PITCH else say("Roll")
    return Measured(
        Provenance(
            procedure=say("{kind} against the angles of the dividing head").format(
                kind=name_of_angle
            ),
            device=found.device,
            profile=str(run.meta.get("profile", "")),
            plan=str(run.meta.get("plan", "")),
            records=((str(name), str(sha256)),) if sha256 else (),
            software=SOFTWARE,
            measured_utc=str(run.meta.get("measured_utc", "")),
        ),
        checked.request.conditions,
        float(known.mean()) if len(known) else float("nan"),
        (student_t(LEVEL, float("inf")),),
        printed_of(parts_of(found)),
        conformity=_conformity(checked),
    )


def _conformity(checked: Checked) -> Conformity | None:
    """The verdict on every trace by the row that decides; None without a limit."""
    found = checked.found
    if found.limit is None:
        return None
    # What is left after the mounting was taken out is no answer of the unit.
    traces = [trace for trace in found.traces if trace.source != ALIGNED and trace.verdicts]
    if not traces:
        return None
    symbol = "θ" if found.kind == PITCH else "γ"
    judged = tuple(_judged(trace, symbol, found.limit.error_deg) for trace in traces)
    return Conformity(found.limit.rule.text, judged, worst(tuple(one.verdict for one in judged)))


def _judged(trace: Trace, symbol: str, limit_deg: float) -> Judged:
    verdict = worst(trace.verdicts)
    rows = [row for row, one in enumerate(trace.verdicts) if one is verdict]
    row = max(rows, key=lambda one: abs(float(trace.error[one])))
    return Judged(
        trace_word(trace.source),
        symbol,
        "deg",
        float(trace.error[row]),
        float(expanded(trace)[row]),
        limit_deg,
        verdict,
    )
