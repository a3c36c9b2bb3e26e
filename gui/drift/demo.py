"""The Drift tab's part of the demonstration: simulated turn-ons, a dragged knot, the C header."""

from pathlib import Path

from gui.drift.tab import DriftTab
from gui.measuring.demonstrating import Stage, Told

TITLE = "Drift"
_TEMPERATURE, _KNOT = 7, 5
_AWAY_S = 3.0


def play(stage: Stage) -> Told:
    """Make the table of the simulated gyro, drag a knot, put it back, export."""
    tab = stage.show(TITLE)
    if not isinstance(tab, DriftTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    presenter = tab.presenter
    presenter.simulate()
    stage.until(lambda: tab.library.result is not None, "no table was made")
    stage.picture("drift-all")
    presenter.show(_TEMPERATURE)
    knots = presenter.knots
    if knots is None:
        raise RuntimeError("the table was closed")
    presenter.drag(_KNOT, float(knots.table.times_s[_KNOT]) - _AWAY_S)
    stage.picture("drift-dragged")
    presenter.drop()
    presenter.reset()
    path = Path()
    for key in ("c", "json"):
        path = Path(tab.exporting.propose(key))
        tab.exporting.export(key, str(path))
        stage.until(path.exists, f"{path.name} was not written")
        stage.keep(path)
    return Told(TITLE, (), path.parent)
