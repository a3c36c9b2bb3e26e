"""Its part of the demonstration: a bent accelerometer is measured, and the bend is found."""

import time
from datetime import datetime
from pathlib import Path

from core.discrepancy.result import Step
from core.plans.plan import Plan
from core.plans.plan import Step as Position
from core.records.names import stamp
from core.samples.run import Conditions
from drivers.virtual.session import Order, simulate_session
from drivers.virtual.truth import Compared
from gui.discrepancy.tab import TITLE, DiscrepancyTab
from gui.measuring.bending import BendingResults
from gui.measuring.demonstrating import Stage, Told
from gui.measuring.tab import MeasuringTab

HEAD = "Dividing head"
EFFECT, ROLE, SIZE = "second_order_nonlinearity", "acc.z", 4.0
"""What is hidden in the simulated unit, and how much of it, mg/g^2."""
_STATED = Conditions(g_mps2=9.8106, head_u_arcsec=5.0)
_ANGLES = (0.0, 135.0, 45.0, 270.0, 90.0, 225.0, 180.0, 315.0)
_MOUNTS = ("X_from", "Y_from")
_EXPORTS = ("pdf", "model")


def play(stage: Stage) -> Told:
    """Measure a unit with a hidden effect, and climb the ladder until the gap is closed."""
    hidden = f"{ROLE}/{EFFECT}:{SIZE}"
    # The window stands beside a rig that sends slowly; the session is measured as fast as it goes.
    stage.connect("pointer", speed=1, effect=hidden)
    url = f"sim://pointer?speed=max&seed=3&name=bent{time.time_ns()}&effect={hidden}"
    session = stage.sessions / f"{stamp(datetime.now())}_PW09_bent"
    simulate_session(Order(url, mixed_twice(), "accelerometer", _STATED), session)
    head = stage.show(HEAD)
    if not isinstance(head, MeasuringTab):
        raise TypeError(f"{HEAD} is a {type(head).__name__}")
    head.load(session)
    stage.until(lambda: head.results.page is not None, "the session was not calibrated")
    head.view.results.explain.click()
    tab = stage.show(TITLE)
    if not isinstance(tab, DiscrepancyTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    presenter, findings = tab.presenter, tab.view.findings
    stage.until(lambda: bool(presenter.state.proposals), "nothing was found")
    stage.until(lambda: not presenter.state.busy, "the search did not end")
    stage.picture("model-vs-data-found")
    findings.pages.setCurrentIndex(1)
    stage.picture("model-vs-data-next")
    findings.pages.setCurrentIndex(0)
    presenter.choose(EFFECT)
    presenter.act("add")
    stage.until(lambda: not presenter.state.busy, "the effect was not added")
    presenter.act("play")
    stage.until(lambda: presenter.state.again, "the rig did not walk the rows")
    stage.picture("model-vs-data-closed")
    for key in _EXPORTS:
        path = Path(tab.exporting.propose(key))
        tab.exporting.export(key, str(path))
        stage.until(path.exists, f"{path.name} was not written")
        stage.keep(path)
    presenter.act("calibrate")
    results = head.results
    if not isinstance(results, BendingResults):
        raise TypeError(f"{HEAD} takes no effects")
    stage.until(
        lambda: not results.busy and results.page is not None and bool(results.page.effects),
        "the calibration did not take the effect",
    )
    story = presenter.story
    if story is None:
        raise RuntimeError("the story was closed")
    rows = tuple(_compared(story.run.device, s) for s in story.told.steps if s.effect == EFFECT)
    return Told(TITLE, rows, session)


def mixed_twice() -> Plan:
    """Two mountings, eight angles in mixed order, all twice; no angle follows itself."""
    again = (*_ANGLES[3:], *_ANGLES[:3])
    places = [(mount, angle) for mount in _MOUNTS for angle in (*_ANGLES, *again)]
    return Plan(
        id="mixed_twice",
        title="Mixed angles, twice",
        test="dividing_head",
        source="model vs data",
        accumulation_s=2.0,
        settle_s=3.0,
        temperatures_c=(),
        steps=tuple(
            Position(number, mount.replace("_", " "), mount, angle)
            for number, (mount, angle) in enumerate(places, 1)
        ),
    )


def _compared(device: str, step: Step) -> Compared:
    """The estimate beside the hidden truth."""
    number = step.parameters[0]
    half = 1.96 * number.u
    held = abs(number.value - SIZE) <= half
    return Compared(device, "K2", number.unit, number.value, half, SIZE, held)
