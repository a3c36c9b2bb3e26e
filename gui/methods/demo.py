"""The part of the tab Methods in the demonstration: choose a plan, measure it, look at the turn."""

from dataclasses import replace

from core.procedures.prediction.bench import HEAD
from gui.advisor.page import AdvisorPage
from gui.dividing_head.tab import HeadTab
from gui.gyrocompass.page import CompassPage
from gui.measuring.demonstrating import Stage, Told, walk
from gui.methods.tab import MethodsTab
from gui.tumble.page import TumblePage

TITLE = "Methods"
_HEAD = "Dividing head"
_EVERY = 4
"""Of the 80 angles of the plan so many become one, so that the demonstration stays short."""
_ACCUMULATION_S = 4.0
_GYRO_NOISE = (2e-5, 1e-6, 5e-8)
"""N, B, K in deg/sqrt(s), deg/s, deg/s/sqrt(s): a gyro that finds north to 0.1 degree in 10 s."""


def play(stage: Stage) -> Told:
    """Thin a tumble out where it costs little, measure it, and show what the turn tells."""
    stage.connect("pointer")
    tab = stage.show(TITLE)
    if not isinstance(tab, MethodsTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    _choose(stage, tab)
    head = stage.show(_HEAD)
    if not isinstance(head, HeadTab):
        raise TypeError(f"{_HEAD} is a {type(head).__name__}")
    session = walk(stage, head)
    stage.show(TITLE)
    tab.open("tumble")
    tumble = tab.pages["tumble"]
    if not isinstance(tumble, TumblePage):
        raise TypeError("the page of the tumble is another one")
    tumble.presenter.load_newest()
    stage.until(lambda: tumble.presenter.study is not None, "the tumble was not evaluated")
    stage.picture("methods-tumble")
    tab.open("gyrocompass")
    compass = tab.pages["gyrocompass"]
    if not isinstance(compass, CompassPage):
        raise TypeError("the page of the gyrocompass is another one")
    compass.presenter.set_noise(_GYRO_NOISE)
    stage.until(lambda: compass.presenter.found.advice is not None, "no advice was given")
    stage.picture("methods-gyrocompass")
    return Told(TITLE, (), session)


def _choose(stage: Stage, tab: MethodsTab) -> None:
    """Ask which procedure, tick steps off, and open the plan in the tab that measures it."""
    tab.open("advisor")
    page = tab.pages["advisor"]
    if not isinstance(page, AdvisorPage):
        raise TypeError("the page of the procedures is another one")
    presenter = page.presenter
    presenter.decide(
        replace(
            presenter.choices, axis="x", tools=frozenset({HEAD}), accumulation_s=_ACCUMULATION_S
        )
    )
    stage.until(lambda: len(presenter.state.proposals) > 1, "nothing was proposed")
    presenter.choose("tumble", "fourier_400")
    stage.until(lambda: presenter.advised.choices.plan_id == "fourier_400", "it was not chosen")
    for step in presenter.state.steps:
        if step.number % _EVERY:
            presenter.keep(step.number, False)
    stage.until(
        lambda: presenter.advised.choices == presenter.choices and bool(presenter.choices.dropped),
        "the plan was not predicted",
    )
    stage.picture("methods-which-procedure")
    presenter.open_plan()
