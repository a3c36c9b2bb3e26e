"""Rows that mean something else than they say; nothing is fitted."""

from dataclasses import replace
from itertools import permutations

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray
from core.model.catalogue.terms import ALL, HEAD, STATIC, TABLE, levels, sweeps
from core.model.effect import Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus
from core.units import RAD_PER_DEG

_ABOUT = 0.05
"""How far two estimates of a ratio of scales may differ: cross-axis sensitivities."""


class _Relabelling(Effect):
    """Rows mean something else than they say; nothing is fitted."""

    kind = Kind.RELABEL
    instant = False
    shared = True

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """None."""
        return ()

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """None."""
        return np.zeros((len(stimulus), 0))


class PositionsSwapped(_Relabelling):
    """Two rows stand in each other's place.

    Parameters
    ----------
    first, second : the rows
    """

    id = "positions_swapped"
    name = "Positions swapped"
    plain = "two positions were stored in each other's place"
    equation = "rows i and j exchanged"
    kind = Kind.EXCHANGE
    tests = ALL
    seen_as = "two rows lie off, and exchanging them leaves nothing"
    remedy = "exchange the two rows, or measure them again"
    confused_with = ("outlier", "wrong_angle")

    def __init__(self, first: int = 0, second: int = 0) -> None:
        self._first, self._second = first, second

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """The rows, from 1."""
        return (
            (Parameter("row", "", ""), float(self._first + 1)),
            (Parameter("other_row", "", ""), float(self._second + 1)),
        )

    def relabel(self, stimulus: Stimulus, y: FloatArray) -> tuple[Stimulus, FloatArray]:
        """Exchange the outputs of the rows."""
        right = y.copy()
        right[[self._first, self._second]] = y[[self._second, self._first]]
        return stimulus, right

    def exchanges(self, stimulus: Stimulus) -> IntArray:
        """All pairs of rows at different settings."""
        rows = np.arange(len(stimulus))
        first, second = np.triu_indices(len(rows), 1)
        names = [name for name in ("head_deg", "mount", "set_rate_dps") if name in stimulus.columns]
        place = np.nan_to_num(np.column_stack([stimulus.columns[name] for name in names]))
        other = np.any(place[first] != place[second], axis=1)
        return np.column_stack([first[other], second[other]]).astype(np.int64)

    def exchanged(self, first: int, second: int) -> Effect:
        """The exchange of two rows."""
        return PositionsSwapped(first, second)


class MountReversed(_Relabelling):
    """X-from and X-to confused in one mounting.

    Parameters
    ----------
    counted : how `number` counts the mountings: ``"mount"`` by what is written, ``"sweep"`` in
        the order of measuring, ``"place"`` in the order within each run
    number : of the mounting
    """

    id = "mount_reversed"
    name = "Mount reversed"
    plain = "in one mounting the unit stood the other way round than written"
    equation = "the head turned the other way in that mounting"
    needs = ("mount", "run", "head_deg")
    tests = STATIC
    seen_as = "the cross-axis sensitivity has another sign in one mounting"
    remedy = "correct the mount, or mount it as planned and repeat"
    confused_with = ("mounting_angle",)

    def __init__(self, counted: str = "mount", number: int = 0) -> None:
        self._counted, self._number = counted, number

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Which mounting, from 1."""
        return ((Parameter(self._counted, "", ""), self._number + 1.0),)

    def relabel(self, stimulus: Stimulus, y: FloatArray) -> tuple[Stimulus, FloatArray]:
        """Turn the unit end for end: what lies level across the shaft changes its sign.

        At head angle zero the unit stands as before, so the plane of rotation is reflected in
        the direction that points up there.
        """
        here = _counted(stimulus, self._counted) == self._number
        first = int(np.flatnonzero(here)[0])
        head = RAD_PER_DEG * stimulus.column("head_deg")
        up = (
            np.cos(head[first]) * stimulus.a[first]
            - np.sin(head[first]) * (stimulus.da_dhead[first])
        )
        up = up / np.linalg.norm(up)
        a, da = stimulus.a.copy(), stimulus.da_dhead.copy()
        a[here] = 2.0 * (a[here] @ up)[:, None] * up - a[here]
        da[here] = 2.0 * (da[here] @ up)[:, None] * up - da[here]
        return replace(stimulus, a=a, da_dhead=da), y

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every mounting, if there are several; all reversed is only another name of the axes."""
        places = _places(stimulus, ("mount", "place", "sweep"))
        return tuple(MountReversed(*place) for place in places)


class RateSignReversed(_Relabelling):
    """The sense of rotation was entered wrong.

    Parameters
    ----------
    run, row : the run, or the row if it is not negative
    """

    id = "rate_sign_reversed"
    name = "Rate sign reversed"
    plain = "the table turned the other way than written"
    equation = "-w in a run or at a row"
    needs = ("run", "set_rate_dps")
    tests = TABLE
    sensors = ("gyro",)
    seen_as = "rows on the line of the opposite slope"
    remedy = "correct the sign"
    confused_with = ("positions_swapped", "outlier")

    def __init__(self, run: float = 0.0, row: int = -1) -> None:
        self._run, self._row = run, row

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """The run, or the row from 1."""
        if self._row >= 0:
            return ((Parameter("row", "", ""), float(self._row + 1)),)
        return ((Parameter("run", "", ""), self._run),)

    def relabel(self, stimulus: Stimulus, y: FloatArray) -> tuple[Stimulus, FloatArray]:
        """Turn the rate round."""
        here = stimulus.column("run") == self._run
        if self._row >= 0:
            here = np.arange(len(stimulus)) == self._row
        w = stimulus.w - 2.0 * stimulus.dw_drate * (here * stimulus.column("set_rate_dps"))[:, None]
        return replace(stimulus, w=w), y

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every run, if there are several, and every row that turned."""
        runs = levels(stimulus.column("run"))
        rates = stimulus.column("set_rate_dps")
        whole = [RateSignReversed(run) for run in runs] if len(runs) > 1 else []
        rows = [RateSignReversed(0.0, int(row)) for row in np.flatnonzero(rates)]
        return (*whole, *rows)


class ChannelsPermuted(_Relabelling):
    """Outputs of a triad stand in each other's columns.

    Parameters
    ----------
    order : column that really holds the first, second, ... output
    counted, number : which mounting, see `MountReversed`, or which ``"run"``
    scaled : the sensors were exchanged before the amplifiers, so that each output has the scale
        of its column, else the columns as they are
    """

    id = "channels_permuted"
    name = "Channels permuted"
    plain = "outputs of the triad stand in each other's columns"
    equation = "columns of y exchanged"
    needs = ("mount", "run", "head_deg")
    tests = HEAD
    seen_as = "a sensor answers to the axis of another one"
    remedy = "correct the names of the columns"

    def __init__(
        self,
        order: tuple[int, ...] = (),
        counted: str = "mount",
        number: int = 0,
        *,
        scaled: bool = False,
    ) -> None:
        self._order, self._counted, self._number = order, counted, number
        self._scaled = scaled

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Which column holds which output, and the mounting, from 1."""
        columns = "".join(str(place + 1) for place in self._order) or "0"
        return (
            (Parameter("columns", "", ""), float(columns)),
            (Parameter(self._counted, "", ""), self._number + 1.0),
            (Parameter("before_amplifiers", "", ""), float(self._scaled)),
        )

    def relabel(self, stimulus: Stimulus, y: FloatArray) -> tuple[Stimulus, FloatArray]:
        """Put the columns right."""
        if y.shape[1] != len(self._order):
            return stimulus, y
        here = _counted(stimulus, self._counted) == self._number
        moved = y[:, list(self._order)]
        if self._scaled:
            moved = moved * _ratios(stimulus.a, y, here, self._order)
        return stimulus, np.where(here[:, None], moved, y)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every order of three columns in every mounting; in all it is only another naming."""
        orders = ((1, 0, 2), (0, 2, 1), (2, 1, 0), (1, 2, 0), (2, 0, 1))
        places = _places(stimulus, ("mount", "place", "sweep", "run"))
        return tuple(
            ChannelsPermuted(order, *place, scaled=scaled)
            for place in places
            for order in orders
            for scaled in (False, True)
        )


def _ratios(a: FloatArray, y: FloatArray, here: BoolArray, order: tuple[int, ...]) -> FloatArray:
    """(3,) scale of each output over that of the column which holds it, from the rows themselves.

    First from how far each column swings with the axis that it shows; then such that the rows of
    the exchange and the others lie on one plane (least squares).
    """
    elsewhere = np.linalg.lstsq(_with_bias(a[~here]), y[~here], rcond=None)[0][1:].T
    swing = np.abs(elsewhere) / np.maximum(np.abs(elsewhere).max(axis=1, keepdims=True), 1e-300)
    axes = max(permutations(range(3)), key=lambda p: sum(swing[i, p[i]] for i in range(3)))
    shown = a[:, list(axes)]
    for output, held in enumerate(order):
        shown[here, held] = a[here, axes[output]]
    moved = shown - shown.mean(axis=0)
    size = np.maximum(np.sum(moved**2, axis=0), 1e-300)
    gain = np.sum(moved * y, axis=0) / size
    gain = np.where(np.abs(gain) > 0.0, gain, 1.0)
    left = np.linalg.qr(_with_bias(a))[0]
    found = np.empty(3)
    for output, held in enumerate(order):
        near = gain[output] / gain[held]
        parts = np.column_stack([~here * y[:, output], here * y[:, held]])
        parts = parts - left @ (left.T @ parts)
        finer = -float(parts[:, 0] @ parts[:, 1]) / max(float(parts[:, 1] @ parts[:, 1]), 1e-300)
        found[output] = finer if abs(finer / near - 1.0) < _ABOUT else near
    return np.where(np.array(order) == np.arange(3), 1.0, found)


def _with_bias(a: FloatArray) -> FloatArray:
    return np.column_stack([np.ones(len(a)), a])


def _places(stimulus: Stimulus, ways: tuple[str, ...]) -> list[tuple[str, int]]:
    """Mountings by different ways of counting, each set of rows once, but never all rows."""
    found: dict[bytes, tuple[str, int]] = {}
    for counted in ways:
        groups = _counted(stimulus, counted)
        for number in levels(groups):
            here = groups == number
            if not here.all():
                found.setdefault(here.tobytes(), (counted, int(number)))
    return list(found.values())


def _counted(stimulus: Stimulus, how: str) -> FloatArray:
    """Number (n,) of the mounting of each row."""
    if how in ("mount", "run"):
        numbers = stimulus.column(how)
        return numbers - (numbers.min() if how == "run" else 0.0)
    sweep = sweeps(stimulus).astype(np.float64)
    if how == "sweep":
        return sweep
    run = stimulus.column("run")
    first = {one: float(sweep[run == one].min()) for one in levels(run)}
    return sweep - np.array([first[float(one)] for one in run])
