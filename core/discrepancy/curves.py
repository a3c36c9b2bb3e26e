"""Unknown smooth structure in one regressor: what competes with the names, and shows where."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.components import cells, times
from core.discrepancy.evidence import curve_evidence
from core.discrepancy.problem import Problem
from core.discrepancy.space import Space
from core.units import RAD_PER_DEG

_HARMONICS = 8
_POWERS = 7
_WAVES = 8
_GROUPS = ("mount", "run")
_NAMED = (*_GROUPS, "direction")
_LOCAL_DEG, _LOCAL = 20.0, 0.12
_DUST, _DUST_OF_MOST = 1e-3, 1e-5
_SHARES = (0.05, 0.15, 0.5)
"""Time constants of what dies away, in parts of the longest time since a mounting."""
_ROWS = (4.0, 10.0, 25.0)
"""Time constants of what follows late, in rows."""


@dataclass(frozen=True, slots=True, eq=False)
class Regressor:
    """Against what residuals are looked at.

    Parameters
    ----------
    name, unit : of the regressor
    x : (n c,) its value in each stacked row
    basis : (n c, q) unknown curve of unit amplitude, in units of the noise
    competes : it stands for structure that no name describes; offsets of runs and mountings and
        the two directions are names themselves
    width : columns of each feature of which one alone acts; 0 where all act together
    """

    name: str
    unit: str
    x: FloatArray
    basis: FloatArray
    competes: bool
    width: int = 0


def regressors_of(problem: Problem, sigma: FloatArray) -> tuple[Regressor, ...]:
    """All regressors that change in a run.

    Parameters
    ----------
    sigma : (n c,) standard deviation of the noise of each row
    """
    channels = np.eye(problem.channels)
    return tuple(
        Regressor(
            name,
            unit,
            np.tile(x, problem.channels),
            np.kron(channels, basis) * sigma[:, None],
            name not in _NAMED,
        )
        for name, unit, x, basis in (*_settings(problem), *_circumstances(problem))
        if np.ptp(x) > 0.0 and basis.shape[1]
    )


_Described = tuple[str, str, FloatArray, FloatArray]


def _settings(problem: Problem) -> list[_Described]:
    """What was set, row by row of one channel."""
    run, a = problem.run, problem.stimulus.a
    if run.test == "rate_table":
        rate = run.set_rate_dps
        return [
            ("set_rate_dps", "deg/s", rate, powers(rate)),
            ("set_rate_dps", "deg/s", rate, bumps(rate)),
        ]
    head = np.mod(run.head_deg, 360.0)
    size = float(np.max(np.abs(a)))
    changing = [i for i in range(3) if np.ptp(a[:, i]) > 1e-6 * size]
    return [
        ("head_deg", "deg", head, _harmonics(head)),
        ("head_deg", "deg", head, _bumps_around(head)),
        *((f"a_{'xyz'[i]}", "m/s^2", a[:, i], powers(a[:, i])) for i in changing),
    ]


def _circumstances(problem: Problem) -> list[_Described]:
    """What else was different from row to row."""
    run, stimulus, n = problem.run, problem.stimulus, problem.rows
    found: list[_Described] = []
    cell = cells(problem)[:n].astype(np.float64)
    if len(np.unique(cell)) <= 0.7 * n:
        found.append(("position", "", cell, _groups(cell)))
    timed = bool(np.all(np.isfinite(run.t_s)))
    order = np.arange(n, dtype=np.float64)
    name, unit, t = ("t_s", "s", run.t_s) if timed else ("order", "", order)
    found.append((name, unit, t, waves(times(problem))))
    since = _since_mounting(problem)
    found.append(("since_mounting", unit, since, _decays(since)))
    found.append(("previous", *_followed(problem)))
    temperature = stimulus.columns.get("temperature_c", np.full(n, np.nan))
    if np.all(np.isfinite(temperature)):
        found.append(("temperature_c", "degC", temperature, powers(temperature, 4)))
    found += [(key, "", stimulus.column(key), _groups(stimulus.column(key))) for key in _GROUPS]
    place = run.set_rate_dps if run.test == "rate_table" else run.head_deg
    step = np.sign(np.diff(place, prepend=place[:1]))
    found.append(("direction", "", step, _groups(step)))
    return found


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """A regressor's curves in a whitened space.

    Parameters
    ----------
    regressor : which
    left : (n, r) principal directions
    sizes : (r,) how strongly a curve of unit amplitude excites each
    """

    regressor: Regressor
    left: FloatArray
    sizes: FloatArray

    @classmethod
    def of(cls, regressor: Regressor, space: Space) -> "Curve":
        """Project the curves of a regressor."""
        rest = space.rest(regressor.basis)
        sizes, turn = _principal(rest.T @ rest)
        return cls(regressor, rest @ turn / sizes, sizes)

    def evidence(self, residual: FloatArray, space: Space) -> FloatArray:
        """Evidence of structure in residuals (n,) or (n, k)."""
        rss = np.sum(residual**2, axis=0)
        if not len(self.sizes):
            return np.zeros(residual.shape[1:])
        return curve_evidence(self.left.T @ residual, self.sizes, rss, space.prior, space.dof)

    def beside(self, residual: FloatArray, added: FloatArray, space: Space) -> float:
        """Evidence of structure in a residual (n,), given `added` (n, s), orthonormal."""
        shadow = added.T @ self.left
        inner = (np.eye(len(self.sizes)) - shadow.T @ shadow) * np.outer(self.sizes, self.sizes)
        sizes, turn = _principal(inner)
        if not len(sizes):
            return 0.0
        along = turn.T @ (self.sizes * (self.left.T @ residual)) / sizes
        rss = float(residual @ residual)
        return float(curve_evidence(along, sizes, rss, space.prior, space.dof))

    def fitted(self, residual: FloatArray) -> FloatArray:
        """Whitened curve (n,) that the likeliest amplitude makes of a residual."""
        e = (self._amplitude(residual) * self.sizes) ** 2
        return self.left @ (e / (1.0 + e) * (self.left.T @ residual))

    def _amplitude(self, residual: FloatArray) -> float:
        """Amplitude that explains the residual best."""
        c = self.left.T @ residual
        best, found = -np.inf, 0.5
        for amplitude in np.geomspace(0.1, 64.0, 14):
            e = (amplitude * self.sizes) ** 2
            value = float(np.sum(-0.5 * np.log1p(e) + 0.5 * c**2 * e / (1.0 + e)))
            if value > best:
                best, found = value, float(amplitude)
        return found


def _principal(inner: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Sizes (r,) and directions (q, r) of what columns with these products can excite."""
    values, vectors = np.linalg.eigh(inner)
    keep = values > max(_DUST**2, _DUST_OF_MOST**2 * float(values.max(initial=0.0)))
    return np.sqrt(values[keep]), vectors[:, keep]


def _since_mounting(problem: Problem) -> FloatArray:
    """(n,) time since the unit was bolted as it stands, or since the run began on a table."""
    t = times(problem)
    group = "run" if problem.run.test == "rate_table" else "mount"
    new = np.diff(problem.stimulus.column(group), prepend=np.nan) != 0.0
    return t - np.maximum.accumulate(np.where(new, t, t[0]))


def _decays(since: FloatArray) -> FloatArray:
    """What dies away after a change (n, q); none where nothing ever changed."""
    if np.sum(since == 0.0) < 2:
        return np.zeros((len(since), 0))
    return np.exp(-since[:, None] / (np.array(_SHARES) * max(float(since.max()), 1e-9)))


def _followed(problem: Problem) -> tuple[str, FloatArray, FloatArray]:
    """Unit and setting before (n,), and inputs followed late (n, q), as by a body that creeps."""
    run, t = problem.run, times(problem)
    table = run.test == "rate_table"
    place = run.set_rate_dps if table else np.mod(run.head_deg, 360.0)
    inputs = place[:, None] if table else problem.stimulus.a
    size = np.max(np.abs(inputs))
    inputs = inputs[:, np.ptp(inputs, axis=0) > 1e-6 * size] / size
    steps = np.diff(t, prepend=t[0])
    keep = np.exp(-steps[:, None] / (np.array(_ROWS) * max(float(np.median(steps[1:])), 1e-9)))
    found = np.zeros((len(t), inputs.shape[1], len(_ROWS)))
    for row in range(1, len(t)):
        found[row] = keep[row] * found[row - 1] + (1.0 - keep[row]) * inputs[row - 1][:, None]
    before = np.concatenate([place[:1], place[:-1]])
    return "deg/s" if table else "deg", before, found.reshape(len(t), -1)


def _harmonics(head_deg: FloatArray) -> FloatArray:
    angle = RAD_PER_DEG * head_deg
    return np.column_stack(
        [wave(k * angle) * (2.0 / k) for k in range(2, _HARMONICS + 1) for wave in (np.sin, np.cos)]
    )


def powers(values: FloatArray, highest: int = _POWERS) -> FloatArray:
    """Legendre polynomials (n, q) over the range of a regressor, the higher the smaller."""
    middle, half = 0.5 * (values.max() + values.min()), 0.5 * float(np.ptp(values))
    x = (values - middle) / (half if half > 0.0 else 1.0)
    count = min(highest, len(np.unique(values.round(9))) - 1)
    one = np.eye(count + 1)
    return np.column_stack(
        [np.polynomial.Legendre(one[k])(x) * (2.0 / (k + 1)) for k in range(1, count + 1)]
        or [np.zeros((len(x), 0))]
    )


def waves(t: FloatArray) -> FloatArray:
    """Slow cosines (n, q) over time, and what turns from row to row."""
    span = float(np.ptp(t))
    x = (t - t[0]) / (span if span > 0.0 else 1.0)
    turns = np.where(np.arange(len(t)) % 2, -1.0, 1.0)  # every other row
    waves = [np.cos(np.pi * k * x) / k for k in range(1, _WAVES + 1)]
    return np.column_stack([*waves, turns, turns * np.cos(np.pi * x)])


def _bumps_around(head_deg: FloatArray) -> FloatArray:
    """Curves that are local in the head angle."""
    away = (head_deg[:, None] - np.arange(0.0, 360.0, _LOCAL_DEG) + 180.0) % 360.0 - 180.0
    return np.exp(-0.5 * (away / _LOCAL_DEG) ** 2)


def bumps(values: FloatArray) -> FloatArray:
    """Curves that are local in a regressor."""
    width = _LOCAL * float(np.ptp(values))
    centres = float(values.min()) + float(np.ptp(values)) * np.arange(12) / 11.0
    return np.exp(-0.5 * ((values[:, None] - centres) / width) ** 2)


def _groups(values: FloatArray) -> FloatArray:
    return np.column_stack([(values == one).astype(np.float64) for one in np.unique(values)])
