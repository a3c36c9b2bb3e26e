"""Faults at single rows, rows that mean something else, and gyros at rest."""

import numpy as np
import pytest

from core.model.catalogue.faults import (
    Outlier,
    ShortAccumulation,
    StuckReading,
    WrongAngle,
    WrongStop,
)
from core.model.catalogue.gyro_static import EarthRate, GSquared, MagneticSensitivity
from core.model.catalogue.relabelling import (
    ChannelsPermuted,
    MountReversed,
    PositionsSwapped,
    RateSignReversed,
)
from core.model.effect import Kind, Sensor
from core.model.stimulus import Stimulus, stimulus_of
from core.units import STANDARD_GRAVITY
from tests.core.discrepancy.hidden import head_run, table_run

G = STANDARD_GRAVITY
ROWS = [
    (run, mount, a) for run in (1, 2) for mount in ("X_from", "X_to") for a in (0.0, 30.0, 75.0)
]
STIMULUS = stimulus_of(head_run(rows=ROWS), G)
N = len(ROWS)
Z = Sensor("accelerometer", "z", "V", (0.0, 0.0, 1.0 / G))
TABLE = stimulus_of(table_run(), np.nan)
GYRO = Sensor("gyro", "z", "V")


def with_column(name: str, values: np.ndarray) -> Stimulus:
    return Stimulus(
        STIMULUS.a,
        STIMULUS.w,
        STIMULUS.da_dhead,
        STIMULUS.dw_drate,
        {**STIMULUS.columns, name: values},
    )


def test_a_fault_of_a_row_is_at_that_row_alone():
    assert Outlier(3).columns(STIMULUS, Z)[:, 0] == pytest.approx(1e-3 * (np.arange(N) == 3))
    angle = WrongAngle(4).columns(STIMULUS, Z)[:, 0]
    slope = STIMULUS.da_dhead[4, 2] / G
    assert angle == pytest.approx(np.radians(1.0) * slope * (np.arange(N) == 4))
    assert len(Outlier().instances(STIMULUS, Z)) == N
    assert Outlier(3).shape[0][1] == 4.0


def test_a_wrong_stop_repeats_in_every_run_of_its_mounting():
    found = WrongStop(1.0, 30.0).columns(STIMULUS, Z)[:, 0]
    assert np.flatnonzero(found).tolist() == [4, 10]
    assert len(WrongStop().instances(STIMULUS, Z)) == 6


def test_short_accumulations_and_stuck_readings_are_looked_for_where_the_rows_show_them():
    se = np.ones(N)
    se[5] = 1.8
    loud = with_column("y_se", se)
    assert [one.shape[0][1] for one in ShortAccumulation().instances(loud, Z)] == [6.0]
    back = ShortAccumulation(5).columns(loud, Z)[5, 0]
    assert back == pytest.approx(0.01 * (STIMULUS.a[4, 2] - STIMULUS.a[5, 2]) / G)
    same = with_column("repeated", (np.arange(N) == 7).astype(float))
    assert [one.shape[0][1] for one in StuckReading().instances(same, Z)] == [8.0]


def test_an_exchange_moves_two_rows_and_is_tried_only_between_different_positions():
    y = np.arange(2.0 * N).reshape(N, 2)
    swap = PositionsSwapped().exchanged(2, 9)
    assert swap.kind is Kind.EXCHANGE
    right = swap.relabel(STIMULUS, y)[1]
    assert right[2].tolist() == y[9].tolist()
    assert right[9].tolist() == y[2].tolist()
    pairs = {tuple(pair) for pair in swap.exchanges(STIMULUS).tolist()}
    assert (0, 6) not in pairs
    assert (0, 3) in pairs


def test_a_unit_the_other_way_round_feels_what_the_other_mount_would():
    truth = stimulus_of(head_run(rows=[(r, "X_to", a) for r, _, a in ROWS]), G)
    turned, _ = MountReversed("mount", 0).relabel(STIMULUS, np.zeros((N, 1)))
    here = STIMULUS.column("mount") == 0.0
    assert turned.a[here] == pytest.approx(truth.a[here], abs=1e-9)
    assert turned.da_dhead[here] == pytest.approx(truth.da_dhead[here], abs=1e-9)
    assert np.array_equal(turned.a[~here], STIMULUS.a[~here])
    places = MountReversed().instances(STIMULUS, Z)
    rows = {turned_rows(place) for place in places}
    assert len(rows) == len(places)
    assert (3, 4, 5, 9, 10, 11) in rows
    assert (3, 4, 5) in rows


def turned_rows(effect: MountReversed) -> tuple[int, ...]:
    turned, _ = effect.relabel(STIMULUS, np.zeros((N, 1)))
    moved = np.any(np.abs(turned.da_dhead - STIMULUS.da_dhead) > 1e-9, axis=1)
    return tuple(np.flatnonzero(moved).tolist())


def test_a_reversed_rate_turns_the_input_round():
    run, _ = RateSignReversed(2.0).relabel(TABLE, np.zeros((84, 1)))
    here = TABLE.column("run") == 2.0
    assert run.w[here, 2] == pytest.approx(-TABLE.w[here, 2])
    assert run.w[~here, 2] == pytest.approx(TABLE.w[~here, 2])
    row, _ = RateSignReversed(0.0, 5).relabel(TABLE, np.zeros((84, 1)))
    assert np.flatnonzero(row.w[:, 2] != TABLE.w[:, 2]).tolist() == [5]


def test_columns_are_put_back_in_one_mounting():
    y = np.tile([1.0, 2.0, 3.0], (N, 1))
    _, right = ChannelsPermuted((1, 2, 0), "mount", 1).relabel(STIMULUS, y)
    assert right[3].tolist() == [2.0, 3.0, 1.0]
    assert right[0].tolist() == [1.0, 2.0, 3.0]
    assert ChannelsPermuted((1, 2, 0)).relabel(STIMULUS, y[:, :1])[1].shape == (N, 1)


def test_a_gyro_at_rest():
    up = STIMULUS.a / G
    assert GSquared("yz").columns(STIMULUS, GYRO)[:, 0] == pytest.approx(up[:, 1] * up[:, 2])
    earth = EarthRate().columns(STIMULUS, GYRO)
    assert earth[:, 0] == pytest.approx(up[:, 2])
    field = MagneticSensitivity().columns(STIMULUS, Sensor("gyro", "x", "V"))
    assert np.abs(field[:, 0]) == pytest.approx(np.ones(N))
    assert np.sign(field[0, 0]) == -np.sign(field[3, 0])
