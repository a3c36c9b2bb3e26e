"""What is the same in every tab: tour, preferences, keys, a doubt, the view from three metres."""

from dataclasses import replace

from PySide6.QtWidgets import QDockWidget

from core.plans.plan import Step
from core.procedures.measuring import Phase
from drivers.virtual.rig import Rig
from gui.demonstration.stage import WindowStage
from gui.dividing_head.tab import HeadTab
from gui.measuring.demonstrating import Told
from gui.measuring.site import Site

TITLE = "Dividing head"
_SITE = Site("O. Petrenko", 9.8106, 0.0005, 50.45)
_CALLOUT = 3
"""The step of the tour that is shown, from 1: what to do now."""
_BEFORE = 3
"""So many positions are measured before something goes wrong."""
_LONG_S = 400.0
"""Long enough to be looked at in both looks."""
_UNDERWAY_S = 60.0
_REST_S = 1.0


def play(stage: WindowStage) -> Told:
    """Open what waits beside the tabs, stand wrong once, lose the link once, look from afar."""
    rig = stage.connect("pointer")
    tab = stage.show(TITLE)
    if not isinstance(tab, HeadTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    stage.until(lambda: tab.sitting.walk.status is not None, "the rig did not answer")
    stage.rest(_REST_S)
    _show_adc(stage)
    _open_what_waits(stage)
    _measure(stage, tab, _BEFORE)
    _stand_wrong(stage, tab, rig)
    _look_from_afar(stage, tab, rig)
    _lose_the_link(stage, tab, rig)
    return Told(TITLE, (), stage.sessions)


def _open_what_waits(stage: WindowStage) -> None:
    """Tour, Device Properties, Preferences, keys."""
    window, guidance = stage.application.window, stage.application.guidance
    guidance.tour.start()
    for _ in range(_CALLOUT - 1):
        guidance.tour.callout.next.click()
    stage.picture("tour")
    guidance.tour.leave()
    window.toggle_devices()
    stage.rest(_REST_S)
    stage.picture("device-properties")
    window.toggle_devices()
    guidance.preferences.set_site(_SITE)
    window.toggle_preferences()
    stage.picture("preferences")
    window.toggle_preferences()
    guidance.keys.open()
    stage.picture_of(guidance.keys.view, "keys")
    guidance.keys.view.hide()


def _measure(stage: WindowStage, tab: HeadTab, positions: int) -> None:
    """Have so many positions measured by the operator of the rig."""
    tab.presenter.set_hands_free(True)
    stage.set_operator(True)
    stage.until(lambda: len(tab.sitting.keeper.positions) >= positions, "nothing was measured")
    stage.set_operator(False)
    tab.presenter.set_hands_free(False)
    # What has begun comes to its end: a turn of the operator, an accumulation.
    stage.rest(_REST_S)
    stage.until(lambda: not tab.sitting.walk.measuring, "the accumulation did not end")


def _stand_wrong(stage: WindowStage, tab: HeadTab, rig: Rig) -> None:
    """Accumulate where the plan wants the unit to stand elsewhere."""
    _stand(stage, rig, tab.sitting.plan.steps[0])
    tab.presenter.act("accumulate")
    stage.until(lambda: tab.taking.pending is not None, "the wrong position was not doubted")
    stage.picture("wrong-position")
    tab.taking.drop()


def _look_from_afar(stage: WindowStage, tab: HeadTab, rig: Rig) -> None:
    """The distance view in the middle of an accumulation."""
    settings = tab.sitting.settings
    distance = stage.application.guidance.distance
    status = tab.sitting.walk.status
    if status is None or status.step is None:
        raise RuntimeError("the plan is finished")
    _stand(stage, rig, status.step)
    tab.presenter.set_settings(replace(settings, accumulation_s=_LONG_S))
    tab.presenter.act("accumulate")
    begun = rig.state.time_s
    stage.until(lambda: rig.state.time_s > begun + _UNDERWAY_S, "the rig stands still")
    distance.enter()
    # A screen of its own size would make a picture of its own size.
    stage.application.window.showNormal()
    stage.picture("distance-view")
    distance.leave()
    tab.presenter.act("stop")
    tab.presenter.set_settings(settings)


def _lose_the_link(stage: WindowStage, tab: HeadTab, rig: Rig) -> None:
    """Pull the plug in the middle of an accumulation."""
    tab.presenter.act("accumulate")
    stage.until(lambda: _phase(tab) is Phase.MEASURING, "no accumulation began")
    rig.unplug()
    stage.until(lambda: not tab.bench.linked, "nobody saw the plug")
    stage.rest(_REST_S)
    stage.picture("link-lost")


def _show_adc(stage: WindowStage) -> None:
    """View ADC Data below the tab."""
    dock = stage.application.window.findChild(QDockWidget, "adc")
    if dock is None:
        raise RuntimeError("the window has no place for ADC data")
    dock.show()
    stage.rest(_REST_S)
    stage.picture("adc-data")
    dock.hide()


def _stand(stage: WindowStage, rig: Rig, step: Step) -> None:
    """Turn the rig to a step of the plan."""
    rig.remount(step.mount)
    rig.turn(step.head_deg)
    stage.rest(_REST_S)


def _phase(tab: HeadTab) -> Phase | None:
    status = tab.sitting.walk.status
    return None if status is None else status.phase
