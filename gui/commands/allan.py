"""FILE is a record of a sensor at rest, of any kind.

A recording or raw log, a file of CVGCom, a run file of a record, or columns of numbers.

N is the coefficient of the two-sided spectral density, 1 deg/s/sqrt(Hz) = 60 deg/sqrt(h); data
sheets give the one-sided density, sqrt(2) N. The flat part of the curve is 0.664 B. With several
files the devices are compared.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TypeVar

from core.allan.conventions import conventions
from core.allan.curve import AllanCurve
from core.records.noise_exports import NOISE_EXPORTS, export_noise
from core.records.noise_study import NoiseStudy, StudyRequest, study
from core.records.noise_tables import (
    METHODS,
    NAMES,
    by_method,
    comparison,
    in_conventions,
    terms_of,
)
from drivers.series import read_series
from gui.allan.texts import (
    DEVIATIONS,
    compared_rows,
    curve_rows,
    duration,
    interval,
    quoted,
    short,
    titled,
    words_of,
)
from gui.commands.answer import Answer

_T = TypeVar("_T")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the files and what they may not tell themselves."""
    parser.add_argument("file", nargs="+", type=Path, help="record of a sensor at rest")
    parser.add_argument(
        "--channel",
        action="append",
        default=[],
        help="name, role or number of the channel; may be given once a file",
    )
    parser.add_argument(
        "--rate", type=_positive, default=0.0, metavar="HZ", help="samples per second"
    )
    parser.add_argument("--unit", default="", help="unit of the samples: deg/s, m/s^2, code, ...")
    parser.add_argument(
        "--scale-factor",
        action="append",
        type=float,
        default=[],
        metavar="K",
        help="output for 1 deg/s (1 m/s^2); may be given once a file",
    )
    parser.add_argument(
        "--angle-increments",
        action="store_true",
        help="the samples are increments of angle (velocity) times the rate: fit Q too",
    )
    parser.add_argument(
        "--bandwidth", type=_positive, default=0.0, metavar="HZ", help="of the sensor, if known"
    )
    parser.add_argument(
        "--regress",
        action="append",
        default=[],
        metavar="CHANNEL",
        help="take off what this channel explains, e.g. Temperature",
    )
    parser.add_argument("--order", type=int, choices=(1, 2, 3), default=1, help="highest power (1)")
    parser.add_argument(
        "--beside",
        choices=tuple(DEVIATIONS),
        default="",
        help="another deviation too; needs the package AllanTools",
    )
    parser.add_argument(
        "--export",
        nargs=2,
        action="append",
        default=[],
        metavar=("FORMAT", "OUT"),
        help=f"write a file; FORMAT is {', '.join(NOISE_EXPORTS)}",
    )


def run(args: argparse.Namespace) -> Answer:
    """Analyse every file and compare the devices."""
    unknown = [key for key, _ in args.export if key not in NOISE_EXPORTS]
    if unknown:
        raise SystemExit(f"calrig allan: --export {unknown[0]}: use {', '.join(NOISE_EXPORTS)}")
    studies: list[NoiseStudy] = []
    lines: list[str] = []
    for place, path in enumerate(args.file):
        request = StudyRequest(
            channel=_of(args.channel, place, ""),
            rate=args.rate,
            unit=args.unit,
            scale_factor=_of(args.scale_factor, place, 0.0),
            increments=args.angle_increments,
            bandwidth=args.bandwidth,
            regressors=tuple(args.regress),
            order=args.order,
            beside=args.beside,
        )
        one = study(read_series(path), request)
        studies.append(one)
        lines += _report(one)
    if len(studies) > 1:
        lines += _comparison(studies)
    for key, out in args.export:
        export_noise(studies, key, Path(out))
        lines.append(f"written: {out}")
    data = {"records": [_plain(one) for one in studies]}
    return Answer(data, "\n".join(lines))


def _positive(text: str) -> float:
    value = float(text)
    if not value > 0.0:
        raise argparse.ArgumentTypeError(f"{text} is not above zero")
    return value


def _of(given: Sequence[_T], place: int, default: _T) -> _T:
    """The value of a file: its own, or the last one that was given."""
    return given[min(place, len(given) - 1)] if given else default


def _plain(one: NoiseStudy) -> dict[str, object]:
    plain: dict[str, object] = {
        "file": one.path,
        "device": one.device,
        "channel": one.channel,
        "unit": one.unit,
        "rate_hz": one.rate,
        "scale_factor": one.scale_factor,
        "samples": one.samples,
        "duration_s": one.coefficients.curve.duration,
        "curve": one.coefficients.curve,
        "coefficients": one.coefficients.rows,
        "band_hz": one.coefficients.band,
        "conventions": {
            term: in_conventions(one.published, term) for term in terms_of(one.published)
        },
        "preview": one.previews,
        "notes": one.notes,
    }
    if one.after is not None and one.regression is not None:
        plain["regression"] = {
            name: getattr(one.regression, name)
            for name in ("names", "values", "u", "units", "references")
        }
        plain["curve_after"] = one.after.curve
        plain["coefficients_after"] = one.after.rows
    if one.beside is not None:
        plain["curve_beside"] = one.beside
    return plain


def _report(one: NoiseStudy) -> list[str]:
    curve = one.coefficients.curve
    lines = [
        f"{titled(one)}: {one.path}",
        f"  {curve.n} of {one.samples} samples, {one.rate:.6g} Hz, {duration(curve.duration)}, in"
        f" {one.unit}; overlapping Allan deviation, limits of one sigma ({curve.mode})",
        "",
    ]
    lines += _indented(_curve_rows(one.published.curve, one.unit))
    if one.beside is not None:
        lines += ["", f"  {DEVIATIONS[one.beside.mode]}, limits of one sigma"]
        lines += _indented(_curve_rows(one.beside, one.unit))
    if one.regression is not None:
        lines += ["", "  Regression (value and standard uncertainty)"]
        found = one.regression
        rows = [
            (name, short(value, 4), short(u), unit)
            for name, value, u, unit in zip(
                found.names, found.values, found.u, found.units, strict=True
            )
        ]
        lines += _indented(rows)
        lines += ["", "  Before the regression"]
        lines += _indented(_method_rows(one, before=True))
        lines += ["", "  After it"]
    lines += ["", *_indented(_method_rows(one, before=False))]
    if quotes := _quote_rows(one):
        lines += ["", "  As it is quoted (likelihood, 95 % interval)", *_indented(quotes)]
    lines += _preview_lines(one)
    lines += [f"  {note.severity.value}: {note.text}" for note in one.notes]
    return [*lines, ""]


def _curve_rows(curve: AllanCurve, unit: str) -> list[tuple[str, ...]]:
    return [("tau, s", f"sigma, {unit}", "lower", "upper", "dof"), *curve_rows(curve)]


def _method_rows(one: NoiseStudy, *, before: bool) -> list[tuple[str, ...]]:
    found = one.coefficients if before else one.published
    rows: list[tuple[str, ...]] = [
        ("", "", "unit", *(method.replace("_", " ") for method in METHODS), "95 % interval")
    ]
    for term in terms_of(found):
        quotes = by_method(found, term)
        own = conventions(term, one.unit)[0]
        symbol = next(q.symbol for q in quotes if q is not None)
        cells = tuple(quoted(q) for q in quotes)
        rows.append((symbol, NAMES[term], own.unit, *cells, interval(quotes[0])))
    return rows


def _quote_rows(one: NoiseStudy) -> list[tuple[str, ...]]:
    return [
        (quote.symbol, quoted(quote), quote.unit, interval(quote), words_of(quote))
        for term in terms_of(one.published)
        for quote in in_conventions(one.published, term)
    ]


def _preview_lines(one: NoiseStudy) -> list[str]:
    if not one.previews:
        return []
    lines = ["", "  A longer record would give (relative standard uncertainty)"]
    rows: list[tuple[str, ...]] = [("length", "N", "B", "K", f"smallest B found, {one.unit}")]
    for ahead in one.previews:
        shares = (ahead.random_walk, ahead.bias_instability, ahead.rate_random_walk)
        cells = tuple(f"{share:.1%}" if share < 1.0 else "not found" for share in shares)
        rows.append((duration(ahead.duration), *cells, short(ahead.smallest_bias_instability)))
    return [*lines, *_indented(rows)]


def _comparison(studies: Sequence[NoiseStudy]) -> list[str]:
    head = ("", "unit", *(titled(one) for one in studies))
    return [
        "Comparison of the devices",
        *_indented([head, *compared_rows(studies, comparison(studies))]),
    ]


def _indented(rows: Sequence[tuple[str, ...]]) -> list[str]:
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return [
        "    " + "  ".join(f"{c:<{w}}" for c, w in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]
