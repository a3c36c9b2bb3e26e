"""Mistakes of the operator and faults of the data: what happened once, or says something else."""

from dataclasses import replace

import numpy as np

from core.arrays import FloatArray, IntArray
from core.model.catalogue.terms import (
    ALL,
    HEAD,
    STATIC,
    TABLE,
    column,
    ideal,
    levels,
    per_head_angle,
    small_gain,
    small_unit,
    sweeps,
)
from core.model.effect import Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus
from core.units import RAD_PER_DEG


class _RowFault(Effect):
    """Something at one row."""

    kind = Kind.EVENT
    tests = ALL

    def __init__(self, row: int = 0) -> None:
        self._row = row

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Which row, from 1."""
        return ((Parameter("row", "", ""), float(self._row + 1)),)

    def here(self, stimulus: Stimulus) -> FloatArray:
        """1 at the row, else 0."""
        return (np.arange(len(stimulus)) == self._row).astype(np.float64)


class Outlier(_RowFault):
    """One accumulation that was disturbed."""

    id = "outlier"
    name = "Outlier"
    plain = "one accumulation was disturbed"
    equation = "e at one row"
    seen_as = "one row lies off"
    remedy = "look at the raw samples of this row; measure it again"
    confused_with = ("wrong_angle", "positions_swapped")
    typical = {"accelerometer": 1.0, "gyro": 0.1}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg or deg/s."""
        return (Parameter("error", "e", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """1 at the row."""
        return column(small_gain(sensor) * self.here(stimulus))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every row."""
        return tuple(Outlier(row) for row in range(len(stimulus)))


class WrongAngle(_RowFault):
    """The head stood at another angle than written, once."""

    id = "wrong_angle"
    name = "Wrong angle"
    plain = "the head stood at another angle than written"
    equation = "U(angle + d) - U(angle) at one row"
    needs = ("head_deg",)
    tests = HEAD
    sensors = ("accelerometer",)
    shared = True
    seen_as = "one row lies off in all sensors, as one angle explains"
    remedy = "correct the angle if it is a whole step of the dial, else measure the row again"
    confused_with = ("outlier", "wrong_stop")
    typical = {"accelerometer": 1.0}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: deg."""
        return (Parameter("angle_error", "d", "deg"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The slope at the row."""
        return column(RAD_PER_DEG * per_head_angle(stimulus, sensor) * self.here(stimulus))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every row."""
        return tuple(WrongAngle(row) for row in range(len(stimulus)))


class WrongStop(Effect):
    """The same wrong angle in every run.

    Parameters
    ----------
    mount, head_deg : the position; mounts are numbered
    """

    id = "wrong_stop"
    name = "Wrong stop"
    plain = "at one position the head stood wrong in every run"
    equation = "U(angle + d) - U(angle) at one position"
    needs = ("head_deg", "mount")
    kind = Kind.EVENT
    tests = HEAD
    sensors = ("accelerometer",)
    shared = True
    seen_as = "all rows of one position lie off alike"
    remedy = "check the stop or the division of the head there"
    confused_with = ("wrong_angle",)
    typical = {"accelerometer": 0.05}  # noqa: RUF012

    def __init__(self, mount: float = 0.0, head_deg: float = 0.0) -> None:
        self._mount, self._head = mount, head_deg

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Mounting, from 1, and angle."""
        return (
            (Parameter("mounting", "", ""), self._mount + 1.0),
            (Parameter("at", "", "deg"), self._head),
        )

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: deg."""
        return (Parameter("angle_error", "d", "deg"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The slope at the position."""
        head = np.mod(stimulus.column("head_deg"), 360.0)
        here = (stimulus.column("mount") == self._mount) & (head == self._head)
        return column(RAD_PER_DEG * per_head_angle(stimulus, sensor) * here)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every position that was visited more than once."""
        head, mount = np.mod(stimulus.column("head_deg"), 360.0), stimulus.column("mount")
        places, counts = np.unique(np.column_stack([mount, head]), axis=0, return_counts=True)
        return tuple(
            WrongStop(float(m), float(h))
            for (m, h), count in zip(places, counts, strict=True)
            if count > 1
        )


class ShortAccumulation(_RowFault):
    """One accumulation began while the output still moved."""

    id = "short_accumulation"
    name = "Short accumulation"
    plain = "one accumulation began too early or was too short"
    equation = "rho * (U_previous - U) at one row"
    needs = ("y_se",)
    seen_as = "one row lies off towards the row before, and its own scatter is large"
    remedy = "look at the raw samples; wait longer; measure the row again"
    confused_with = ("outlier", "settling_lag")
    typical = {"accelerometer": 0.1, "gyro": 0.1}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: the missing part of the step, %."""
        return (Parameter("lag", "rho", "%"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The step back to the row before, at the row."""
        u = ideal(stimulus, sensor)
        return column(0.01 * (np.roll(u, 1) - u) * self.here(stimulus))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Rows whose own scatter is half as large again as usual."""
        se = stimulus.column("y_se")
        rows = np.flatnonzero(se > 1.5 * np.median(se))
        return tuple(ShortAccumulation(int(row)) for row in rows if row > 0)


class _Relabelling(Effect):
    """Rows mean something else than they say; nothing is fitted."""

    kind = Kind.RELABEL
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
        found: dict[bytes, Effect] = {}
        for counted in ("mount", "place", "sweep"):
            groups = _counted(stimulus, counted)
            for number in levels(groups):
                here = groups == number
                if not here.all():
                    found.setdefault(here.tobytes(), MountReversed(counted, int(number)))
        return tuple(found.values())


def _counted(stimulus: Stimulus, how: str) -> FloatArray:
    """Number (n,) of the mounting of each row."""
    if how == "mount":
        return stimulus.column("mount")
    sweep = sweeps(stimulus).astype(np.float64)
    if how == "sweep":
        return sweep
    run = stimulus.column("run")
    first = {one: float(sweep[run == one].min()) for one in levels(run)}
    return sweep - np.array([first[float(one)] for one in run])


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
    mount : number of the mounting; -1 for all
    """

    id = "channels_permuted"
    name = "Channels permuted"
    plain = "outputs of the triad stand in each other's columns"
    equation = "columns of y exchanged"
    needs = ("mount",)
    tests = HEAD
    seen_as = "a sensor answers to the axis of another one"
    remedy = "correct the names of the columns"

    def __init__(self, order: tuple[int, ...] = (), mount: int = -1) -> None:
        self._order, self._mount = order, mount

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Which column holds which output, and the mounting, from 1; 0 for all."""
        columns = "".join(str(place + 1) for place in self._order) or "0"
        return (
            (Parameter("columns", "", ""), float(columns)),
            (Parameter("mounting", "", ""), float(self._mount + 1)),
        )

    def relabel(self, stimulus: Stimulus, y: FloatArray) -> tuple[Stimulus, FloatArray]:
        """Put the columns right."""
        if y.shape[1] != len(self._order):
            return stimulus, y
        here = stimulus.column("mount") == self._mount if self._mount >= 0 else True
        return stimulus, np.where(np.atleast_1d(here)[:, None], y[:, list(self._order)], y)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every order of three columns in every mounting; in all it is only another naming."""
        orders = ((1, 0, 2), (0, 2, 1), (2, 1, 0), (1, 2, 0), (2, 0, 1))
        mounts = levels(stimulus.column("mount"))
        if len(mounts) < 2:
            return ()
        return tuple(ChannelsPermuted(order, int(m)) for m in mounts for order in orders)


class StuckReading(_RowFault):
    """The reading of the row before was stored again."""

    id = "stuck_reading"
    name = "Stuck reading"
    plain = "the reading of the row before was stored again, bit for bit"
    equation = "e at one row"
    needs = ("repeated",)
    seen_as = "a row that equals the row before exactly, at another setting"
    remedy = "measure the row again"
    confused_with = ("outlier",)
    typical = {"accelerometer": 1000.0, "gyro": 10.0}  # noqa: RUF012
    # That two readings are equal by chance to the last bit is less likely than this.
    log_odds = 10.0

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg or deg/s."""
        return (Parameter("error", "e", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """1 at the row."""
        return column(small_gain(sensor) * self.here(stimulus))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Rows that equal the row before."""
        rows = np.flatnonzero(stimulus.column("repeated") > 0)
        return tuple(StuckReading(int(row)) for row in rows)
