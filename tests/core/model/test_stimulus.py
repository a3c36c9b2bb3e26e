"""What acts on head and table, against geometry worked by hand."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.model.stimulus import Stimulus, stack, stimulus_of, table_axes
from core.plans.orientation import (
    BaseOrientation,
    earth_rate,
    specific_force,
    tilter_rotation,
)
from core.samples.run import Run
from core.units import EARTH_RATE_DPS

G = 9.8106
NAN = float("nan")


def run_of(
    test: str,
    mounts: tuple[str, ...],
    *,
    head: list[float] | None = None,
    rates: list[float] | None = None,
    axes: tuple[str, ...] = ("z",),
) -> Run:
    n = len(mounts)
    unknown = np.full(n, np.nan)
    return Run(
        test=test,
        sensor="gyro",
        device="G",
        channels=tuple(f"U{i}" for i in range(len(axes))),
        axes=axes,
        unit="code",
        y=np.zeros((n, len(axes))),
        y_se=np.full((n, len(axes)), np.nan),
        run=np.ones(n, dtype=np.int64),
        order=np.arange(n),
        mount=mounts,
        head_deg=unknown if head is None else np.array(head),
        set_rate_dps=unknown if rates is None else np.array(rates),
        temperature_c=unknown,
        t_s=unknown,
        extra={"quadrature": np.arange(n, dtype=np.float64)},
    )


def test_on_the_head_gravity_turns_with_mount_and_angle():
    run = run_of("static_positions", ("X_from", "Y_to", "Z_from@90"), head=[30.0, 200.0, 45.0])
    stimulus = stimulus_of(run, G)
    for row, (mount, head) in enumerate(zip(run.mount, run.head_deg, strict=True)):
        assert np.allclose(stimulus.a[row], specific_force(mount, head, G))
    assert not stimulus.w.any()
    assert not stimulus.dw_drate.any()


def test_the_derivative_by_the_head_angle_is_that_of_small_turns():
    heads = [0.0, 30.0, 90.0, 200.0]
    run = run_of("dividing_head", ("X_from", "Y_to", "Z_from", "X_to"), head=heads)
    small = 1e-3
    turned = replace(run, head_deg=run.head_deg + small)
    back = replace(run, head_deg=run.head_deg - small)
    difference = stimulus_of(turned, G).a - stimulus_of(back, G).a
    slope = difference / np.deg2rad(2 * small)
    assert np.allclose(stimulus_of(run, G).da_dhead, slope, atol=1e-6)


def test_the_earth_turns_a_gyro_on_the_head():
    base = BaseOrientation(psi_deg=40.0)
    run = run_of("static_positions", ("X_from", "Y_from"), head=[90.0, 0.0])
    stimulus = stimulus_of(run, G, latitude_deg=50.45, base=base)
    for row, (mount, head) in enumerate(zip(run.mount, run.head_deg, strict=True)):
        assert np.allclose(stimulus.w[row], earth_rate(mount, head, 50.45, base))


def test_a_tilter_turns_the_case_on_the_plate():
    run = run_of("static_positions", ("Z_from", "X_from"), head=[30.0, 0.0])
    straight = stimulus_of(run, G, latitude_deg=50.45)
    tilted = stimulus_of(run, G, latitude_deg=50.45, tilter_deg=(0.0, 20.0, 0.0))
    assert np.allclose(tilted.a, straight.a @ tilter_rotation(0.0, 20.0, 0.0).T)
    assert np.allclose(np.linalg.norm(tilted.w, axis=1), np.linalg.norm(straight.w, axis=1))
    # X_from at 0: Z up. A positive pitch lifts Y (2.8).
    assert tilted.a[1] == pytest.approx(G * np.array([0.0, np.sin(0.349066), np.cos(0.349066)]))


def test_the_table_turns_the_axis_that_the_mount_puts_up():
    run = run_of(
        "rate_table",
        ("X_from", "Y_from", "Z_from", "Z_to"),
        rates=[10.0, -20.0, 30.0, 40.0],
        axes=("x", "y", "z"),
    )
    stimulus = stimulus_of(run, G)
    assert np.array_equal(stimulus.w, [[10, 0, 0], [0, -20, 0], [0, 0, 30], [0, 0, -40]])
    assert np.allclose(stimulus.a, G * np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1]]))
    assert np.array_equal(stimulus.dw_drate, [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1]])
    assert not stimulus.da_dhead.any()


def test_without_a_mount_the_sensors_axis_is_the_tables():
    run = run_of("rate_table", ("", ""), rates=[10.0, 0.0], axes=("y", "y"))
    assert np.array_equal(stimulus_of(run, G).w, [[0, 10, 0], [0, 0, 0]])
    nameless = run_of("rate_table", ("", ""), rates=[10.0, 0.0], axes=("",))
    assert np.array_equal(stimulus_of(nameless, G).w, [[0, 0, 10], [0, 0, 0]])


def test_a_triad_needs_a_mount_on_the_table():
    run = run_of("rate_table", ("Z_from", ""), rates=[1.0, 2.0], axes=("x", "y", "z"))
    with pytest.raises(FitError, match="x, y, z"):
        table_axes(run)


def test_the_earth_adds_its_vertical_part_on_the_table():
    run = run_of("rate_table", ("Z_from", "Z_to"), rates=[10.0, 10.0])
    w = stimulus_of(run, G, latitude_deg=30.0).w
    assert np.allclose(w[:, 2], [10.0 + EARTH_RATE_DPS / 2, -10.0 - EARTH_RATE_DPS / 2])
    assert not w[:, :2].any()


def test_a_leaning_table_feels_less_of_gravity():
    run = run_of("rate_table", ("Z_from",), rates=[10.0])
    leaning = BaseOrientation(alpha_arcmin=-60.0)
    a = stimulus_of(run, G, base=leaning).a
    assert a[0, 2] == pytest.approx(G * np.cos(np.deg2rad(1.0)), rel=1e-12)


def test_the_table_works_without_g_and_the_head_does_not():
    on_table = stimulus_of(run_of("rate_table", ("",), rates=[1.0]), NAN)
    assert np.isnan(on_table.a).all()
    assert np.array_equal(on_table.w, [[0, 0, 1]])
    for g in (NAN, 0.0, -9.8):
        with pytest.raises(FitError, match="gravity"):
            stimulus_of(run_of("dividing_head", ("X_from",), head=[0.0]), g)
    with pytest.raises(FitError, match="gravity"):
        stimulus_of(run_of("rate_table", ("",), rates=[1.0]), -9.8)


@pytest.mark.parametrize(
    ("run", "says"),
    [
        (run_of("dividing_head", ("X_from", "X_from"), head=[0.0, NAN]), "row 2: the head angle"),
        (run_of("dividing_head", ("X_from", "W"), head=[0.0, 0.0]), "row 2: unknown mount"),
        (run_of("rate_table", ("", ""), rates=[0.0, NAN]), "row 2: the set rate"),
        (run_of("rate_table", ("Z_from", "W"), rates=[0.0, 1.0]), "row 2: unknown mount"),
    ],
)
def test_what_is_missing_is_said_by_row(run: Run, says: str):
    with pytest.raises(FitError, match=says):
        stimulus_of(run, G)


def test_small_changes_of_the_input():
    run = run_of("rate_table", ("Z_to",), rates=[10.0])
    stimulus = stimulus_of(run, G)
    assert np.array_equal(stimulus.spun(0.5).w, [[0, 0, -10.5]])
    assert np.allclose(stimulus.scaled_force(1.01).a, 1.01 * stimulus.a)
    on_head = stimulus_of(run_of("dividing_head", ("X_from",), head=[0.0]), G)
    assert np.allclose(on_head.turned(1e-3).a, [[0, -G * 1e-3, G]])


def test_columns_by_name():
    stimulus = stimulus_of(run_of("rate_table", ("", ""), rates=[1.0, 2.0]), G)
    assert np.array_equal(stimulus.column("quadrature"), [0.0, 1.0])
    assert np.array_equal(stimulus.column("set_rate_dps"), [1.0, 2.0])
    for name in ("temperature_c", "pressure"):
        with pytest.raises(FitError, match=name):
            stimulus.column(name)


def test_stacked_runs_keep_their_columns():
    table = stimulus_of(run_of("rate_table", ("Z_from",) * 2, rates=[1.0, 2.0]), G)
    head = stimulus_of(run_of("static_positions", ("X_from",), head=[90.0]), G)
    both = stack(table, head)
    assert isinstance(both, Stimulus)
    assert len(both) == 3
    assert np.allclose(both.a, [[0, 0, G], [0, 0, G], [0, -G, 0]])
    assert np.allclose(both.w, [[0, 0, 1], [0, 0, 2], [0, 0, 0]])
    assert np.allclose(both.da_dhead[2], [0, 0, -G])
    assert np.allclose(both.dw_drate, [[0, 0, 1], [0, 0, 1], [0, 0, 0]])
    assert np.array_equal(both.columns["set_rate_dps"], [1.0, 2.0, NAN], equal_nan=True)
    assert np.array_equal(both.columns["quadrature"], [0.0, 1.0, 0.0])
    lonely = replace(head, columns={})
    assert np.isnan(stack(table, lonely).columns["quadrature"][2])
