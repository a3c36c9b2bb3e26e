"""Tell whether a mean fits the position that the operator chose, or another one.

What the sensors should give is predicted from what is known: a nominal or earlier calibration if
there is one, and the positions already accepted in this session. The knowledge is a Gaussian over
each sensor's (k_x, k_y, k_z, U0), so a prediction carries its own doubt, and where nothing is
known yet nothing is claimed. Sensor polarity is part of what is learned: a negative scale factor
is legal.
"""

from dataclasses import dataclass
from enum import Enum

import numpy as np

from core.arrays import FloatArray

_NOISE = 0.01
"""Scatter of a position about the linear model, share of full input: setting by hand, K2, ..."""
_BIAS = 0.08
_SHRUNK = (1.0, 0.1, 0.01)
"""Sensors may well feel less than the widest doubt allows. Without this, a place that is known
would beat one that is not whenever the two happen to look alike, as two horizontal positions do."""
_CROSS = 0.08
"""Cross-axis sensitivity of a sensor whose nominal axis is known: up to some 10 degrees."""
_NOMINAL_K = 0.05
_NOMINAL_BIAS = 0.05
_DRIVEN = 0.5
"""Share of full input along its axis by which a sensor shows what full output is."""
_IMPLAUSIBLE = 5.0
"""Standard deviations of the worst channel beyond which the chosen position is doubted."""
_TIED = 3.0
"""Log-likelihood within which two positions cannot be told apart."""
_CLEARLY_BETTER = 12.0
"""Log-likelihood by which another position must be better than the chosen one."""


@dataclass(frozen=True, slots=True, eq=False)
class Nominal:
    """What is known of the sensors before the first position.

    Parameters
    ----------
    k : (c, 3) output per unit of input along each case axis
    bias : (c,) output at zero input
    source : where it comes from, for the operator
    """

    k: FloatArray
    bias: FloatArray
    source: str


def _prior_sd(axis: str, nominal_known: bool) -> FloatArray:
    """Doubt (4,) about k_x, k_y, k_z and the bias of one sensor, in shares of full output."""
    if nominal_known:
        return np.array([_NOMINAL_K, _NOMINAL_K, _NOMINAL_K, _NOMINAL_BIAS])
    slopes = [1.0 if axis in ("", name) else _CROSS for name in "xyz"]
    return np.array([*slopes, _BIAS])


class Verdict(Enum):
    """What the mean says about the chosen position."""

    FITS = "fits"
    CANNOT_TELL = "cannot_tell"
    OTHER_POSITION = "other_position"
    AXIS_REVERSED = "axis_reversed"
    NO_POSITION = "no_position"


@dataclass(frozen=True, slots=True)
class Recognition:
    """The verdict with the sentence for the operator.

    Parameters
    ----------
    verdict : what the mean says
    candidates : places of the candidates that fit as well as the best, most likely first
    text : the sentence; empty where nothing needs to be said
    """

    verdict: Verdict
    candidates: tuple[int, ...]
    text: str

    @property
    def acceptable(self) -> bool:
        """Whether nothing speaks against the chosen position."""
        return self.verdict in (Verdict.FITS, Verdict.CANNOT_TELL)


class Expectation:
    """What the sensors should give in a position, learned as positions are accepted.

    Parameters
    ----------
    full_input : largest input of the test along one axis, e.g. g or the highest rate
    axes : (c,) nominal case axis of each sensor, ``"x"``, ``"y"``, ``"z"``; empty where unknown
    nominal : knowledge from before the session, None if there is none
    """

    def __init__(
        self, full_input: float, axes: tuple[str, ...], nominal: Nominal | None = None
    ) -> None:
        self._full = full_input
        self._axes = axes
        self._nominal = nominal
        self._sd = np.array([_prior_sd(axis, nominal is not None) for axis in axes])
        self._inputs: list[FloatArray] = []
        self._outputs: list[FloatArray] = []

    def learn(self, inputs: FloatArray, outputs: FloatArray) -> None:
        """Take an accepted position: true input (3,), mean outputs (c,)."""
        self._inputs.append(inputs)
        self._outputs.append(outputs)

    def predict(
        self,
        inputs: FloatArray,
        scale: FloatArray,
        flipped: int | None = None,
        shrunk: float = 1.0,
    ) -> tuple[FloatArray, FloatArray]:
        """Predicted outputs and their standard deviations.

        Parameters
        ----------
        inputs : (m, 3) candidate inputs
        scale : (c,) output at full input, for the parts that nothing is known of
        flipped : predict as if this case axis (0, 1, 2) were reversed
        shrunk : multiplies the doubt about slopes that nothing is known of

        Returns
        -------
        mean, sd : (m, c)
        """
        sign = np.ones(3)
        if flipped is not None:
            sign[flipped] = -1.0
        x = _regressors(inputs * sign / self._full)
        known = np.zeros((len(scale), 4))
        if self._nominal is not None:
            known[:, :3] = self._nominal.k * self._full / scale[:, None]
            known[:, 3] = self._nominal.bias / scale
        doubt = (self._sd * [shrunk, shrunk, shrunk, 1.0]) ** -2
        precision = np.zeros((len(scale), 4, 4))
        precision[:, range(4), range(4)] = doubt
        evidence = known * doubt
        if self._inputs:
            past = _regressors(np.array(self._inputs) / self._full)
            precision += past.T @ past / _NOISE**2
            evidence += (past.T @ (np.array(self._outputs) / scale)).T / _NOISE**2
        covariance = np.linalg.inv(precision)
        mean = x @ np.einsum("cij,cj->ci", covariance, evidence).T
        variance = np.einsum("mi,cij,mj->mc", x, covariance, x) + _NOISE**2
        return mean * scale, np.sqrt(variance) * scale

    def recognise(
        self, outputs: FloatArray, inputs: FloatArray, labels: tuple[str, ...], chosen: int
    ) -> Recognition:
        """Compare mean outputs with all positions of the plan.

        Parameters
        ----------
        outputs : (c,) mean outputs of the position just measured
        inputs : (m, 3) true inputs of the positions
        labels : (m,) how the operator calls them, e.g. ``"position 3 (180 deg)"``
        chosen : place of the position that the operator chose
        """
        alike = len(inputs) > 1 and not np.ptp(inputs, axis=0).any()
        if alike or not self._scale_shows(inputs[chosen]):
            return Recognition(Verdict.CANNOT_TELL, (), "")
        scale = self._scale(outputs)
        fit = self._score(outputs, inputs, scale)
        if fit.distance[chosen] < _IMPLAUSIBLE:
            return self._plausible(fit, labels, chosen)
        for axis, name in enumerate("XYZ"):
            if self._nominal is None or abs(inputs[chosen, axis]) < 0.5 * self._full:
                continue
            reversed_fit = self._score(outputs, inputs[[chosen]], scale, flipped=axis)
            if reversed_fit.distance[0] < _IMPLAUSIBLE:
                return Recognition(
                    Verdict.AXIS_REVERSED,
                    (chosen,),
                    f"{name} axis reversed: the signs fit {labels[chosen]} with {name} pointing"
                    " the other way; turn the unit over, or change the polarity in its profile",
                )
        best = int(np.argmax(fit.likelihood))
        same = _as_good(fit.likelihood)
        if fit.distance[best] < _IMPLAUSIBLE:
            # Early in a session the likelihoods are wide; what the outputs rule out is not named.
            same = tuple(i for i in same if fit.distance[i] < _IMPLAUSIBLE)
            return Recognition(Verdict.OTHER_POSITION, same, _looks_like(labels, same, chosen))
        return Recognition(
            Verdict.NO_POSITION,
            (),
            f"this is not {labels[chosen]} and fits no other position of the plan; the nearest is"
            f" {labels[best]}. Check how the unit is mounted and the head angle",
        )

    def _plausible(self, fit: "_Score", labels: tuple[str, ...], chosen: int) -> Recognition:
        best = int(np.argmax(fit.likelihood))
        same = _as_good(fit.likelihood)
        gain = fit.likelihood[best] - fit.likelihood[chosen]
        if chosen not in same and gain > _CLEARLY_BETTER:
            return Recognition(Verdict.OTHER_POSITION, same, _looks_like(labels, same, chosen))
        known = fit.doubt[chosen] < 0.3
        return Recognition(Verdict.FITS if known else Verdict.CANNOT_TELL, same, "")

    def _scale_shows(self, chosen: FloatArray) -> bool:
        """Whether full output is known, or shows if the chosen input (3,) is the true one.

        Sensors across the input give their bias alone, which says nothing of their scale.
        """
        if self._nominal is not None or "" in self._axes:
            return True
        looked_at = ["xyz".index(axis) for axis in self._axes]
        largest = np.abs(np.array([*self._inputs, chosen]))[:, looked_at].max()
        return bool(largest >= _DRIVEN * self._full * (1.0 - 1e-9))

    def _scale(self, outputs: FloatArray) -> FloatArray:
        """Output (c,) at full input: nominal where known, else the largest seen by any channel."""
        if self._nominal is not None:
            return np.linalg.norm(self._nominal.k, axis=1) * self._full
        seen = np.abs(np.array([*self._outputs, outputs]))
        return np.full(len(outputs), max(float(seen.max()), np.finfo(float).tiny))

    def _score(
        self,
        outputs: FloatArray,
        inputs: FloatArray,
        scale: FloatArray,
        flipped: int | None = None,
    ) -> "_Score":
        mean, sd = self.predict(inputs, scale, flipped)
        distance = np.abs((outputs - mean) / sd).max(axis=1)
        doubt = (sd / scale).mean(axis=1)
        likelihoods: list[FloatArray] = []
        for shrunk in _SHRUNK if self._nominal is None else (1.0,):
            mean, sd = self.predict(inputs, scale, flipped, shrunk)
            z = (outputs - mean) / sd
            likelihoods.append(-0.5 * np.sum(z**2, axis=1) - np.sum(np.log(sd), axis=1))
        return _Score(distance, np.max(likelihoods, axis=0), doubt)


@dataclass(frozen=True, slots=True, eq=False)
class _Score:
    distance: FloatArray
    likelihood: FloatArray
    doubt: FloatArray


def _regressors(inputs: FloatArray) -> FloatArray:
    return np.column_stack([inputs, np.ones(len(inputs))])


def _as_good(likelihood: FloatArray) -> tuple[int, ...]:
    """All positions that these outputs cannot tell from the best, most likely first."""
    order = np.argsort(-likelihood, kind="stable")
    return tuple(int(i) for i in order if likelihood[i] > likelihood[order[0]] - _TIED)


def _looks_like(labels: tuple[str, ...], same: tuple[int, ...], chosen: int) -> str:
    names = " or ".join(labels[i] for i in same)
    return f"this looks like {names}, not {labels[chosen]}"
