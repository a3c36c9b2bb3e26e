"""The presenters of the dividing-head tab on a fed connection, without a window."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from gui.dividing_head.guide import HeadGuide
from gui.dividing_head.results import HeadResults
from gui.dividing_head.settings import HeadSettings
from tests.gui.desk import Desk, desks
from tests.gui.fake_bench import FakeConnection


@pytest.fixture
def make_desk(qapp: object, tmp_path: Path) -> Iterator[Callable[..., Desk]]:
    """Build a desk; a second one on the same folder is the next start of the program."""
    with desks(tmp_path) as build:

        def make(profile_id: str = "pw09_raw", plan_id: str = "pointer_8") -> Desk:
            connection = FakeConnection(profile_id)
            settings = HeadSettings(plan_id=plan_id, accumulation_s=1.0, settle_s=0.2)
            desk = build(HeadGuide(), connection, connection.stand, settings, HeadResults)
            connection.plug("0917" if profile_id == "adc_board9" else "PW09")
            connection.stand(desk.sitting.plan.steps[0], 0.2)
            return desk

        yield make


@pytest.fixture
def desk(make_desk: Callable[..., Desk]) -> Desk:
    """The attitude unit, eight positions of a second each."""
    return make_desk()
