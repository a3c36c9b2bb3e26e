"""A design prepared once serves every sensor as well as one made for it."""

import numpy as np
import pytest

from core.errors import FitError, RankDeficient
from core.fit.design import Design, replicate_groups
from core.fit.linear import Rows, fit_design, fit_sensor
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.samples.run import Conditions

RATES = np.array([-50.0, -20, 0, 20, 50, 50])
W = np.column_stack([np.zeros((6, 2)), RATES])
NONE = np.zeros((6, 3))
STIMULUS = Stimulus(NONE, W, NONE, np.eye(3)[[2] * 6], {"set_rate_dps": RATES})
MODEL = SensorModel(Sensor("gyro", "z", "V"), (CATALOGUE["bias"], CATALOGUE["scale_factor"]))
MATRIX = np.column_stack([np.ones(6), RATES])


def test_equal_weights_are_ordinary_least_squares():
    design = Design.of(MODEL, STIMULUS)
    y = np.random.default_rng(1).normal(size=6)
    expected = np.linalg.lstsq(MATRIX, y, rcond=None)[0]
    assert np.allclose(design.inverse @ y, expected)
    assert np.allclose(design.solve(y, np.full(6, 7.0)).values, expected)
    lengths = np.linalg.norm(MATRIX, axis=0)
    assert design.condition == pytest.approx(np.linalg.cond(MATRIX / lengths))


def test_weights_are_inverse_variances():
    design = Design.of(MODEL, STIMULUS)
    y, variance = np.random.default_rng(2).normal(size=(2, 6)) ** 2 + 0.1
    root = np.sqrt(variance)
    expected = np.linalg.lstsq(MATRIX / root[:, None], y / root, rcond=None)[0]
    solution = design.solve(y, variance)
    assert np.allclose(solution.values, expected)
    assert np.allclose(solution.inverse @ y, expected)


@pytest.mark.parametrize("conditions", [Conditions(), Conditions(rate_u_dps=0.1)])
def test_a_shared_design_gives_what_each_sensor_alone_gives(conditions: Conditions):
    design = Design.of(MODEL, STIMULUS)
    rng = np.random.default_rng(3)
    for _ in range(3):
        rows = Rows.of(3.0 - 2.0 * RATES + rng.normal(0.0, 0.3, 6))
        shared = fit_design(design, rows, conditions)
        alone = fit_sensor(MODEL, STIMULUS, rows, conditions)
        assert np.array_equal(shared.values, alone.values)
        assert np.array_equal(shared.covariance, alone.covariance)
        assert np.array_equal(shared.t_dof, alone.t_dof)


def test_rows_of_the_same_input_are_one_group():
    assert list(Design.of(MODEL, STIMULUS).replicate) == [0, 1, 2, 3, 4, 4]
    near = np.array([[1.0, 100.0], [1.0, 100.0 + 1e-9], [1.0, 100.1], [1.0, 100.0]])
    assert list(replicate_groups(near)) == [0, 0, 1, 0]
    assert list(replicate_groups(np.array([[0.0, 0.0], [-0.0, 0.0]]))) == [0, 0]


def test_free_parameters_and_unknown_inputs_are_named():
    still = Stimulus(NONE, NONE, NONE, NONE)
    with pytest.raises(RankDeficient) as raised:
        Design.of(MODEL, still)
    assert raised.value.free == ("k_z",)
    with pytest.raises(FitError, match="k_z respond to"):
        Design.of(MODEL, Stimulus(NONE, W * np.nan, NONE, NONE))
