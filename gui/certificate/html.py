"""A certificate as one HTML text: ISO/IEC 17025:2017, 7.8.2, 7.8.4 and 7.8.6 from top to end."""

import base64
import math
from collections.abc import Iterable
from html import escape
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from core.certificates.certificate import Certificate
from core.certificates.laboratory import Laboratory
from core.certificates.limits import Conformity
from core.certificates.measured import Measured, Printed
from core.procedures.calibration import Provenance
from core.procedures.conformity import Verdict
from gui.certificate.parts import part_html, plain, table_html
from gui.languages.shown import shown, shown_number
from gui.measuring.printed import parts_of
from gui.widgets.number_text import fixed, value_and_uncertainty
from gui.widgets.states import TableState

STYLE = """
body { font-family: 'DejaVu Sans', sans-serif; font-size: 12px; color: #000; background: #fff; }
h1 { font-size: 22px; text-align: center; margin: 8px 0 2px 0; }
h2 { font-size: 16px; margin: 12px 0 4px 0; }
h3 { font-size: 13px; margin: 8px 0 3px 0; }
p { margin: 4px 0 4px 0; }
table.grid { border-collapse: collapse; border-color: #999; }
th { background: #eee; }
@media print { @page { size: A4; margin: 18mm; } }
"""
_KINDS = {".png": "png", ".jpg": "jpeg", ".jpeg": "jpeg", ".svg": "svg+xml"}


def results_html(printed: Iterable[Printed]) -> tuple[str, ...]:
    """The results in pieces; drawing their pictures takes time, so that it is done once.

    Raises
    ------
    FormatError
        A part is of no known kind.
    """
    return tuple(piece for part in parts_of(printed) for piece in part_html(part))


def certificate_sections(
    certificate: Certificate, results: tuple[str, ...], folder: Path
) -> tuple[str, ...]:
    """Return the certificate in pieces, which the end of a page cuts only between lines or rows.

    Parameters
    ----------
    certificate : what is stated
    results : its results, of `results_html`
    folder : of the laboratory's file, which a relative logo belongs to
    """
    laboratory, order = certificate.laboratory, certificate.order
    first, *others = results or ("",)
    pieces = (
        _head(laboratory, folder) + _title(certificate) + _subject(certificate),
        f"<h2>{_t('Method')}</h2>" + _method(certificate.measured.provenance),
        f"<h2>{_t('Conditions')}</h2>" + _conditions(certificate),
        _standards(laboratory),
        f"<h2>{_t('Results')}</h2>" + first,
        *others,
        _uncertainty(certificate.measured),
        "" if certificate.conformity is None else _conformity(certificate.conformity),
        _facts({_t("Before adjustment"): order.before, _t("Remarks"): order.remarks}),
        _end(certificate),
    )
    return tuple(filter(None, pieces))


def whole_html(sections: tuple[str, ...], title: str) -> str:
    """Join sections to a page of their own, for a browser."""
    body = "".join(f'<section style="break-inside: avoid">{piece}</section>' for piece in sections)
    return (
        f'<!DOCTYPE html><html><head><meta charset="utf-8"/><title>{escape(title)}</title>'
        f"<style>{STYLE}</style></head><body>{body}</body></html>\n"
    )


def certificate_title(certificate: Certificate) -> str:
    """What stands at the foot of every page."""
    return f"{_t('Calibration certificate')} {certificate.number}"


def _title(certificate: Certificate) -> str:
    order = certificate.order
    replaced = ""
    if order.replaces:
        words = _t("Replaces certificate No. {number}, which holds no longer.")
        replaced = f'<p align="center">{escape(words.format(number=order.replaces))}</p>'
    return (
        f"<h1>{_t('CALIBRATION CERTIFICATE')}</h1>"
        f'<p align="center"><b>{_t("No.")} {escape(certificate.number)}</b></p>{replaced}<p></p>'
    )


def _subject(certificate: Certificate) -> str:
    laboratory, order = certificate.laboratory, certificate.order
    return _facts(
        {
            _t("Customer"): ", ".join(filter(None, (order.customer, order.contact))),
            _t("Item"): " ".join(filter(None, (order.item, order.model))),
            _t("Serial number"): order.serial,
            _t("Condition of the item"): order.condition,
            _t("Received"): order.received,
            _t("Calibrated"): order.calibrated,
            _t("Issued"): order.issued,
            _t("Place"): laboratory.place or laboratory.address,
            _t("What was changed"): order.change,
        }
    )


def _end(certificate: Certificate) -> str:
    laboratory = certificate.laboratory
    return (
        f"<p>{_t('The results relate only to the item calibrated.')} "
        f"{_t('The certificate may be reproduced only in full.')}</p>"
        + (f"<p>{_lines(laboratory.statement)}</p>" if laboratory.statement else "")
        + _signature(laboratory, certificate.order.issued)
        + f'<p align="center">— {_t("End of the certificate")} {escape(certificate.number)} —</p>'
    )


def _head(laboratory: Laboratory, folder: Path) -> str:
    logo = _logo(laboratory, folder)
    lines = [f"<b>{escape(laboratory.name)}</b>", escape(laboratory.address)]
    if laboratory.accreditation:
        lines.append(f"{_t('Accreditation')}: {escape(laboratory.accreditation)}")
    words = "<br/>".join(filter(None, lines))
    return f'<table width="100%"><tr><td>{logo}</td><td align="right">{words}</td></tr></table>'


def _logo(laboratory: Laboratory, folder: Path) -> str:
    if not laboratory.logo:
        return ""
    path = folder / laboratory.logo
    kind = _KINDS.get(path.suffix.lower())
    try:
        content = path.read_bytes()
    except OSError:
        content = b""
    if kind is None or not content:
        # The certificate is worth more than its picture; the form says that it is missing.
        return ""
    data = base64.b64encode(content).decode("ascii")
    return f'<img height="60" alt="" src="data:image/{kind};base64,{data}"/>'


def _method(origin: Provenance) -> str:
    records = "; ".join(f"{name} (SHA-256 {sha[:16]}…)" for name, sha in origin.records)
    return _facts(
        {
            _t("Procedure"): shown(origin.procedure),
            _t("Plan"): origin.plan,
            _t("Measured"): origin.measured_utc.replace("T", " ").replace("+00:00", " UTC"),
            _t("Records"): records,
            _t("Software"): origin.software,
        }
    )


def _conditions(certificate: Certificate) -> str:
    stated, air = certificate.measured.conditions, certificate.surroundings
    gravity = ""
    if stated.g_mps2 > 0:
        value, u = value_and_uncertainty(stated.g_mps2, 2.0 * stated.u_g_mps2)
        value, u = shown_number(value), shown_number(u)
        gravity = f"{value} m/s²" if not stated.u_g_mps2 > 0 else f"({value} ± {u}) m/s²"
    return _facts(
        {
            _t("Air temperature"): _quantity(air.temperature_c, 1, "°C"),
            _t("Relative humidity"): _quantity(air.humidity_percent, 0, "%"),
            _t("Air pressure"): _quantity(air.pressure_hpa, 0, "hPa"),
            _t("Supply of the item"): _quantity(air.supply_v, 2, "V"),
            _t("Temperature of the item"): _quantity(certificate.measured.temperature_c, 1, "°C"),
            _t("Local gravity g"): gravity,
            _t("Latitude"): _quantity(stated.latitude_deg, 4, "°"),
            _t("Standard uncertainty of a head setting"): _quantity(stated.head_u_arcsec, 1, "″"),
            _t("Standard uncertainty of a table rate"): _quantity(stated.rate_u_ppm, 0, "ppm"),
        }
    )


def _quantity(value: float, decimals: int, unit: str) -> str:
    return f"{shown_number(fixed(value, decimals))} {unit}" if math.isfinite(value) else ""


def _standards(laboratory: Laboratory) -> str:
    if not laboratory.standards:
        return ""
    return table_html(
        TableState(
            _t("Standards used and their traceability"),
            "",
            (
                _t("Standard"),
                _t("Serial number"),
                _t("Certificate"),
                _t("Valid until"),
                _t("Traceable to"),
            ),
            tuple(
                (one.name, one.serial, one.certificate, one.valid_until, one.traceable_to)
                for one in laboratory.standards
            ),
            5,
        )
    )


def _uncertainty(measured: Measured) -> str:
    if not measured.coverage:
        words = _t("The positions leave no degree of freedom: no uncertainty can be stated.")
        return f"<p>{escape(words)}</p>"
    if measured.coefficients:
        words = _t(
            "The stated intervals are two-sided, for a coverage probability of 95 %, from the"
            " profile of the likelihood; U is the larger of their two halves. Of what was not"
            " detected the one-sided limit is stated (<), for the same probability."
        )
        return f"<p>{escape(words)}</p>"
    low, high = (
        shown_number(fixed(k, 2)) for k in (min(measured.coverage), max(measured.coverage))
    )
    span = f"k\u00a0=\u00a0{low}" if low == high else f"k\u00a0=\u00a0{low}\u00a0…\u00a0{high}"
    words = (
        _t(
            "The stated uncertainty is the expanded uncertainty U: the standard uncertainty times"
            " the coverage factor {span}, for a normal distribution and a coverage probability of"
            " 95 %."
        )
        if measured.calibration is None
        else _t(
            "The stated uncertainty is the expanded uncertainty U: the standard uncertainty times"
            " the coverage factor {span}, Student's t for the effective degrees of freedom of each"
            " result, for a coverage probability of 95 %."
        )
    )
    return f"<p>{escape(words.format(span=span))}</p>"


def _conformity(conformity: Conformity) -> str:
    rows = tuple(
        (
            one.channel,
            one.symbol,
            verdict_words(one.verdict),
            *value_and_uncertainty(one.deviation, one.expanded),
            plain(one.limit),
            one.unit.replace("^2", "²"),
        )
        for one in conformity.judged
    )
    header = (
        _t("Sensor"),
        _t("Parameter"),
        _t("Verdict"),
        _t("Deviation"),
        _t("± U (95 %)"),
        _t("± Limit"),
        _t("Unit"),
    )
    verdict = f"<p><b>{_t('Conformity')}: {verdict_words(conformity.verdict)}</b></p>"
    rule = f"<p>{_t('Decision rule')}: {escape(shown(conformity.rule))}.</p>"
    table = TableState(_t("Statement of conformity"), "", header, rows, 3)
    return table_html(table) + verdict + rule


def verdict_words(verdict: Verdict) -> str:
    """A verdict in the words of a certificate."""
    return {
        Verdict.PASS: _t("PASS"),
        Verdict.FAIL: _t("FAIL"),
        Verdict.UNDECIDED: _t("UNDECIDED"),
    }[verdict]


def _signature(laboratory: Laboratory, issued: str) -> str:
    who = ", ".join(filter(None, (laboratory.authorised_by, laboratory.position)))
    return (
        f'<p><br/></p><table width="100%"><tr><td>{_t("Authorised by")}: {escape(who)}</td>'
        f'<td align="right">{escape(issued)}&nbsp;&nbsp;&nbsp;{"_" * 22}</td></tr></table>'
    )


def _facts(facts: dict[str, str]) -> str:
    rows = "".join(
        f'<tr><td width="200">{escape(name)}</td><td>{_lines(text)}</td></tr>'
        for name, text in facts.items()
        if text
    )
    return f'<table cellspacing="0" cellpadding="2" width="100%">{rows}</table>' if rows else ""


def _lines(text: str) -> str:
    """Text that keeps the lines in which it was typed."""
    return escape(text).replace("\n", "<br/>")


def _t(text: str) -> str:
    return QCoreApplication.translate("Certificate", text)
