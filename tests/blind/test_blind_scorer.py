"""The scorer: what an engine that knows gets, what one that guesses gets, and every score alone."""

import json
import math
from pathlib import Path
from typing import Any

import pytest

from tests.blind import report, runner, scoring
from tests.blind.cases import Spec, draw_case
from tests.blind.grid import cell, quick, specs
from tests.blind.peers import oracle
from tests.blind.shares import at_most, most_allowed, wilson

ORACLE, STEPWISE = "tests.blind.peers:oracle", "tests.blind.peers:stepwise"


def small() -> dict[str, list[Spec]]:
    names = ("second_order_nonlinearity", "bias_jump", "head_eccentricity", "settling_lag")
    return {
        "clean": [*cell("A104", "none", 20), *cell("B84", "none", 20)],
        "single": [s for name in names for s in cell("A80", "single", 2, name)],
        "double": cell("A80", "double", 3),
        "outside": cell("A80", "outside", 3, "notch", 20.0),
        "fault": cell("B84r", "fault", 3, "positions_swapped"),
        "advice": cell("A8", "single", 2, "second_order_nonlinearity"),
    }


@pytest.fixture(scope="module")
def told() -> list[dict]:
    return runner.run(small(), ORACLE)


def test_an_engine_that_was_told_misses_nothing(told: list[dict]):
    for row in told:
        assert not row["sure_wrong"]
        assert row["alarm"] == (row["group"] != "clean")
        assert row.get("covered", True)
        assert row.get("equivalent", True)
        assert row.get("unique_advice", True)
        if math.isfinite(row.get("closure", math.nan)):
            assert row["closure"] == pytest.approx(1.0)
    assert [line for line in report.table(told, told) if line.endswith("MISSED")] == []


def test_forward_stepwise_regression_accuses_the_innocent():
    guessed = runner.run({"clean": small()["clean"]}, STEPWISE)
    alarms = sum(row["alarm"] for row in guessed)
    # The share is known to be 0.5 to 1; a true 0.5 falls below 10 of 40 in one of 2000 runs.
    assert at_most(9, 40, 0.5) < 5e-4
    assert alarms >= 10
    lines = report.table(guessed, guessed)
    assert lines[1].startswith("clean: any alarm")
    assert lines[1].endswith("MISSED")


def step(effect: str, *others: str, probability: float = 0.95, **more: object) -> dict:
    return {
        "effect": effect,
        "probability": probability,
        "indistinguishable_from": list(others),
        **more,
    }


def key(*names: str, equals: tuple[str, ...] = (), kind: str = "single") -> dict:
    hidden = {n: {"size": 2e-4, "shape": {"channel": 0}, "equals": list(equals)} for n in names}
    return {
        "spec": {"kind": kind, "lam": 12.0},
        "test": "dividing_head",
        "unit": "code",
        "scale": [13000.0],
        "effects": hidden,
        "before_rms": 2.0,
        "oracle_rms": 1.0,
    }


def answer(*steps: dict, verdict: str = "explained", before: float = 2.0, after: float = 1.0):
    return {
        "verdict": verdict,
        "steps": list(steps),
        "before": {"rms": before},
        "after": {"rms": after},
    }


def test_exact_means_this_name_and_nothing_else():
    hidden = key("bias_jump")
    exact = scoring.score(hidden, answer(step("bias_jump")))
    assert exact["first"]
    assert exact["unique"]
    assert exact["covered"]
    tied = scoring.score(hidden, answer(step("bias_jump", "run_bias")))
    assert tied["first"]
    assert not tied["unique"]
    more = scoring.score(hidden, answer(step("bias_jump"), step("outlier")))
    assert not more["first"]
    assert more["sure_wrong"] == ["outlier"]
    other = scoring.score(hidden, answer(step("run_bias", "bias_jump")))
    assert not other["first"]
    assert other["covered"]
    assert not other["sure_wrong"]


def test_an_equal_is_no_confident_error_and_a_doubt_is_none_either():
    hidden = key("bias_jump", equals=("run_bias",))
    assert scoring.score(hidden, answer(step("run_bias")))["sure_wrong"] == []
    assert scoring.score(hidden, answer(step("pickup", probability=0.6)))["sure_wrong"] == []
    assert scoring.score(hidden, answer(step("pickup")))["sure_wrong"] == ["pickup"]


def test_each_hidden_effect_needs_a_step_of_its_own():
    hidden = key("bias_jump", "outlier", kind="double")
    one = scoring.score(hidden, answer(step("bias_jump", "outlier")))
    assert not one["covered"]
    assert one["recall"] == 0.5
    both = answer(step("pickup", "bias_jump", "outlier"), step("wrong_angle", "bias_jump"))
    assert scoring.score(hidden, both)["covered"]


def test_clean_data_alarm_by_steps_or_by_verdict():
    clean = key(kind="none")
    assert not scoring.score(clean, answer(verdict="adequate"))["alarm"]
    assert not scoring.score(clean, answer(verdict="not_enough_data"))["alarm"]
    assert scoring.score(clean, answer(verdict="excess_noise"))["alarm"]
    assert scoring.score(clean, answer(step("outlier")))["alarm"]
    coloured = key(kind="coloured")
    assert not scoring.score(coloured, answer(verdict="excess_noise"))["alarm"]


def test_outside_the_catalogue_any_sure_name_is_wrong():
    foreign = key("notch", kind="outside")
    said = scoring.score(foreign, answer(step("unexplained_structure")))
    assert said["said_unknown"]
    assert not said["sure_wrong"]
    sure = scoring.score(foreign, answer(step("third_order_nonlinearity")))
    assert not sure["said_unknown"]
    assert sure["sure_wrong"]


@pytest.mark.parametrize(
    ("unit", "value", "u"),
    [("mg", 0.21, 0.01), ("mg/g^2", 0.21, 0.01), ("µg", 210.0, 10.0), ("code", 2.73, 0.13)],
)
def test_parameters_are_compared_in_any_unit(unit: str, value: float, u: float):
    fitted = {"name": "size", "unit": unit, "value": -value, "u": u}
    row = scoring.score(key("bias_jump"), answer(step("bias_jump", parameters=[fitted])))
    assert row["z"] == pytest.approx(1.0, abs=1e-6)


def test_a_number_of_a_record_is_compared_in_units_of_its_output():
    fitted = {"name": "b_H", "value": -3.2e-4, "u": 1e-5, "unit": "V"}
    told: dict[str, Any] = key("thermal_hysteresis") | {"test": "record"}
    told["effects"]["thermal_hysteresis"] |= {"size": 1e-3, "shape": {"width": 0.3}}
    row = scoring.score(told, answer(step("thermal_hysteresis", parameters=[fitted])))
    assert row["z"] == pytest.approx(2.0)


def test_closure_takes_the_oracle_as_the_floor():
    row = scoring.score(key("bias_jump"), answer(step("bias_jump"), before=20.0, after=12.0))
    assert row["closure"] == pytest.approx(0.8)


def test_a_key_that_was_touched_after_sealing_is_refused(tmp_path: Path):
    spec = Spec("A24", "none", 12.0, 5)
    made = runner.seal((spec, str(tmp_path)))
    assert made is not None
    seal_hash = made[1]
    job = (spec, seal_hash, str(tmp_path), ORACLE, "clean")
    runner.answer(job)
    path = tmp_path / f"{runner.file_name(spec)}.key.json"
    opened = json.loads(path.read_text("utf-8"))
    path.write_text(json.dumps({**opened, "effects": {"outlier": {}}}), "utf-8")
    with pytest.raises(ValueError, match="not the one that was sealed"):
        runner.answer(job)


def test_shares():
    # Wilson's interval of 8 out of 10, Brown, Cai and DasGupta 2001.
    assert wilson(8, 10) == pytest.approx((0.490, 0.943), abs=1e-3)
    assert at_most(1, 2, 0.5) == pytest.approx(0.75)
    # scipy.stats.binom.sf(9, 100, 0.03) = 8.7e-4, binom.sf(8, 100, 0.03) = 3.2e-3
    assert most_allowed(100, 0.03, 1e-3) == 9


def test_the_full_grid_has_every_kind_and_no_case_twice():
    groups = specs()
    assert {"clean", "coloured", "single", "double", "triple", "outside", "fault", "advice"} <= set(
        groups
    )
    every = [(group, spec) for group, some in groups.items() for spec in some]
    assert len({(s.plan, s.kind, s.lam, s.seed) for _, s in every}) >= len(every) - len(
        groups["advice"]
    )
    for some in quick(7).values():
        assert len(some) <= 7


def test_another_lot_shares_no_case_with_the_usual_one():
    usual, other = quick(5), quick(5, lot=7, plans=("A80", "B84r"))
    seen = {(s.plan, s.seed) for some in specs().values() for s in some}
    assert not any((s.plan, s.seed) in seen for some in other.values() for s in some)
    assert {s.plan for some in other.values() for s in some} == {"A80", "B84r"}
    assert quick(5, lot=0) == usual


def test_the_oracle_reads_the_key_beside_the_run(tmp_path: Path):
    spec = Spec("A80", "single", 12.0, 2, "bias_jump")
    runner.seal((spec, str(tmp_path)))
    given = oracle(tmp_path / f"{runner.file_name(spec)}.run.csv")
    assert [s["effect"] for s in given["steps"]] == ["bias_jump"]
    assert draw_case(spec).key["effects"]["bias_jump"]["lambda"] == pytest.approx(12.0, rel=2e-3)
