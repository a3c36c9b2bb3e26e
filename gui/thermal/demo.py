"""The Thermal tab's part of the demonstration: the simulated cycle, its truth, the exports."""

from collections.abc import Iterator
from pathlib import Path

from core.fit.estimate import parameter
from core.procedures.thermal.cycle import ThermalCalibration
from core.procedures.thermal.simulated import REFERENCE_C, SCALE
from drivers.virtual.truth import Compared
from gui.measuring.demonstrating import Stage, Told
from gui.thermal.pictures import BIAS, TILT
from gui.thermal.tab import ThermalTab
from gui.thermal.working import CycleOutcome

TITLE = "Thermal"


def play(stage: Stage) -> Told:
    """Process the simulated cycle and export what compensates it."""
    tab = stage.show(TITLE)
    if not isinstance(tab, ThermalTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    tab.presenter.simulate()
    stage.until(lambda: tab.library.result is not None, "the cycle was not processed")
    for quantity, name in ((BIAS, "thermal-bias"), (TILT, "thermal-tilt")):
        tab.presenter.show(quantity)
        stage.picture(name)
    path = Path()
    for key in ("json", "c", "csv"):
        path = Path(tab.exporting.propose(key))
        tab.exporting.export(key, str(path))
        stage.until(path.exists, f"{path.name} was not written")
        stage.keep(path)
    outcome = tab.library.result
    if not isinstance(outcome, CycleOutcome) or outcome.thermal is None:
        raise RuntimeError("the cycle was closed")
    return Told(TITLE, tuple(_compared(outcome.thermal)), path.parent)


def _compared(thermal: ThermalCalibration) -> Iterator[Compared]:
    """Scale factors beside their truth; the biases hold the hysteresis that was played."""
    away = thermal.reference_c - REFERENCE_C
    for place, channel in enumerate(thermal.channels):
        constant, slope = (float(value) for value in SCALE[place])
        truths = {"scale_factor": constant + slope * away, "scale_factor_t1": slope}
        for name, true in truths.items():
            one, half = parameter(channel.fit, name), parameter(channel.fit, name).expanded()
            symbol = channel.fit.parameters[channel.fit.index(name)].symbol
            held = abs(one.value - true) <= half
            yield Compared(channel.channel, symbol, one.unit, one.value, half, true, held)
