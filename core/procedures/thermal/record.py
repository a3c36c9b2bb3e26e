"""The output of a standing unit while the chamber goes through its cycle.

For gyros this is the bias. For accelerometers it is the output in one orientation, where bias and
scale factor cannot be told apart: such a polynomial compensates this orientation only.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray, frozen
from core.errors import FitError, Note, Severity
from core.fit.estimate import Estimate
from core.procedures.thermal.orders import OrderScore, highest_order, lowest_orders
from core.samples.mean_error import standard_error
from core.samples.run import Run

HIGHEST = 5
_BINS = 12
_FEWEST_ROWS = 80
_FEWEST_IN_BIN = 32
_SPAN_C = 5.0


@dataclass(frozen=True, slots=True, eq=False)
class Trend:
    """One output against temperature.

    Parameters
    ----------
    channel, unit : which
    order : of the polynomial
    coefficients : of 1, t, t^2, ...; t is the temperature less `reference_c`
    reference_c : near the middle of the measured temperatures
    low_c, high_c : measured temperatures
    rms_before, rms_after : deviation of the output, of what the polynomial leaves
    explained : share of the variance, R^2
    scores : what other orders left at temperatures left out (in `bias`; `scale` is 0)
    hysteresis : output while heating less output while cooling, where they differ most; NaN if no
        temperature was passed both ways
    hysteresis_at_c : where that is
    """

    channel: str
    unit: str
    order: int
    coefficients: tuple[Estimate, ...]
    reference_c: float
    low_c: float
    high_c: float
    rms_before: float
    rms_after: float
    explained: float
    scores: tuple[OrderScore, ...]
    hysteresis: Estimate
    hysteresis_at_c: float

    def at(self, temperature_c: FloatArray, *, extrapolate: bool = False) -> FloatArray:
        """The polynomial (n,) at temperatures (n,).

        Raises
        ------
        FitError
            A temperature was not measured, and `extrapolate` does not allow it.
        """
        inside = (temperature_c >= self.low_c) & (temperature_c <= self.high_c)
        if not (extrapolate or np.all(inside)):
            raise FitError(
                f"{temperature_c[~inside][0]:.1f} degC is outside the measured {self.low_c:.1f} ..."
                f" {self.high_c:.1f} degC; polynomials mean nothing there"
            )
        t = temperature_c - self.reference_c
        powers = t[:, None] ** np.arange(self.order + 1)
        return powers @ np.array([one.value for one in self.coefficients])


@dataclass(frozen=True, slots=True, eq=False)
class RecordResult:
    """All outputs of a record against temperature.

    Parameters
    ----------
    trends : (c,) one an output
    notes : doubts
    """

    trends: tuple[Trend, ...]
    notes: tuple[Note, ...]


def fit_record(run: Run, *, order: int | None = None) -> RecordResult:
    """Fit polynomials of the temperature to the outputs of a standing unit.

    Parameters
    ----------
    run : rows in the order of time, each with its temperature
    order : of the polynomials; chosen by cross-validation over temperatures if not stated

    Raises
    ------
    FitError
        Temperatures are missing or span less than 5 degC, an output is no number, or the rows are
        too few.
    """
    x = run.temperature_c
    _check(run)
    reference = round((float(x.min()) + float(x.max())) / 2.0)
    half = float(np.abs(x - reference).max())
    bins = np.minimum((x - x.min()) / (np.ptp(x) + 1e-9) * _BINS, _BINS - 1).astype(np.int64)
    present, level = np.unique(bins, return_inverse=True)
    highest = highest_order(len(present), HIGHEST)
    if order is not None and not 0 <= order <= highest:
        raise FitError(f"order {order}; the record allows 0 to {highest}")
    powers = ((x - reference) / half)[:, None] ** np.arange(max(highest, order or 0) + 1)
    scores = _scores(powers, run.y, level)
    heating = _heating(x)
    trends: list[Trend] = []
    for c, name in enumerate(run.channels):
        chosen = order if order is not None else lowest_orders(scores[c]).bias
        trends.append(
            _trend(run, c, name, powers[:, : chosen + 1], (reference, half), scores[c], heating)
        )
    return RecordResult(tuple(trends), (*run.notes, *_notes(run, trends)))


def _check(run: Run) -> None:
    x = run.temperature_c
    if len(run) < _FEWEST_ROWS:
        raise FitError(f"{len(run)} rows; a record over temperature needs at least {_FEWEST_ROWS}")
    for values, what in ((x[:, None], "temperature"), (run.y, "output")):
        bad = np.flatnonzero(~np.isfinite(values).all(axis=1))
        if bad.size:
            raise FitError(f"row {bad[0] + 1}: the {what} is not a number")
    if np.ptp(x) < _SPAN_C:
        raise FitError(
            f"the temperature stayed between {x.min():.1f} and {x.max():.1f} degC; a dependence on"
            f" it needs a span of {_SPAN_C:g} degC or more"
        )


def _scores(
    powers: FloatArray, y: FloatArray, level: IntArray
) -> tuple[tuple[OrderScore, ...], ...]:
    """Scores (c, orders): each stretch of temperature inside the span left out in turn.

    Sums over a stretch are all that a fit without it needs, so each row is read once.
    """
    order = np.argsort(level, kind="stable")
    counts = np.bincount(level)
    cuts = np.cumsum(counts)[:-1].tolist()
    pieces = list(zip(np.split(powers[order], cuts), np.split(y[order], cuts), strict=True))
    grams = np.array([piece.T @ piece for piece, _ in pieces])
    moments = np.array([piece.T @ values for piece, values in pieces])
    squares = np.array([np.sum(values**2, axis=0) for _, values in pieces])
    folds = np.arange(1, len(pieces) - 1) if len(pieces) > 4 else np.arange(len(pieces))
    count = int(counts[folds].sum())
    rms = np.empty((powers.shape[1], y.shape[1]))
    for p in range(1, powers.shape[1] + 1):
        part = grams[:, :p, :p]
        kept = part.sum(axis=0) - part[folds]
        along = moments[:, :p].sum(axis=0) - moments[folds, :p]
        values: FloatArray = np.asarray(np.linalg.solve(kept, along), dtype=np.float64)
        left = (
            squares[folds]
            - 2.0 * np.sum(values * moments[folds, :p], axis=1)
            + np.sum(values * (part[folds] @ values), axis=1)
        )
        rms[p - 1] = np.sqrt(np.maximum(left.sum(axis=0), 0.0) / count)
    return tuple(
        tuple(OrderScore(p, 0, float(value)) for p, value in enumerate(column)) for column in rms.T
    )


def _trend(
    run: Run,
    channel: int,
    name: str,
    powers: FloatArray,
    scaling: tuple[float, float],
    scores: tuple[OrderScore, ...],
    heating: BoolArray,
) -> Trend:
    y, x = run.y[:, channel], run.temperature_c
    reference, half = scaling
    p = powers.shape[1]
    inverse_gram = np.linalg.inv(powers.T @ powers)
    values = inverse_gram @ (powers.T @ y)
    left = y - powers @ values
    # Neighbouring rows share their error, and the temperature changes slowly against the memory
    # of that: the error of a mean over all rows tells how many rows count as one.
    error, freedom = standard_error(left[:, None], [False])
    dof = float(freedom[0])
    covariance = inverse_gram * float(error[0]) ** 2 * len(y) * len(y) / (len(y) - p)
    scale = half ** -np.arange(p, dtype=np.float64)
    u = np.sqrt(np.diag(covariance)) * scale
    before, after = float(y.std()), float(np.sqrt(np.mean(left**2)))
    hysteresis, at = _hysteresis(x, left, heating, run.unit)
    units = [run.unit, f"{run.unit}/degC", *(f"{run.unit}/degC^{n}" for n in range(2, p))]
    return Trend(
        channel=name,
        unit=run.unit,
        order=p - 1,
        coefficients=tuple(
            Estimate(float(value), float(doubt), dof, unit)
            for value, doubt, unit in zip(values * scale, u, units[:p], strict=True)
        ),
        reference_c=reference,
        low_c=float(x.min()),
        high_c=float(x.max()),
        rms_before=before,
        rms_after=after,
        explained=1.0 - (after / before) ** 2 if before > 0 else float("nan"),
        scores=scores,
        hysteresis=hysteresis,
        hysteresis_at_c=at,
    )


def _heating(x: FloatArray) -> BoolArray:
    """Whether the temperature rises, over a hundredth of the record."""
    width = max(len(x) // 100, 2)
    smooth = np.convolve(np.pad(x, width, mode="edge"), np.ones(width) / width, mode="same")
    rising: BoolArray = np.gradient(smooth)[width:-width] > 0.0
    return rising


def _hysteresis(
    x: FloatArray, left: FloatArray, heating: BoolArray, unit: str
) -> tuple[Estimate, float]:
    """Largest difference between heating and cooling over stretches of temperature."""
    edges = np.linspace(float(x.min()), float(x.max()), _BINS + 1)
    bins = np.clip(np.searchsorted(edges, x, side="right") - 1, 0, _BINS - 1)
    sides = [
        (np.bincount(bins[way], minlength=_BINS), np.bincount(bins[way], left[way], _BINS))
        for way in (heating, ~heating)
    ]
    enough = (sides[0][0] >= _FEWEST_IN_BIN) & (sides[1][0] >= _FEWEST_IN_BIN)
    nothing = Estimate(float("nan"), float("nan"), 0.0, unit)
    if not enough.any():
        return nothing, float("nan")
    means = [np.where(enough, total / np.maximum(n, 1), np.nan) for n, total in sides]
    difference = means[0] - means[1]
    place = int(np.nanargmax(np.abs(difference)))
    errors = [
        standard_error(left[(bins == place) & way][:, None], [False]) for way in (heating, ~heating)
    ]
    u = float(np.hypot(errors[0][0][0], errors[1][0][0]))
    dof = float(min(errors[0][1][0], errors[1][1][0]))
    middle = float(edges[place] + edges[place + 1]) / 2.0
    return Estimate(float(difference[place]), u, dof, unit), middle


def _notes(run: Run, trends: list[Trend]) -> list[Note]:
    notes: list[Note] = []
    if run.sensor == "accelerometer":
        notes.append(
            Note(
                Severity.WARNING,
                "one_orientation",
                "the unit stood in one orientation: an axis that feels a part of g shows the change"
                " of its scale factor as one of its bias; measure positions at each temperature to"
                " tell them apart",
            )
        )
    for trend in trends:
        lag = trend.hysteresis
        if lag.value and abs(lag.value) > trend.rms_after and lag.significant:
            notes.append(
                Note(
                    Severity.WARNING,
                    "hysteresis",
                    f"{trend.channel}: at {trend.hysteresis_at_c:.0f} degC the output while heating"
                    f" is {lag.value:+.3g} {lag.unit} from that while cooling: lag, hysteresis or a"
                    " drift in time, which no polynomial of the temperature can compensate",
                )
            )
    return notes


def residuals(run: Run, result: RecordResult) -> FloatArray:
    """What the polynomials leave (n, c) of a record, extrapolating where it goes beyond them."""
    columns = [
        run.y[:, c] - trend.at(run.temperature_c, extrapolate=True)
        for c, trend in enumerate(result.trends)
    ]
    return frozen(np.column_stack(columns))
