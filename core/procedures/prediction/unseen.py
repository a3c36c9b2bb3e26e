"""What a plan cannot see, in words: parameters left free, weak ones, and errors that hide."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError, Note, Severity
from core.fit.quantiles import student_t
from core.model.effect import AXES
from core.model.stimulus import Stimulus
from core.plans.plan import Plan
from core.procedures.prediction.bench import Bench
from core.procedures.prediction.catalogue import METHODS
from core.procedures.prediction.design import Prediction, stimulus_of_plan

_SEEN = 1e-6
_WEAK = 3.0
_HEADINGS = "headings"


@dataclass(frozen=True, slots=True)
class _Hidden:
    """An error of the sensor or the rig that a plan may be blind to.

    Parameters
    ----------
    subject : of the note
    words : what the error is
    remedy : what would show it
    """

    subject: str
    words: str
    remedy: str


_SQUARE = _Hidden(
    "quadratic",
    "a response to the square of the input (K2)",
    "add positions between the upright ones, e.g. 45 degrees, or rates of half the size",
)
_CUBE = _Hidden(
    "cubic",
    "a response to the cube of the input (K3)",
    "add positions at 30 or 45 degrees, or rates of other sizes",
)
_PRODUCT = _Hidden(
    "product",
    "a response to the product of two inputs (k_xy)",
    "add positions at which both axes feel gravity, e.g. 45 degrees",
)


def unseen(method: str, plan: Plan, bench: Bench, prediction: Prediction) -> tuple[Note, ...]:
    """Tell what a plan would not show, the worst first.

    Parameters
    ----------
    method : key of `METHODS`
    plan, bench : what would be measured, and with what
    prediction : of this plan by this method
    """
    notes = [
        Note(
            Severity.WARNING,
            f"free_{name}",
            f"{name.replace('_', ' ')}: no position of this plan changes the input that shows it",
        )
        for name in prediction.free
    ]
    if prediction.dof == 0:
        notes.append(
            Note(
                Severity.WARNING,
                "no_check",
                "as many positions as unknowns: any reading fits, so a wrong one would not be"
                " noticed; add a position, or measure one again",
            )
        )
    elif prediction.dof < _WEAK:
        notes.append(
            Note(
                Severity.INFO,
                "weak_check",
                f"only {prediction.dof} reading(s) more than unknowns: where the scatter must be"
                f" found from the residuals, intervals are {student_t(0.95, prediction.dof):.2g}"
                " u wide instead of 2 u",
            )
        )
    notes += _hiding(plan, bench, METHODS[method].tests)
    if not plan.temperatures_c:
        notes.append(
            Note(
                Severity.INFO,
                "temperature",
                "one temperature: how bias and scale factor change with it stays unknown",
            )
        )
    if not _comes_back(plan):
        notes.append(
            Note(
                Severity.INFO,
                "drift",
                "no position comes twice: a drift while measuring passes for a property of the"
                " sensor; go back to the first position at the end",
            )
        )
    return tuple(notes)


def _hiding(plan: Plan, bench: Bench, tests: tuple[str, ...]) -> list[Note]:
    """Errors of the model that would look like something that is fitted."""
    if _HEADINGS in tests:
        return [
            Note(
                Severity.INFO,
                "tilt",
                "a base that leans east or west moves the heading by tan(latitude) of its tilt;"
                " measure the tilt by an accelerometer",
            )
        ]
    try:
        stimulus = stimulus_of_plan(plan, bench)
    except FitError:
        # Where the input is not known nothing can be said about what would hide in it.
        return []
    inputs = bench.sensor.input(stimulus)
    own = inputs[:, bench.sensor.index]
    linear = np.column_stack([np.ones(len(own)), inputs[:, _excited(inputs)]])
    size = float(np.abs(inputs).max()) or 1.0
    candidates = [(_SQUARE, own**2 / size), (_CUBE, own**3 / size**2)]
    if bench.kind == "accelerometer":
        candidates.append((_PRODUCT, _products(stimulus, bench) / size))
    notes: list[Note] = []
    for hidden, column in candidates:
        shown = _part_beside(linear, column)
        if shown < _SEEN * size:
            notes.append(
                Note(
                    Severity.INFO,
                    hidden.subject,
                    f"{hidden.words} hides in the other parameters; {hidden.remedy}",
                )
            )
    return notes


def _excited(inputs: FloatArray) -> list[int]:
    return [place for place in range(len(AXES)) if np.ptp(inputs[:, place]) > _SEEN]


def _products(stimulus: Stimulus, bench: Bench) -> FloatArray:
    """Product (n,) of the own input with the cross input that changes most."""
    own = bench.sensor.index
    others = [place for place in range(len(AXES)) if place != own]
    products = stimulus.a[:, others] * stimulus.a[:, [own]]
    most = int(np.argmax(np.ptp(products, axis=0)))
    return products[:, most]


def _part_beside(linear: FloatArray, column: FloatArray) -> float:
    """Root mean square of what the fitted model leaves of a column."""
    fitted = linear @ np.linalg.lstsq(linear, column, rcond=None)[0]
    return float(np.sqrt(np.mean((column - fitted) ** 2)))


def _comes_back(plan: Plan) -> bool:
    """Whether a position comes again, also as a full turn later."""
    places = [(step.mount, round(step.head_deg % 360.0, 6), step.rate_dps) for step in plan.steps]
    return len(set(places)) < len(places) or len(set(plan.temperatures_c)) < len(
        plan.temperatures_c
    )
