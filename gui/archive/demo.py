"""The Archive tab's part of the demonstration: a unit measured today, and calibrated for years."""

from collections.abc import Iterator
from dataclasses import replace
from datetime import date, datetime, timedelta
from pathlib import Path

import numpy as np

from core.arrays import frozen
from core.plans.plan import load_plans
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import write_calibration
from core.samples.run import Conditions
from drivers.virtual.session import Order, simulate_session
from gui.archive.tab import ArchiveTab
from gui.measuring.demonstrating import Stage, Told
from gui.measuring.keeper import proposed_name

TITLE = "Archive"
_STATED = Conditions(g_mps2=9.8106, u_g_mps2=1e-4, head_u_arcsec=5.0, repeatability=1e-3)
_LIMITS = '[[limit]]\nparameter = "bias"\nunit = "code"\nlow = -395\nhigh = -360\n'
_BEFORE = 13
_FIRST = date(2023, 2, 14)
_APART = timedelta(days=97)
_AGEING, _SCATTER = 0.9, 4.0
"""Of a bias, in codes: from one calibration to the next, and by chance."""
_ACCUMULATION_S = 2.0
_CHOSEN, _EARLIER = 2, 8


def play(stage: Stage) -> Told:
    """Measure once without the window, add the years before, follow a bias, compare two."""
    session = _fill(stage.sessions)
    tab = stage.show(TITLE)
    if not isinstance(tab, ArchiveTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    stage.until(lambda: len(_calibrations(tab)) > _BEFORE, "the archive did not list all")
    tab.presenter.choose((_calibrations(tab)[_CHOSEN],))
    _picture(stage, tab, "archive-history")
    tab.presenter.choose(tuple(_calibrations(tab)[place] for place in (_CHOSEN, _EARLIER)))
    _picture(stage, tab, "archive-comparison")
    return Told(TITLE, (), session)


def _calibrations(tab: ArchiveTab) -> list[int]:
    return [row.id for row in tab.presenter.state.rows if row.cells[1] == "calibration"]


def _picture(stage: Stage, tab: ArchiveTab, name: str) -> None:
    stage.until(lambda: tab.library.idle, "the archive did not answer")
    stage.picture(name)


def _fill(root: Path) -> Path:
    """Leave a session, its calibration, older ones, and the limits of the bias."""
    plan = replace(load_plans()["pointer_8"], accumulation_s=_ACCUMULATION_S)
    order = Order("sim://pointer?speed=max&name=archive", plan, "accelerometer", _STATED)
    session = root / proposed_name("PW09", plan, datetime.now())
    calibration = calibrate(simulate_session(order, session), _STATED)
    write_calibration(calibration, session / "calibration.cal.json")
    for older in _older(calibration):
        day = older.provenance.measured_utc[:10].replace("-", "")
        folder = root / f"{day}_0930_PW09_{plan.id}"
        folder.mkdir(parents=True)
        write_calibration(older, folder / "calibration.cal.json")
    (root / "limits.toml").write_text(_LIMITS, "utf-8")
    return session


def _older(calibration: Calibration) -> Iterator[Calibration]:
    """The same unit in the years before, its biases a little elsewhere each time."""
    rng = np.random.default_rng(2)
    for number in range(_BEFORE):
        fits = tuple(
            replace(fit, values=frozen(fit.values + _moved(fit.names, number, rng)))
            for fit in calibration.fits
        )
        when = f"{_FIRST + number * _APART}T09:30:00+00:00"
        yield replace(
            calibration,
            fits=fits,
            temperature_c=24.0 + float(rng.normal()),
            provenance=replace(calibration.provenance, measured_utc=when),
        )


def _moved(names: tuple[str, ...], number: int, rng: np.random.Generator) -> np.ndarray:
    moved = np.zeros(len(names))
    moved[names.index("bias")] = _AGEING * (number - _BEFORE) + rng.normal(0.0, _SCATTER)
    return moved
