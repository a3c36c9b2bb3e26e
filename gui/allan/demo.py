"""The Allan tab's part of the demonstration: the records of the Live tab, their noise compared."""

import math
from pathlib import Path

from core.errors import LinkError
from core.records.cvgcom_name import FOLDER
from core.records.noise_study import NoiseStudy
from drivers.virtual.devices import make_device
from drivers.virtual.truth import Compared
from gui.allan.tab import AllanTab
from gui.measuring.demonstrating import Stage, Told

TITLE = "Allan"
_EXPORTS = ("svg", "coefficients", "kalibr", "matlab")


def play(stage: Stage) -> Told:
    """Analyse and compare the recorded gyros, and put their random walk beside the truth."""
    tab = stage.show(TITLE)
    if not isinstance(tab, AllanTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    folder = Path(tab.exporting.propose("svg")).parent
    records = sorted((folder / FOLDER).glob("*/*.calrec"))
    if not records:
        raise LinkError(str(folder), "there are no records to analyse", "play the part live first")
    stage.until(lambda: tab.view.plot is not None, "the plot did not come")
    tab.presenter.add([str(path) for path in records])
    stage.until(
        lambda: len(tab.library.studies) == len(tab.library.entries), "a record was not analysed"
    )
    stage.picture("allan-comparison")
    for key in _EXPORTS:
        path = Path(tab.exporting.propose(key))
        tab.exporting.export(key, str(path))
        stage.until(path.exists, f"{path.name} was not written")
        stage.keep(path)
    return Told(TITLE, tuple(_compared(one) for one in tab.library.studies), folder)


def _compared(study: NoiseStudy) -> Compared:
    """The random walk beside that of the simulated gyro."""
    row = study.published.row("random_walk")
    (output,) = make_device("cvg25", 1).outputs
    truth = output.level.density / math.sqrt(2.0) / study.scale_factor
    held = row.lower <= truth <= row.upper
    half = 0.5 * (row.upper - row.lower)
    return Compared(study.device, row.symbol, row.unit, row.value, half, truth, held)
