"""Turn-ons of the simulated gyro, at a low sampling rate."""

import numpy as np
import pytest

from core.procedures.drift.curves import Curves, curves_of
from core.procedures.drift.simulated import AMBIENTS, turn_on
from core.procedures.drift.turn_on import TurnOn

RATE = 50.0


def simulated(seed: int, count: int, ambients: np.ndarray = AMBIENTS, **how) -> list[TurnOn]:
    """`count` turn-ons of device 0 at each temperature."""
    rng = np.random.default_rng(seed)
    made = []
    for ambient in ambients:
        for number in range(count):
            y, chip = turn_on(rng, float(ambient), 0, rate=RATE, **how)
            made.append(TurnOn(f"{ambient:g} degC, {number + 1}", float(ambient), y, RATE, chip))
    return made


@pytest.fixture(scope="session")
def sharp() -> Curves:
    return curves_of(simulated(1, 5))


@pytest.fixture(scope="session")
def unseen() -> Curves:
    return curves_of(simulated(2, 3))


@pytest.fixture
def make_turn_ons():
    return simulated
