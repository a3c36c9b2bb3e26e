"""One record analysed: what is needed to show, compare and export its noise."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from core.allan.coefficients import NoiseCoefficients
from core.allan.curve import AllanCurve
from core.allan.detrend import Detrended, Regressor, detrend
from core.allan.deviation import overlapping
from core.allan.graphical import read_curve
from core.allan.model import NoiseModel
from core.allan.noise import fit_noise
from core.allan.other import other_deviation
from core.allan.preview import Preview, preview
from core.allan.rows import graphical_rows
from core.arrays import FloatArray
from core.errors import FitError, Note, Severity
from core.records.series import Sampled, Series


@dataclass(frozen=True, slots=True)
class StudyRequest:
    """What the operator decides about a record.

    Parameters
    ----------
    channel : name of the channel; empty for the one that is likely meant
    rate : samples per second; 0 to take it from the file
    unit : of the samples after the division by `scale_factor`; empty for the file's own
    scale_factor : output for 1 deg/s (1 m/s^2); 0 for the one that the file states, if any
    increments : the device sends increments of angle or velocity, so quantisation is fitted too
    bandwidth : of the sensor, Hz; 0 to find it from the record
    regressors : names of the channels on which the record is regressed first
    order : highest power of them
    beside : another deviation to show beside Allan's, key of `core.allan.other.KINDS`; empty: none
    """

    channel: str = ""
    rate: float = 0.0
    unit: str = ""
    scale_factor: float = 0.0
    increments: bool = False
    bandwidth: float = 0.0
    regressors: tuple[str, ...] = ()
    order: int = 1
    beside: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class NoiseStudy:
    """What was found in one channel of a record.

    Parameters
    ----------
    device, path : whose record it is
    channel, unit : what was analysed, after the scale factor
    rate : samples per second
    scale_factor : by which the samples were divided
    samples : in the file; `coefficients.curve.n` of them were analysed
    coefficients : curve, table, model; of the record as it is
    regression : the regression on other channels, None where none was asked for
    after : coefficients of what the regression left; None without one
    previews : of longer records, empty where the model has no random walk
    notes : doubts about the file, the record and the fit, each once
    beside : another deviation of what was published; None where none was asked for or it failed
    """

    device: str
    path: str
    channel: str
    unit: str
    rate: float
    scale_factor: float
    samples: int
    coefficients: NoiseCoefficients
    regression: Detrended | None
    after: NoiseCoefficients | None
    previews: tuple[Preview, ...]
    notes: tuple[Note, ...]
    beside: AllanCurve | None = None

    @property
    def published(self) -> NoiseCoefficients:
        """Coefficients after the regression where there was one."""
        return self.coefficients if self.after is None else self.after


def study(series: Series, request: StudyRequest) -> NoiseStudy:
    """Analyse one channel of a record.

    Raises
    ------
    FormatError
        There is no such channel.
    FitError
        The record cannot be analysed: too short, stuck, not uniform, rate unknown.
    """
    place = series.place(request.channel) if request.channel else series.main
    taken = series.sampled(place, request.rate, request.scale_factor)
    unit = request.unit or taken.unit or "code"
    regressors = _regressors(series, request.regressors, place)
    found = _fit(taken.values, taken, unit, request)
    regression: Detrended | None = None
    after: NoiseCoefficients | None = None
    notes = [*series.notes, *found.notes]
    if regressors:
        regression = detrend(
            taken.values,
            taken.rate,
            regressors,
            order=request.order,
            unit=unit,
            index=taken.index,
        )
        after = _fit(regression.residual, replace(taken, index=None), unit, request)
        notes += [*regression.notes, *after.notes]
    published = found if after is None else after
    beside: AllanCurve | None = None
    if request.beside:
        left = taken.values if regression is None else regression.residual
        index = taken.index if regression is None else None
        try:
            beside = other_deviation(left, taken.rate, request.beside, index=index)
        except FitError as error:
            notes.append(Note(Severity.WARNING, "beside", str(error)))
    return NoiseStudy(
        device=series.device,
        path=series.path,
        channel=taken.name,
        unit=unit,
        rate=taken.rate,
        scale_factor=taken.scale_factor,
        samples=series.n,
        coefficients=found,
        regression=regression,
        after=after,
        previews=_previews(published, taken.rate),
        notes=tuple({note.text: note for note in notes}.values()),
        beside=beside,
    )


def _fit(values: FloatArray, taken: Sampled, unit: str, request: StudyRequest) -> NoiseCoefficients:
    """Fit the noise; where no noise model holds, the curve and its graphical reading are left."""
    try:
        return fit_noise(
            values,
            taken.rate,
            unit=unit,
            output="increment" if request.increments else "rate",
            bandwidth=request.bandwidth or None,
            index=taken.index,
        )
    except FitError as error:
        # What is wrong with the record itself is raised here again.
        curve = overlapping(values, taken.rate, gaps="longest", index=taken.index)
        rows = graphical_rows(read_curve(curve), unit)
        notes = (Note(Severity.ERROR, "no_fit", f"only the curve is given: {error}"), *curve.notes)
        return NoiseCoefficients(tuple(rows), NoiseModel(), curve, 0.0, 0.0, unit, notes)


def _regressors(series: Series, names: Sequence[str], place: int) -> list[Regressor]:
    regressors: list[Regressor] = []
    for name in names:
        where = series.place(name)
        if where == place:
            raise FitError(f"{series.channels[where].name} cannot be regressed on itself")
        channel = series.channels[where]
        regressors.append(Regressor(channel.name, channel.unit, series.columns[where]))
    return regressors


def _previews(found: NoiseCoefficients, rate: float) -> tuple[Preview, ...]:
    try:
        return preview(found.model, rate, found.curve.duration, band=found.band)
    except FitError:
        return ()
