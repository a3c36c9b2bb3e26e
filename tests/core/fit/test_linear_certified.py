"""NIST StRD linear regression: estimates, standard deviations and residual deviation."""

import json
from pathlib import Path

import numpy as np
import pytest

from core.fit.linear import Rows, fit_sensor
from core.model.effect import Effect, Parameter, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.samples.run import Conditions

SETS = json.loads(
    (Path(__file__).parents[2] / "data" / "nist_strd" / "linear.json").read_text("utf-8")
)
# Correct digits of estimates and of standard deviations that double precision lets a good
# orthogonal solver keep: Filip's design has a condition of 5e9 with its columns at unit length,
# and Wampler5's residuals are 1e7 times its parameters.
DIGITS = {
    "Norris": (12, 13),
    "Pontius": (12, 13),
    "NoInt1": (14, 14),
    "NoInt2": (14, 14),
    "Filip": (6.5, 7),
    "Longley": (10, 11),
    "Wampler1": (9, 8.5),
    "Wampler2": (12.5, 13),
    "Wampler3": (8.5, 12.5),
    "Wampler4": (7, 12.5),
    "Wampler5": (5, 12.5),
}


class Columns(Effect):
    id = "columns"

    def __init__(self, design: np.ndarray) -> None:
        self._design = design

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        return tuple(Parameter(f"b{i}", f"b{i}", "") for i in range(self._design.shape[1]))

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> np.ndarray:
        return self._design


def digits(found: np.ndarray, certified: np.ndarray) -> float:
    """Correct digits of the worst number; Wampler's exact fits have deviations of zero."""
    error = np.abs(found - certified) / np.where(certified == 0, 1.0, np.abs(certified))
    return float(-np.log10(max(error.max(), 1e-16)))


@pytest.mark.parametrize("name", SETS)
def test_certified_values(name: str):
    data = SETS[name]
    if "columns" in data:
        design = np.array(data["columns"]).T
    else:
        design = np.array(data["x"])[:, None] ** np.array(data["powers"])
    n = len(design)
    model = SensorModel(Sensor("gyro", "z", ""), (Columns(design),))
    none = np.zeros((n, 3))
    stimulus = Stimulus(none, none, none, none)
    fit = fit_sensor(model, stimulus, Rows.of(np.array(data["y"])), Conditions())
    of_values, of_deviations = DIGITS[name]
    assert digits(fit.values, np.array(data["estimates"])) >= of_values
    assert digits(fit.stderr, np.array(data["standard_deviations"])) >= of_deviations
    assert digits(fit.sigma[:1], np.array([data["residual_standard_deviation"]])) >= of_deviations
    assert fit.dof == n - design.shape[1]
