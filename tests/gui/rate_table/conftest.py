"""The rate-table tab's presenters on a fed connection, without a window."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.plans.plan import Step
from core.samples.block import SampleBlock
from gui.rate_table.guide import RateGuide, rates_of
from gui.rate_table.results import RateResults
from gui.rate_table.settings import RateSettings
from tests.gui.desk import Desk, desks
from tests.gui.fake_bench import BIAS, RATE, FakeConnection, G, K

SLOPE, ZERO = -79.378668, -438.08
B = np.array([0.4, 1.17, -0.5])
"""g-sensitivity, code/(m/s^2)."""


class TableConnection(FakeConnection):
    """Nine gyros along Z, or a triad with accelerometers, at the rate that a step asks for."""

    def __init__(self, profile_id: str) -> None:
        super().__init__(profile_id)
        self.on_head = False
        self.limit = np.inf
        self.noise = 2.0

    def turn(self, step: Step, seconds: float = 1.2, *, to_dps: float | None = None) -> None:
        """Send samples of a table that turns as the step asks, or slides to another rate."""
        blocks = round(seconds * RATE / 10)
        last = step.rate_dps if to_dps is None else to_dps
        for rate in np.linspace(step.rate_dps, last, blocks):
            self._block(replace(step, rate_dps=float(rate)), 0.0)

    def _block(self, step: Step, turn_dps: float) -> None:
        index = np.arange(self._next, self._next + 10)
        self._next += 10
        roles = [channel.role for channel in self.channels]
        data = np.zeros((10, len(roles)))
        force = np.array([0.0, 0.0, G])
        rates = rates_of(step)
        if self.on_head:
            force, rates = step.specific_force(G), np.array([turn_dps, turn_dps, turn_dps])
        own = {"x": 0, "y": 1, "z": 2}
        for place, role in enumerate(roles):
            which = role.rpartition(".")[2]
            if role.startswith("adc.") or role == f"rate.{which}":
                axis = own.get(which, 2)
                data[:, place] = SLOPE * rates[axis] + ZERO + B @ force
            elif role == f"acc.{which}":
                data[:, place] = (K @ force + BIAS)[own[which]]
        data += self._rng.normal(0.0, self.noise, data.shape)
        data = np.clip(np.rint(data), -self.limit, self.limit)
        self.blocks.emit(SampleBlock(self.channels, frozen_int(index), frozen(data), RATE))


@pytest.fixture
def make_rate_desk(qapp: object, tmp_path: Path) -> Iterator[Callable[..., Desk]]:
    """Build a desk; a second one on the same folder is the next start of the program."""
    with desks(tmp_path) as build:

        def make(profile_id: str = "adxrs_board9", plan_id: str = "rate_table_100") -> Desk:
            connection = TableConnection(profile_id)
            settings = RateSettings(
                plan_id=plan_id, accumulation_s=1.0, settle_s=0.2, whole_turns=False
            )
            desk = build(RateGuide(), connection, connection.turn, settings, RateResults)
            connection.plug("Gyro31")
            connection.turn(replace(desk.sitting.plan.steps[0], rate_dps=0.0), 0.5)
            return desk

        yield make


@pytest.fixture
def rate_desk(make_rate_desk: Callable[..., Desk]) -> Desk:
    """Nine gyros, eleven rates of a second each."""
    return make_rate_desk()
