"""Every effect of the catalogue keeps the contract of `Effect`."""

import numpy as np
import pytest

from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Sensor
from core.model.stimulus import Stimulus

N = 7


def rich_stimulus() -> Stimulus:
    """Every column that an effect may ask for."""
    rng = np.random.default_rng(1)
    names = {name for effect in CATALOGUE.values() for name in effect.needs}
    a, w, da, dw = rng.normal(size=(4, N, 3))
    return Stimulus(a, w, da, dw, {name: rng.normal(size=N) for name in names})


@pytest.mark.parametrize("name", CATALOGUE)
def test_an_effect_describes_itself(name: str):
    effect = CATALOGUE[name]
    assert effect.id == name
    assert name.isidentifier()
    assert all((effect.name, effect.plain, effect.equation))


@pytest.mark.parametrize("name", CATALOGUE)
@pytest.mark.parametrize("kind", ["accelerometer", "gyro"])
@pytest.mark.parametrize("axis", AXES)
def test_an_effect_has_a_column_for_each_parameter(name: str, kind: str, axis: str):
    effect, sensor = CATALOGUE[name], Sensor(kind, axis, "code")
    parameters = effect.parameters(sensor)
    assert effect.columns(rich_stimulus(), sensor).shape == (N, len(parameters))
    assert len({parameter.name for parameter in parameters}) == len(parameters)
    assert all(parameter.unit for parameter in parameters)
