"""The dividing head's part of the demonstration: eight positions, their calibration, exports."""

from drivers.virtual.truth import compare
from gui.dividing_head.tab import HeadTab
from gui.measuring.demonstrating import Stage, Told, process, walk

TITLE = "Dividing head"


def play(stage: Stage, device: str = "pointer") -> Told:
    """Measure a triad or an assembly, calibrate it, and compare with the rig's truth."""
    rig = stage.connect(device)
    tab = stage.show(TITLE)
    if not isinstance(tab, HeadTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    stage.until(lambda: tab.sitting.walk.status is not None, "the rig did not answer")
    stage.picture("dividing-head-connected")
    session = walk(stage, tab, "dividing-head-measuring")
    process(stage, tab, "dividing-head-results", ("json", "c", "mat", "csv"))
    state = tab.results.state
    if state is None:
        raise RuntimeError("the results were closed")
    return Told(TITLE, compare(state.calibration, rig), session)
