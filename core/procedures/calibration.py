"""What a procedure hands to exports, reports and other procedures."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError, Note
from core.fit.result import FitResult
from core.model.effect import AXES
from core.procedures.added import AddedEffect
from core.procedures.triad import Triad, triad_of
from core.samples.run import Conditions


@dataclass(frozen=True, slots=True)
class Provenance:
    """Where a result comes from.

    Parameters
    ----------
    procedure : name of the procedure and its source
    device : name or serial number
    profile, plan : identifiers, empty where there were none
    records : (name, SHA-256) of every file that went in
    software : name and version of the program
    measured_utc, computed_utc : ISO 8601 times; empty where unknown
    """

    procedure: str
    device: str
    profile: str = ""
    plan: str = ""
    records: tuple[tuple[str, str], ...] = ()
    software: str = ""
    measured_utc: str = ""
    computed_utc: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class Calibration:
    """Parameters of all sensors of a unit, from one test.

    Parameters
    ----------
    sensor : ``"accelerometer"`` or ``"gyro"``
    unit : unit of the outputs
    channels, axes : (c,) names and nominal case axes of the sensors
    fits : (c,) one fit a sensor
    conditions : g and what else the laboratory states
    temperature_c : mean temperature; NaN if it was not measured in degrees
    notes : doubts about the unit as a whole; each fit has its own besides
    provenance : where it comes from
    effects : (c,) of each sensor what was added to its plain model; empty where nothing was
    """

    sensor: str
    unit: str
    channels: tuple[str, ...]
    axes: tuple[str, ...]
    fits: tuple[FitResult, ...]
    conditions: Conditions
    temperature_c: float
    notes: tuple[Note, ...]
    provenance: Provenance
    effects: tuple[tuple[AddedEffect, ...], ...] = ()

    @property
    def is_triad(self) -> bool:
        """Whether the sensors are three, one along each axis, with all responses known."""
        responses = [
            sum(name == "scale_factor" or name.startswith("cross_axis") for name in fit.names)
            for fit in self.fits
        ]
        return sorted(self.axes) == list(AXES) and responses == [len(AXES)] * len(AXES)

    def added_to(self, channel: int) -> tuple[AddedEffect, ...]:
        """What was added to the plain model of one sensor."""
        return self.effects[channel] if self.effects else ()

    def triad(self) -> Triad:
        """The sensors as one.

        Raises
        ------
        FitError
            They are no triad, or the test did not determine all responses.
        """
        if not self.is_triad:
            raise FitError("Q needs three sensors with bias, scale factor and both cross axes each")
        return triad_of(self.axes, self.fits)

    def bias_in_input(self, channel: int) -> tuple[float, float]:
        """Bias over scale factor and its standard uncertainty: K0 of IEEE 1293, input units."""
        fit = self.fits[channel]
        bias, k = fit.index("bias"), fit.index("scale_factor")
        value = fit.values[bias] / fit.values[k]
        slope = np.zeros(len(fit.values))
        slope[bias], slope[k] = 1.0 / fit.values[k], -value / fit.values[k]
        return float(value), float(np.sqrt(slope @ fit.covariance @ slope))

    def misalignment(self, channel: int) -> tuple[FloatArray, FloatArray]:
        """Cross-axis sensitivities over the scale factor, rad, and their uncertainties."""
        fit = self.fits[channel]
        k = fit.index("scale_factor")
        cross = [i for i, name in enumerate(fit.names) if name.startswith("cross_axis")]
        ratio = fit.values[cross] / fit.values[k]
        slope = np.zeros((len(cross), len(fit.values)))
        slope[range(len(cross)), cross] = 1.0 / fit.values[k]
        slope[:, k] = -ratio / fit.values[k]
        return ratio, np.sqrt(np.einsum("ci,ij,cj->c", slope, fit.covariance, slope))
