"""A small session: three accelerometers and a case thermometer on the dividing head."""

from collections.abc import Callable
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest

from core.plans.plan import load_plans
from core.records.session.start import SessionStart
from core.samples.accumulate import Accumulation, accumulation_of
from core.samples.block import Channel

CHANNELS = (
    Channel("N", "", "counter"),
    Channel("AX", "code", "acc.x"),
    Channel("AY", "code", "acc.y"),
    Channel("AZ", "code", "acc.z"),
    Channel("GX", "code", "rate.x"),
    Channel("T", "degC", "temp"),
    Channel("TAX", "code", "temp.acc.x"),
)


@pytest.fixture
def start() -> SessionStart:
    return SessionStart(
        device="PW09",
        sensor="accelerometer",
        channels=CHANNELS,
        rate=100.0,
        plan=load_plans()["pointer_8"],
        started="2024-05-14T09:30:05+03:00",
        profile="pw09_raw",
        profile_text="[device]\nname = 'PW09'\n",
        operator="Олена",
        settings={"hands_free": True, "sound": "on", "volume": 0.5},
        legacy="pointer",
    )


@pytest.fixture
def means() -> Callable[[float], Accumulation]:
    """An accumulation whose x output is close to a number."""

    def make(level: float) -> Accumulation:
        rng = np.random.default_rng(int(level))
        data = rng.normal(0.0, 0.5, (200, len(CHANNELS)))
        data += [0.0, level, -10.0, 12866.0, -517.0, 26.1, 7963.0]
        return accumulation_of(CHANNELS, np.arange(200) / 100.0, data)

    return make


@pytest.fixture
def clock() -> Callable[[], datetime]:
    """Time that goes on by ten seconds whenever it is asked for."""
    moment = datetime(2024, 5, 14, 6, 30, 5, tzinfo=UTC)

    def tick() -> datetime:
        nonlocal moment
        moment += timedelta(seconds=10)
        return moment

    return tick
