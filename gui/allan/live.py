"""The Allan curve of the running device: it grows about once a second, at a cost that does not."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from core.allan.coefficients import NoiseCoefficients, NoiseRow
from core.allan.curve import AllanCurve
from core.allan.graphical import read_curve
from core.allan.leastsquares import fit_variance
from core.allan.model import RANDOM, NoiseModel
from core.allan.rows import graphical_rows, variance_rows
from core.allan.streaming import LiveAllan
from core.errors import FitError, LabError
from core.records.noise_study import StudyRequest
from core.records.series import Series
from core.samples.block import Channel, SampleBlock
from gui.devices.connection import Connection
from gui.jobs import Jobs

PERIOD_MS = 1000
_TERMS = (*RANDOM, "rate_ramp")
_FEWEST = 1000
"""Samples from which terms are fitted to the curve."""


class LiveRecord(QObject):
    """Follows one channel of the current device.

    Parameters
    ----------
    connection : whose samples are taken
    jobs : where the terms are fitted; the curve itself takes some milliseconds
    """

    changed = Signal()

    def __init__(self, connection: Connection, jobs: Jobs, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._connection = connection
        self._jobs = jobs
        self._allan: LiveAllan | None = None
        self._place = 0
        self.factor = 1.0
        self._next = -1
        self._fitting = False
        self._seen = -1
        self.running = False
        self.request = StudyRequest()
        self.device = ""
        self.channels: tuple[Channel, ...] = ()
        self.channel = Channel("")
        self.unit = "code"
        self.rate = 0.0
        self.found: NoiseCoefficients | None = None
        """Curve, fitted terms; None until the record is long enough."""
        self.why = ""
        """Why there is no curve yet."""
        self.raw_path: Path | None = None
        """File of the bytes of this device."""
        self._timer = QTimer(self)
        self._timer.setInterval(PERIOD_MS)
        self._timer.timeout.connect(self.update)
        connection.blocks.connect(self._on_block)
        connection.changed.connect(self.stop)

    @property
    def count(self) -> int:
        """Samples so far."""
        return 0 if self._allan is None else self._allan.count

    @property
    def exists(self) -> bool:
        """Whether there is anything to show."""
        return self.running or self.found is not None

    def start(self) -> None:
        """Begin a new curve with the samples to come."""
        link = self._connection.link
        if link is None:
            return
        self.device, self.raw_path = link.setup.name, link.raw_path
        self._allan, self.found, self._next, self._seen = None, None, -1, -1
        self.rate = 0.0
        self.why = "waiting for samples"
        self.running = True
        self._timer.start()
        self.changed.emit()

    def stop(self) -> None:
        """End the curve; what there is stays to be looked at."""
        if self.running:
            self.running = False
            self._timer.stop()
            self.update()
            self.changed.emit()

    def clear(self) -> None:
        """Forget the curve."""
        self.stop()
        self._allan, self.found, self.channels = None, None, ()
        self.changed.emit()

    def decide(self, request: StudyRequest) -> None:
        """Take another channel or scale: the curve begins anew."""
        if request != self.request:
            self.request = request
            if self.running:
                self.start()
            else:
                self.changed.emit()

    def update(self) -> None:
        """Draw the curve as it is now; the timer calls it."""
        if self._allan is None or self._allan.count == self._seen:
            return
        self._seen = self._allan.count
        try:
            curve = self._allan.curve()
        except FitError as error:
            self.why = str(error)
            self.changed.emit()
            return
        before = self.found
        rows = () if before is None else before.rows
        model = NoiseModel() if before is None else before.model
        self._show(curve, rows, model)
        if not self._fitting and curve.n >= _FEWEST:
            self._fitting = True
            source, unit = self._allan, self.unit
            self._jobs.start(
                "live noise", lambda: _fit(source, curve, unit), self._on_fit, self._on_no_fit
            )

    def _show(self, curve: AllanCurve, rows: tuple[NoiseRow, ...], model: NoiseModel) -> None:
        self.found = NoiseCoefficients(rows, model, curve, 0.0, 0.0, self.unit, curve.notes)
        self.why = ""
        self.changed.emit()

    def _on_fit(self, result: object) -> None:
        self._fitting = False
        if not isinstance(result, _Fitted):
            raise TypeError(f"the fit brought {type(result).__name__}")
        # The curve may have grown meanwhile, or have begun anew: of that the fit knows nothing.
        if result.source is self._allan and self.found is not None:
            self._show(self.found.curve, result.rows, result.model)

    def _on_no_fit(self, error: LabError) -> None:
        self._fitting = False
        self.why = str(error)

    def _on_block(self, block: SampleBlock) -> None:
        link = self._connection.link
        if not self.running or link is None or not len(block.index):
            return
        if self._allan is None:
            rate = block.rate or link.rate_hz
            if rate <= 0.0:
                self.why = "the sample rate is being measured"
                return
            self._begin(block, rate)
        elif block.channels != self.channels:
            self.start()
            return
        self._feed(block.index, block.data[:, self._place])

    def _begin(self, block: SampleBlock, rate: float) -> None:
        empty = tuple(np.empty(0) for _ in block.channels)
        series = Series("", self.device, block.channels, empty, 0, rate=rate)
        names = [channel.name for channel in block.channels]
        wanted = self.request.channel
        self._place = names.index(wanted) if wanted in names else series.main
        taken = series.sampled(self._place, rate, self.request.scale_factor)
        self.channels, self.channel = block.channels, block.channels[self._place]
        self.unit = self.request.unit or taken.unit or "code"
        self.factor, self.rate = taken.scale_factor, rate
        self._allan = LiveAllan(rate)
        self.changed.emit()

    def _feed(self, index: np.ndarray, values: np.ndarray) -> None:
        if self._allan is None:
            return
        cuts = (np.flatnonzero(np.diff(index) != 1) + 1).tolist()
        if self._next >= 0 and int(index[0]) != self._next:
            self._allan.cut()
        for start, stop in zip([0, *cuts], [*cuts, len(index)], strict=True):
            if start:
                self._allan.cut()
            self._allan.push(values[start:stop] / self.factor)
        self._next = int(index[-1]) + 1


@dataclass(frozen=True, slots=True, eq=False)
class _Fitted:
    """Terms of a curve; `source` is the accumulator that it was taken from."""

    source: LiveAllan
    rows: tuple[NoiseRow, ...]
    model: NoiseModel


def _fit(source: LiveAllan, curve: AllanCurve, unit: str) -> _Fitted:
    """Fit the terms to a curve; runs in a worker thread and leaves the accumulator alone."""
    fit = fit_variance(curve, _TERMS)
    rows = variance_rows(fit, unit)
    detected = [row.term for row in rows if not row.upper_limit]
    model = NoiseModel(**{term: fit.model.coefficient(term) for term in detected})
    rows += graphical_rows(read_curve(curve, _TERMS), unit)
    return _Fitted(source, tuple(rows), model)
