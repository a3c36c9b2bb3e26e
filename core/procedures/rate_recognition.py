"""Tell on the rate table whether the outputs stand for the rate that was to be set, and if not why.

The same knowledge as on the head (`recognise`), with the stories of a table: it stands, it turns
the wrong way, it stopped in the middle of an accumulation.
"""

from dataclasses import replace

import numpy as np

from core.arrays import FloatArray
from core.procedures.rate_faults import story
from core.procedures.recognise import Expectation, Nominal, Recognition

_SMALL = 0.02
_STEP = 1e-3
"""The rate that outputs stand for is told in steps of this share of the largest."""
_BIAS = 0.4
"""Doubt about zeros that nothing is known of, in shares of full output: gyros have large ones for
a small range of rates."""
_TELLING = 0.1
"""Share of the largest rate by which the rates learned so far must differ to tell a slope."""


class RateExpectation(Expectation):
    """What gyros should give at a set rate, learned as rates are accepted.

    Parameters
    ----------
    full_rate_dps : largest rate of the test, deg/s
    axes : (c,) nominal case axis of each sensor; empty where unknown
    nominal : knowledge from before the session, None if there is none
    """

    def __init__(
        self, full_rate_dps: float, axes: tuple[str, ...], nominal: Nominal | None = None
    ) -> None:
        super().__init__(full_rate_dps, axes, nominal)
        if nominal is None:
            self._sd[:, 3] = _BIAS
        self._full_rate = full_rate_dps
        self._learned: list[tuple[FloatArray, FloatArray]] = []
        self._nominal_k = nominal

    def learn(self, inputs: FloatArray, outputs: FloatArray) -> None:
        """Take an accepted rate: true input (3,), mean outputs (c,)."""
        super().learn(inputs, outputs)
        self._learned.append((inputs, outputs))

    def recognise(
        self, outputs: FloatArray, inputs: FloatArray, labels: tuple[str, ...], chosen: int
    ) -> Recognition:
        """Compare mean outputs with all rates of the plan; see `Expectation.recognise`."""
        found = super().recognise(outputs, inputs, labels, chosen)
        if found.acceptable:
            return found
        implied = self._implied(outputs, inputs[chosen])
        if implied is None:
            return found
        set_rate, rate = implied
        step = _STEP * self._full_rate
        shown = round(rate / step) * step
        text = (
            f"this is not {labels[chosen]}: the outputs stand for {shown:+.4g} deg/s;"
            f" {story(set_rate, rate, _SMALL * self._full_rate)}"
        )
        return replace(found, text=text)

    def _implied(self, outputs: FloatArray, chosen: FloatArray) -> tuple[float, float] | None:
        """Set rate and rate that the outputs stand for, about the axis that is to turn.

        None where too little is known of the sensors to tell.
        """
        axis = self._turned(chosen)
        known = self._line(axis)
        if known is None:
            return None
        zero, k = known
        size = float(k @ k)
        return float(chosen[axis]), float(k @ (outputs - zero)) / size if size > 0 else 0.0

    def _turned(self, chosen: FloatArray) -> int:
        """Case axis of the turn; of a standing table the one that turned last."""
        if np.any(chosen):
            return int(np.argmax(np.abs(chosen)))
        turned = [inputs for inputs, _ in self._learned if np.any(inputs)]
        return int(np.argmax(np.abs(turned[-1]))) if turned else 2

    def _line(self, axis: int) -> tuple[FloatArray, FloatArray] | None:
        """Zero (c,) and slope (c,) about an axis, from what was accepted or from before."""
        rows = [
            (float(inputs[axis]), outputs)
            for inputs, outputs in self._learned
            if not np.any(np.delete(inputs, axis))
        ]
        rates = np.array([rate for rate, _ in rows])
        if len(rows) >= 2 and np.ptp(rates) > _TELLING * self._full_rate:
            means = np.array([outputs for _, outputs in rows])
            centred = rates - rates.mean()
            k = centred @ means / float(centred @ centred)
            return means.mean(axis=0) - k * rates.mean(), k
        if self._nominal_k is None:
            return None
        return self._nominal_k.bias, self._nominal_k.k[:, axis]
