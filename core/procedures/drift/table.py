"""The correction against time and chip temperature."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError
from core.procedures.drift.curves import Alignment
from core.procedures.drift.hats import hat_basis

BYTES_PER_NUMBER = 2


def knots_within(memory: int, temperatures: int) -> int:
    """How many knots (tp) fit into so many bytes with this number of temperatures; maybe none."""
    return max(0, (memory // BYTES_PER_NUMBER - temperatures) // (temperatures + 1))


_MARGIN_C = 1.0
"""Starts scatter by some tenths of a degree about the temperature of their set."""


@dataclass(frozen=True, slots=True, eq=False)
class DriftTable:
    """What is to be subtracted from the aligned output.

    Parameters
    ----------
    unit : of `values`
    times_s : (p,) knots, time since switching on; the same for all temperatures
    temperatures_c : (m,) chip temperatures at the start, ascending
    values : (m, p) correction; linear in time and in temperature between the knots
    u : (m, p) standard uncertainty of a value, from the scatter of the turn-ons; NaN for one
    dof : (m,) its degrees of freedom
    alignment : the mean over this time was subtracted, and must be in use
    """

    unit: str
    times_s: FloatArray
    temperatures_c: FloatArray
    values: FloatArray
    u: FloatArray
    dof: FloatArray
    alignment: Alignment

    @property
    def bytes(self) -> int:
        """Memory for times, temperatures and values as 16-bit integers."""
        return BYTES_PER_NUMBER * (len(self.times_s) + len(self.temperatures_c) + self.values.size)

    def correction(
        self, t_s: FloatArray, temperature_c: float, *, extrapolate: bool = False
    ) -> FloatArray:
        """What to subtract (n,) at times (n,) after a start at one chip temperature.

        Parameters
        ----------
        t_s : time since switching on
        temperature_c : chip temperature at the start
        extrapolate : hold the outermost values beyond the measured times and temperatures, as the
            microcontroller does, rather than refuse

        Raises
        ------
        FitError
            A time or the temperature is beyond what was measured.

        Notes
        -----
        Values are interpolated, never knots or slopes by their index: that was worse than no
        correction wherever bends move with temperature.
        """
        if not extrapolate:
            self._refuse_beyond(t_s, temperature_c)
        at = np.array([temperature_c])
        if len(self.temperatures_c) == 1:
            along = self.values[0]
        else:
            along = (hat_basis(at, self.temperatures_c) @ self.values)[0]
        return hat_basis(t_s, self.times_s) @ along

    def _refuse_beyond(self, t_s: FloatArray, temperature_c: float) -> None:
        low, high = float(self.temperatures_c[0]), float(self.temperatures_c[-1])
        if not low - _MARGIN_C <= temperature_c <= high + _MARGIN_C:
            raise FitError(
                f"{temperature_c:.1f} degC is outside the measured {low:.1f} ... {high:.1f} degC;"
                " the drift there is not known"
            )
        start, stop = float(self.times_s[0]), float(self.times_s[-1])
        if t_s.size and not (t_s.min() >= start and t_s.max() <= stop):
            raise FitError(
                f"times {t_s.min():g} ... {t_s.max():g} s leave the measured {start:g} ..."
                f" {stop:g} s; the drift there is not known"
            )
