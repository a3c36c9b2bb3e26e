"""The noise of a record as a certificate takes it: names of IEEE Std 952 and 1431."""

import hashlib
import math
from pathlib import Path

import numpy as np

from core.allan.confidence import interval as limits_of_curve
from core.allan.conventions import conventions
from core.allan.curve import AllanCurve
from core.allan.model import TERMS
from core.certificates.limits import Stated
from core.certificates.measured import LEVEL, Measured
from core.errors import FitError, FormatError
from core.fit.quantiles import student_t
from core.procedures.calibration import Provenance
from core.records.noise_study import NoiseStudy, StudyRequest, study
from core.records.noise_tables import Quote, in_conventions, published_row, terms_of
from core.records.series import Series
from core.samples.run import Conditions
from core.version import SOFTWARE
from drivers.rawlog import rawlog_header
from drivers.records import is_recording
from drivers.series import read_series
from gui.allan.findings import LAW
from gui.allan.texts import duration, interval, plain_unit, quoted, words_of
from gui.measuring.page import LogCurveState, Part
from gui.measuring.printed import printed_of
from gui.widgets.number_text import grouped, significant
from gui.widgets.states import TableState

PROCEDURE = (
    "noise of a record at rest: likelihood of its spectrum and Allan deviation, terms of IEEE Std"
    " 952 and IEEE Std 1431, practicum (6.3), (6.4)"
)
_NAMES = {
    "deg/s": {
        "random_walk": "angle random walk",
        "bias_instability": "bias instability",
        "rate_random_walk": "rate random walk",
        "rate_ramp": "rate ramp",
        "quantization": "angle quantization",
    },
    "m/s^2": {
        "random_walk": "velocity random walk",
        "bias_instability": "bias instability",
        "rate_random_walk": "acceleration random walk",
        "rate_ramp": "acceleration ramp",
        "quantization": "velocity quantization",
    },
}
"""As the standards name the terms, by the unit of the record."""
_POINTS = 60
_SEEN = 0.02
"""Share of the lowest point of the curve below which a term is not drawn."""


def measured_of_record(path: Path, conditions: Conditions, request: StudyRequest) -> Measured:
    """Read a record, analyse its noise, and state it.

    Raises
    ------
    FormatError, FitError
        It cannot be read, or no noise model holds for it: then nothing can be certified.
    """
    series = read_series(path)
    found = study(series, request)
    return measured_of_study(found, conditions, _temperature(series), _sha256(path))


def measured_of_study(
    found: NoiseStudy, conditions: Conditions, temperature_c: float, sha256: str
) -> Measured:
    """An analysed record as a certificate takes it.

    Parameters
    ----------
    found : the analysis
    conditions : what the laboratory stated
    temperature_c : mean of the record; NaN where unknown
    sha256 : of its file

    Raises
    ------
    FitError
        No noise model holds for it.
    """
    coefficients = tuple(_stated(found))
    if not coefficients:
        why = next((n.text for n in found.notes if n.subject == "no_fit"), "no term was fitted")
        raise FitError(f"{Path(found.path).name}: its noise cannot be certified: {why}")
    path = Path(found.path)
    return Measured(
        Provenance(
            procedure=PROCEDURE,
            device=found.device,
            profile="",
            plan="",
            records=((path.name, sha256),) if sha256 else (),
            software=SOFTWARE,
            measured_utc=_begun(path),
        ),
        conditions,
        temperature_c,
        (student_t(LEVEL, math.inf),),
        printed_of(_parts(found)),
        coefficients=coefficients,
    )


def _stated(found: NoiseStudy) -> list[Stated]:
    """The published coefficients in the unit of the record; limits of what was not detected."""
    stated: list[Stated] = []
    for term in terms_of(found.published):
        row = published_row(found.published, term)
        if row is None:
            continue
        value = 0.0 if row.upper_limit else row.value
        half = max(row.upper - value, value - row.lower)
        stated.append(Stated(found.channel, term, row.symbol, row.unit, value, half))
    return stated


def _parts(found: NoiseStudy) -> tuple[Part, ...]:
    return (_table(found), _picture(found), _record(found), *found.notes)


def _table(found: NoiseStudy) -> TableState:
    names = _NAMES.get(found.unit, _NAMES["deg/s"])
    rows = [
        (
            names[term] if first else "",
            quote.symbol,
            words_of(quote),
            quoted(quote),
            interval(quote),
            plain_unit(quote.unit),
        )
        for term in terms_of(found.published)
        for first, quote in _marked(found, term)
    ]
    return TableState(
        "Noise coefficients, 95 %",
        LAW,
        ("term (IEEE 952, IEEE 1431)", "", "stated as", "value", "from … to", "unit"),
        tuple(rows),
        words=6,
    )


def _marked(found: NoiseStudy, term: str) -> list[tuple[bool, Quote]]:
    quotes = in_conventions(found.published, term)
    return [(place == 0, quote) for place, quote in enumerate(quotes)]


def _picture(found: NoiseStudy) -> LogCurveState:
    published = found.published
    curve: AllanCurve = published.curve
    low, high = limits_of_curve(curve.deviation, curve.edf, LEVEL)
    taus = np.geomspace(float(curve.taus[0]), float(curve.taus[-1]), _POINTS)
    lines = [("fitted model", np.sqrt(published.model.variance(taus)))]
    for term, law in TERMS.items():
        part = np.sqrt(published.model.part(term, taus))
        if float(part.max()) > _SEEN * float(curve.deviation.min()):
            lines.append((law.symbol, part))
    return LogCurveState(
        "Allan deviation with its 95 % limits",
        "averaging time τ, s",
        f"σ(τ), {plain_unit(found.unit)}",
        tuple(curve.taus.tolist()),
        tuple(curve.deviation.tolist()),
        tuple(low.tolist()),
        tuple(high.tolist()),
        tuple((name, tuple(taus.tolist()), tuple(y.tolist())) for name, y in lines),
    )


def _record(found: NoiseStudy) -> TableState:
    curve = found.published.curve
    facts = [
        ("channel", found.channel, ""),
        ("length of the record", duration(curve.duration), ""),
        ("samples", grouped(curve.n), ""),
        ("sampling rate", significant(found.rate, 6), "Hz"),
        ("highest frequency fitted", significant(found.published.band, 4), "Hz"),
    ]
    if found.scale_factor != 1.0:
        unit = plain_unit(conventions("bias_instability", found.unit)[0].unit)
        facts.append(("scale factor", significant(found.scale_factor, 7), f"output/({unit})"))
    return TableState("Record", "", ("", "value", "unit"), tuple(facts), words=3)


def _temperature(series: Series) -> float:
    """Mean of the record's thermometer; NaN without one."""
    for place, channel in enumerate(series.channels):
        if channel.role.startswith("temp") and channel.unit == "degC":
            return float(np.nanmean(series.columns[place]))
    return math.nan


def _begun(path: Path) -> str:
    if not (path.is_file() and is_recording(path)):
        return ""
    return str(rawlog_header(path).get("started_utc", ""))


def _sha256(path: Path) -> str:
    try:
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise FormatError(path, f"cannot be read: {error.strerror}") from error
