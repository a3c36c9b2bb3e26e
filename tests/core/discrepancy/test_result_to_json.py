"""The document of an explanation: keys of the format, no NaN, nothing lost."""

import json
import math

import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.discrepancy.result import VERDICTS, Explanation, Fitted, Gap, NoiseFloor, Step
from core.discrepancy.to_json import explanation_to_json
from core.errors import Note, Severity

N = 4
NO_CURVE = frozen(np.zeros(N))


def gap(value: float) -> Gap:
    return Gap(rms=2.0 * value, gap=value, chi2_red=value**2, dof=9, p_value=0.1, lack_p=math.nan)


def story(before: float = 3.0, after: float = 1.0) -> Explanation:
    step = Step(
        effect="run_bias",
        name="Run-to-run bias",
        plain="the zero is another one in each run",
        equation="b_r",
        seen_as="steps between runs",
        remedy="leave it powered",
        parameters=(Fitted("bias_run_2", 0.5, 0.1, "mg"),),
        probability=0.9,
        p_value=0.003,
        evidence=12.0,
        indistinguishable_from=("bias_drift",),
        after=gap(after),
        held_out_gap_after=1.2,
        advice="repeat the first run",
        curve=NO_CURVE,
        candidates=(),
    )
    return Explanation(
        verdict="ambiguous",
        summary="",
        noise=NoiseFloor(0.1, "V", {"white": 0.1}, {"white": 1.0}, "replicates", 8),
        before=gap(before),
        after=gap(after),
        held_out_before=math.nan,
        where=(),
        where_after=(),
        steps=(step,),
        candidates=(),
        threshold=2.5,
        next_measurements=(),
        smallest=(),
        invisible=("third_order_nonlinearity",),
        untested={"bias_temperature": "temperature_c"},
        notes=(Note(Severity.INFO, "subject", "text"),),
        measured=NO_CURVE,
        predicted_before=NO_CURVE,
        predicted=NO_CURVE,
        sigma=NO_CURVE,
        channel=frozen_int(np.zeros(N)),
        channels=("y",),
        unit="V",
    )


def test_the_document_has_the_keys_of_the_format_and_is_json():
    document = json.loads(json.dumps(explanation_to_json(story()), allow_nan=False))
    assert document["verdict"] in VERDICTS
    assert {"sigma", "components", "source"} <= set(document["noise"])
    assert {"rms", "gap", "chi2_red", "dof", "p_value"} <= set(document["before"])
    (step,) = document["steps"]
    assert step["effect"] == "run_bias"
    assert step["parameters"] == [{"name": "bias_run_2", "value": 0.5, "u": 0.1, "unit": "mg"}]
    assert step["indistinguishable_from"] == ["bias_drift"]
    assert step["gap_after"] == 1.0
    assert document["before"]["lack_of_fit_p_value"] is None
    assert document["before"]["held_out_gap"] is None
    assert document["invisible"] == ["third_order_nonlinearity"]
    assert document["notes"] == [{"severity": "info", "subject": "subject", "text": "text"}]


@pytest.mark.parametrize(("after", "closed"), [(1.0, 1.0), (2.0, 0.5), (3.0, 0.0)])
def test_the_closure_is_the_part_of_the_gap_above_the_floor_that_went(after: float, closed: float):
    assert story(after=after).closure == pytest.approx(closed)
    assert math.isnan(story(before=0.9).closure)
