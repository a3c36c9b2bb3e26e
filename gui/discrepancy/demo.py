"""Its part of the demonstration: a bent accelerometer is measured, and the bend is found."""

from pathlib import Path

from core.discrepancy.result import Step
from core.plans.plan import Plan
from core.plans.plan import Step as Position
from drivers.virtual.truth import Compared
from gui.discrepancy.tab import TITLE, DiscrepancyTab
from gui.measuring.demonstrating import Stage, Told, process, walk
from gui.measuring.tab import MeasuringTab

HEAD = "Dividing head"
EFFECT, ROLE, SIZE = "second_order_nonlinearity", "acc.x", 6.0
"""What is hidden in the simulated unit, and how much of it, mg/g^2."""
_SPEED = 30
_ANGLES = (0.0, 135.0, 45.0, 270.0, 90.0, 225.0, 180.0, 315.0)
_MOUNTS = ("X_from", "Y_from", "Z_from")
_EXPORTS = ("html", "pdf", "json", "model")


def play(stage: Stage) -> Told:
    """Measure a unit with a hidden effect, and climb the ladder until the gap is closed."""
    stage.connect("pointer", speed=_SPEED, effect=f"{ROLE}/{EFFECT}:{SIZE}")
    head = stage.show(HEAD)
    if not isinstance(head, MeasuringTab):
        raise TypeError(f"{HEAD} is a {type(head).__name__}")
    stage.until(lambda: head.sitting.walk.status is not None, "the rig did not answer")
    if not head.open_plan(mixed_twice()):
        raise RuntimeError("the plan was not taken")
    session = walk(stage, head)
    process(stage, head, "", ())
    stage.picture("model-vs-data-asked")
    head.view.results.explain.click()
    tab = stage.show(TITLE)
    if not isinstance(tab, DiscrepancyTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    presenter = tab.presenter
    stage.until(lambda: bool(presenter.state.proposals), "nothing was found")
    stage.until(lambda: not presenter.state.busy, "the search did not end")
    stage.picture("model-vs-data-found")
    for page, name in ((1, "next"), (2, "seen")):
        tab.view.findings.pages.setCurrentIndex(page)
        stage.picture(f"model-vs-data-{name}")
    tab.view.findings.pages.setCurrentIndex(0)
    presenter.act("all")
    presenter.act("play")
    stage.picture("model-vs-data-closed")
    for key in _EXPORTS:
        path = Path(tab.exporting.propose(key))
        tab.exporting.export(key, str(path))
        stage.until(path.exists, f"{path.name} was not written")
        stage.keep(path)
    story = presenter.story
    if story is None:
        raise RuntimeError("the story was closed")
    rows = tuple(_compared(story.run.device, s) for s in story.told.steps if s.effect == EFFECT)
    return Told(TITLE, rows, session)


def mixed_twice() -> Plan:
    """Three mountings, eight angles in mixed order, all twice; no angle follows itself."""
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
