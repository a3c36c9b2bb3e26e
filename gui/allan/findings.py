"""Results -> tables and sentences of the right-hand side."""

from collections.abc import Sequence

from core.allan.coefficients import NoiseCoefficients
from core.allan.conventions import conventions
from core.allan.curve import AllanCurve
from core.errors import Note, Severity
from core.records.noise_study import NoiseStudy
from core.records.noise_tables import METHODS, by_method, comparison, in_conventions, terms_of
from gui.allan.live import LiveRecord
from gui.allan.texts import (
    DEVIATIONS,
    brief_of,
    compared_rows,
    curve_rows,
    duration,
    interval,
    plain_unit,
    quoted,
    short,
    titled,
)
from gui.widgets.number_text import grouped
from gui.widgets.states import FindingsState, TableState

LAW = "σ²(τ) = R²τ²/2 + K²τ/3 + B²·(2/π) ln 2 + N²/τ + 3Q²/τ²   (6.4)"
_METHODS = ("Whittle", "least squares", "graphical")


def of_study(study: NoiseStudy, shown: Sequence[NoiseStudy]) -> FindingsState:
    """Return what was found in one record, and the comparison with the others that are shown."""
    curve = study.coefficients.curve
    source = (
        f"{grouped(curve.n)} samples at {study.rate:.6g} Hz, {duration(curve.duration)}, in "
        f"{plain_unit(study.unit)}"
    )
    tables: list[TableState] = []
    published = study.published
    if study.regression is not None:
        tables.append(_before_and_after(study))
        tables.append(_regression(study))
    if published.band > 0.0:
        tables.append(_quotes(published))
    tables.append(_methods(published))
    if study.beside is not None:
        tables.append(_beside(study.beside, study.unit))
    if study.previews:
        tables.append(_previews(study))
    if len(shown) > 1:
        tables.append(comparison_table(shown))
    return FindingsState(titled(study), source, tuple(tables), study.notes)


def of_error(name: str, error: str) -> FindingsState:
    """Return why a record cannot be used."""
    return FindingsState(name, "cannot be used", (), (Note(Severity.ERROR, "record", error),))


def of_live(live: LiveRecord) -> FindingsState | None:
    """Return what the live curve shows so far."""
    found = live.found
    if found is None:
        return None
    source = (
        f"{grouped(found.curve.n)} samples at {live.rate:.6g} Hz, {duration(found.curve.duration)}"
    )
    tables = (_methods(found),) if found.rows else ()
    return FindingsState(f"{live.device} {live.channel.name}, live", source, tables, found.notes)


def comparison_table(studies: Sequence[NoiseStudy]) -> TableState:
    """Return the comparison of devices of lab 6."""
    rows = compared_rows(studies, comparison(studies))
    return TableState(
        "Comparison of the devices (lab 6)",
        "",
        ("", "unit", *(titled(one) for one in studies)),
        tuple((row[0], plain_unit(row[1]), *row[2:]) for row in rows),
        words=2 + len(studies),
    )


def _quotes(found: NoiseCoefficients) -> TableState:
    rows = [
        (brief_of(q), quoted(q), plain_unit(q.unit), interval(q))
        for term in terms_of(found)
        for q in in_conventions(found, term)
    ]
    return TableState(
        "Noise coefficients, 95 %",
        LAW,
        ("", "value", "unit", "from … to"),
        tuple(rows),
        # Each row has a unit of its own: there is nothing to align, and room is scarce.
        words=4,
    )


def _methods(found: NoiseCoefficients) -> TableState:
    rows: list[tuple[str, ...]] = []
    for term in terms_of(found):
        quotes = by_method(found, term)
        symbol = next(q.symbol for q in quotes if q is not None)
        unit = plain_unit(conventions(term, found.unit)[0].unit)
        rows.append((symbol, *(quoted(q) for q in quotes), unit))
    text = (
        "Whittle: likelihood of the spectrum, published. Least squares of σ²(τ): independent "
        "opinion. Graphical: the practicum's reading; it always finds a B."
    )
    return TableState("By method", text, ("", *_METHODS[: len(METHODS)], "unit"), tuple(rows))


def _beside(curve: AllanCurve, unit: str) -> TableState:
    return TableState(
        DEVIATIONS[curve.mode],
        "Limits of one sigma; no terms are fitted to it.",
        ("τ, s", f"σ, {plain_unit(unit)}", "from", "to", "dof"),
        tuple(curve_rows(curve)),
        words=0,
    )


def _before_and_after(study: NoiseStudy) -> TableState:
    rows: list[tuple[str, ...]] = []
    for term in terms_of(study.published):
        before, after = (by_method(x, term)[0] for x in (study.coefficients, study.published))
        symbol = next((q.symbol for q in (before, after) if q is not None), term)
        unit = plain_unit(conventions(term, study.unit)[0].unit)
        rows.append((symbol, quoted(before), quoted(after), unit))
    return TableState(
        "Before and after the regression", "", ("", "before", "after", "unit"), tuple(rows)
    )


def _regression(study: NoiseStudy) -> TableState:
    found = study.regression
    if found is None:
        raise ValueError("there is no regression")
    rows = tuple(
        (name, short(value, 4), short(u), plain_unit(unit))
        for name, value, u, unit in zip(
            found.names, found.values.tolist(), found.u.tolist(), found.units, strict=True
        )
    )
    means = ", ".join(f"{value:.6g}" for value in found.references)
    text = f"Weighted with the noise that is left; powers of the channel less its mean ({means})."
    return TableState("Regression", text, ("", "coefficient", "u (k = 1)", "unit"), rows)


def _previews(study: NoiseStudy) -> TableState:
    rows = tuple(
        (
            duration(one.duration),
            *(
                f"{100.0 * share:.2g} %" if share < 0.6 else "not found"
                for share in (one.random_walk, one.bias_instability, one.rate_random_walk)
            ),
            short(one.smallest_bias_instability),
        )
        for one in study.previews
    )
    return TableState(
        "What a longer record would give",
        "Relative standard uncertainties; the smallest B is found four times in five.",
        ("length", "N", "B", "K", f"smallest B, {plain_unit(study.unit)}"),
        rows,
    )
