"""The blind generator: its geometry, its noise, the sizes it hides, its seals, its independence."""

import ast
import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.blind import (
    adc,
    cases,
    effects,
    geometry,
    head,
    long_record,
    noise,
    play,
    record_cases,
    severity,
)
from tests.blind.cases import Spec, draw_case
from tests.blind.plans import NAMES, Plan, continued, plan_of
from tests.blind.severity import Glass
from tests.blind.world import Hidden, World, world_of

HERE = Path(__file__).parent
SOURCES = sorted(path for path in HERE.glob("*.py") if not path.name.startswith("test_"))


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: path.name)
def test_generator_and_scorer_share_nothing_with_the_program(path: Path):
    allowed = {"numpy", "scipy", "tests", *sys.stdlib_module_names}
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        names = []
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            names = [node.module or ""]
        for name in names:
            assert name.split(".")[0] in allowed, name
            assert name.split(".")[0] != "tests" or name.startswith("tests.blind"), name


G = 1.0
GOLDEN = {
    "X_from": [(0, 0, G), (0, -G, 0), (0, 0, -G), (0, G, 0)],
    "X_to": [(0, 0, G), (0, G, 0), (0, 0, -G), (0, -G, 0)],
    "Y_from": [(0, 0, G), (G, 0, 0), (0, 0, -G), (-G, 0, 0)],
    "Y_to": [(0, 0, G), (-G, 0, 0), (0, 0, -G), (G, 0, 0)],
    "Z_from": [(G, 0, 0), (0, G, 0), (-G, 0, 0), (0, -G, 0)],
    "X_from@90": [(0, -G, 0), (0, 0, -G), (0, G, 0), (0, 0, G)],
}


@pytest.mark.parametrize("mount", GOLDEN)
def test_specific_force_in_the_practicums_positions(mount: str):
    dial = np.radians([0.0, 90.0, 180.0, 270.0])
    room = geometry.attitude([mount] * 4, dial, 0.0, np.zeros(4))
    force = geometry.seen_from_case(geometry.UP, room)
    np.testing.assert_allclose(force, np.array(GOLDEN[mount], float), atol=1e-15)
    np.testing.assert_allclose(np.linalg.det(room), 1.0)


def test_a_raised_shaft_is_felt_along_it_with_the_sense_of_the_mount():
    for mount, sign in (("X_from", 1.0), ("X_to", -1.0)):
        room = geometry.attitude([mount] * 8, np.linspace(0, 6, 8), 0.01, np.zeros(8))
        along = geometry.seen_from_case(geometry.UP, room)[:, 0]
        np.testing.assert_allclose(along, sign * np.sin(0.01))


def unit(plan: str, seed: int = 3, **options: bool) -> World:
    rng = np.random.default_rng(seed)
    return world_of(plan_of(plan, rng), rng, **options)


@pytest.mark.parametrize("plan", ["A24", "B11x3", "C8"])
@pytest.mark.parametrize("triad", [False, True])
def test_noise_has_the_covariance_that_lambda_is_measured_with(plan: str, triad: bool):
    world = unit(plan, triad=triad and plan[0] != "B", coloured=True)
    glass = Glass(world)
    rng = np.random.default_rng(5)
    squares = []
    for _ in range(300):
        readings = play.measure(world, {}, noise.draw(world, {}, rng), rng)
        error = readings.y / world.scale - glass.healthy
        white = glass.whiten(error.T.reshape(-1))
        squares.append(float(white @ white))
    dof = glass.healthy.size
    # Five sigmas of the mean of 300 chi-squares.
    assert abs(np.mean(squares) - dof) < 5.0 * np.sqrt(2.0 * dof / 300)


@pytest.mark.parametrize("plan", ["A24", "A80", "B84r", "C16"])
def test_an_oracle_finds_the_lambda_that_was_asked_for(plan: str):
    world = unit(plan)
    glass = Glass(world)
    rng = np.random.default_rng(7)
    hidden = Hidden(
        severity.sized(glass, "bias_jump", {"channel": 0, "row": 5}, 1e3, 12.0),
        {"channel": 0, "row": 5},
    )
    direction = glass.change({"bias_jump": hidden}) / 12.0
    found = []
    for _ in range(200):
        readings = play.measure(
            world, {"bias_jump": hidden}, noise.draw(world, {"bias_jump": hidden}, rng), rng
        )
        error = (readings.y / world.scale - glass.healthy).T.reshape(-1)
        found.append(float(direction @ glass.seen(error)))
    assert np.mean(found) == pytest.approx(12.0, abs=5.0 / np.sqrt(200))
    assert np.std(found) == pytest.approx(1.0, abs=5.0 / np.sqrt(2 * 200))


@pytest.mark.parametrize("plan", ["A80", "B84"])
def test_every_effect_gets_its_lambda_or_is_left_out(plan: str):
    world = unit(plan, has_amplitude=True)
    glass = Glass(world)
    rng = np.random.default_rng(11)
    left_out = []
    for name, kind in effects.testable(world).items():
        if kind.natural:
            continue
        shape = cases.shape_for(world, kind, rng)
        size = severity.sized(glass, name, shape, effects.limit_of(world, name, kind), 20.0)
        if size is None:
            left_out.append(name)
        else:
            lam = glass.visibility(name, Hidden(size, shape))
            assert lam == pytest.approx(20.0, rel=2e-3), name
    assert left_out == []


def test_effects_that_hide_each_other_are_not_hidden_together():
    one, other = np.eye(5)[:, 0], np.eye(5)[:, 1]
    assert severity.apart(np.stack([one, other], axis=1))
    assert not severity.apart(np.stack([one, one + 0.3 * other], axis=1))


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_wrong_angle_at_a_cardinal_position_gets_its_lambda_with_its_sign(sign: float):
    world = unit("A80")
    glass = Glass(world)
    row = int(np.flatnonzero(world.plan.setting % 90.0 == 0.0)[2])
    size = severity.sized(glass, "wrong_angle", {"row": row}, 0.2, 12.0, sign)
    assert size is not None
    seen = glass.visibility("wrong_angle", Hidden(sign * size, {"row": row}))
    assert seen == pytest.approx(12.0, rel=2e-3)


def test_what_the_four_cardinal_angles_cannot_see_is_left_out():
    spec = Spec("A24", "single", 12.0, 1, "third_order_nonlinearity")
    assert draw_case(spec) is None


def test_equals_are_known_by_the_generators_own_physics():
    case = draw_case(Spec("A24", "single", 12.0, 1, "second_order_nonlinearity"))
    equals = case.key["effects"]["second_order_nonlinearity"]["equals"]
    assert {"head_eccentricity", "scale_factor_asymmetry"} <= set(equals)
    clear = draw_case(Spec("A80", "single", 12.0, 1, "second_order_nonlinearity"))
    assert clear.key["effects"]["second_order_nonlinearity"]["equals"] == []


def test_mean_of_clipped_samples():
    rng = np.random.default_rng(2)
    samples = np.minimum(0.3 + 0.5 * rng.standard_normal(1_000_000), 0.4)
    value = adc.expected(np.array([[0.3]]), 0.5, np.array([-np.inf]), np.array([0.4]))
    assert value[0, 0] == pytest.approx(samples.mean(), abs=2e-3)


def test_lag_is_a_recursion_and_a_swap_moves_rows():
    world = unit("A24")
    lag = {"settling_lag": Hidden(0.1, {"channel": 0})}
    plain, late = play.truth(world, {})[:, 0], play.truth(world, lag)[:, 0]
    np.testing.assert_allclose(late[1:], plain[1:] + 0.1 * (late[:-1] - plain[1:]))
    swap = {"positions_swapped": Hidden(1.0, {"rows": (1, 2)})}
    moved = play.truth(world, swap)[:, 0]
    np.testing.assert_allclose(moved[[1, 2]], plain[[2, 1]], atol=1e-12)


def test_a_dial_error_acts_inside_the_sine():
    world = unit("A24")
    error = {"head_eccentricity": Hidden(0.2, {"phase": np.pi / 2})}
    room = head.attitudes(world, error, head.still(world))
    dial = np.radians(world.plan.setting)
    expected = -np.sin(dial + 0.2 * np.sin(dial - np.pi / 2))
    first = world.plan.setups == 0
    force = geometry.seen_from_case(geometry.UP, room)
    np.testing.assert_allclose(force[first, 1], expected[first], atol=1e-12)


@pytest.mark.parametrize("plan", NAMES[:-1])
def test_every_plan_makes_a_run_file_twice_the_same(plan: str):
    known = replace(Spec(plan, "none", 12.0, 4))
    make = record_cases.draw_record if plan[0] == "D" else draw_case
    first = make(known)
    again = make(known, json.loads(cases.sealed(first.key, "salt")[0]))
    assert first.text == again.text
    assert first.text.startswith("# calrig-run = 1\n")
    rows = [line for line in first.text.splitlines() if not line.startswith("#")]
    size = first.record.plan.size if plan[0] == "D" else first.world.plan.size
    assert len(rows) == size + 1


def test_the_hash_changes_with_the_key_and_with_the_salt():
    key = {"effects": {"bias_jump": {"size": 1.0}}}
    text, seal = cases.sealed(key, "a")
    assert json.loads(text)["effects"] == key["effects"]
    assert seal != cases.sealed(key, "b")[1]
    assert seal != cases.sealed({"effects": {}}, "a")[1]


def test_further_sweeps_measure_the_same_unit():
    case = draw_case(Spec("A8", "single", 20.0, 9, "second_order_nonlinearity"))
    plan: Plan = continued(case.world.plan, [("Z_from", [0.0, 90.0, 180.0, 270.0])])
    more = cases.continued(case, plan, np.random.default_rng(1))
    old = case.world.plan.size
    assert more.text.splitlines()[: len(case.text.splitlines())] == case.text.splitlines()
    errors = (more.readings.y / more.world.scale - play.truth(more.world, more.effects))[old:]
    levels = more.world.levels
    spread = np.hypot(levels.drift, levels.white) + 1.0 * np.hypot(
        levels.setting, levels.certificate
    )
    assert np.abs(errors).max() < 6.0 * spread


@pytest.mark.parametrize("name", [*long_record.SLOW, "pickup"])
def test_a_record_holds_its_effect_with_the_lambda_asked_for(name: str):
    case = record_cases.draw_record(Spec("D1h", "single", 15.0, 21, name))
    values = case.effects[name].size * long_record.form(name, case.effects[name].shape, case.record)
    if name == "pickup":
        sigma = case.record.levels.white * np.sqrt(case.record.plan.sample_rate)
        assert np.linalg.norm(values) / sigma == pytest.approx(15.0)
        return
    factor = long_record.whitener(case.record)
    seen = long_record.visible(case.record, factor, values)
    assert np.linalg.norm(seen) == pytest.approx(15.0)
    clean = long_record.measure(case.record, {}, np.random.default_rng(8))
    rest = long_record.visible(case.record, factor, clean[:, 2])
    blocks = len(rest)
    assert abs(rest @ rest - blocks) < 5.0 * np.sqrt(2.0 * blocks)


@pytest.mark.parametrize("name", long_record.FAULTS)
def test_faults_of_a_recording_are_in_the_file(name: str):
    case = record_cases.draw_record(Spec("D1h", "fault", 12.0, 3, name))
    t, temperature, y = case.table.T[:3]
    signs = {
        "dropouts": np.diff(t).max() > 1.5,
        "missing_codes": not np.any(np.rint(y / 2e-5) % 4 == 1),
        "stuck_reading": np.any(np.all(np.lib.stride_tricks.sliding_window_view(y, 8)
                                       == y[:-7, None], axis=1)),
        "outlier": np.abs(y - np.median(y)).max() > 8.0 * case.record.levels.white,
        "stale_temperature": np.ptp(temperature) == 0.0,
    }  # fmt: skip
    assert signs[name]
    clean = record_cases.draw_record(Spec("D1h", "none", 12.0, 3))
    assert np.ptp(clean.table[:, 1]) > 0.0
    assert np.diff(clean.table[:, 0]).max() < 1.5
