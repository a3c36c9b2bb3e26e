"""The page Compare gyros in the demonstration: the gyros of the Live and the Allan tab."""

from dataclasses import replace
from pathlib import Path

from core.errors import LinkError
from core.plans.plan import Plan, load_plans
from core.records.cvgcom_name import FOLDER
from core.samples.run import Conditions
from drivers.virtual.session import Order, simulate_session
from gui.comparison.page import ComparisonPage
from gui.measuring.demonstrating import Stage, Told
from gui.methods.tab import MethodsTab

TITLE = "Methods"
_PLAN = "rate_table_cvg40"
_ACCUMULATION_S = 4.0
_STATED = Conditions(g_mps2=9.8106, latitude_deg=50.45)


def play(stage: Stage) -> Told:
    """Measure each recorded gyro on the rate table, and put both beside each other."""
    noise = sorted(stage.sessions.rglob("Allan_*.csv"))
    devices = sorted(path.name for path in (stage.sessions / FOLDER).glob("*") if path.is_dir())
    if not noise or not devices:
        raise LinkError(str(stage.sessions), "there is no noise to compare", "play Allan first")
    plan = replace(load_plans()[_PLAN], accumulation_s=_ACCUMULATION_S)
    runs = {device: _turned(stage, plan, device, seed) for seed, device in enumerate(devices, 1)}
    tab = stage.show(TITLE)
    if not isinstance(tab, MethodsTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    tab.open("comparison")
    page = tab.pages["comparison"]
    if not isinstance(page, ComparisonPage):
        raise TypeError("the page of the comparison is another one")
    presenter = page.presenter
    presenter.add([*runs.values(), noise[-1]])
    stage.until(lambda: len(presenter.state.rows) == 2 * len(devices), "the files were not read")
    # All simulated CVGs have one serial number; their folders have the names of the Live tab.
    for row in presenter.state.rows:
        measured = (name for name in devices if row.source == runs[name].name)
        recorded = (name for name in devices if row.name.startswith(name))
        presenter.rename(row.key, next(measured, next(recorded, row.name)))
    stage.picture("compare-gyros")
    return Told(TITLE, (), stage.sessions)


def _turned(stage: Stage, plan: Plan, device: str, seed: int) -> Path:
    """The session of one gyro on the rate table."""
    folder = stage.sessions / f"{device}_{plan.id}"
    url = f"sim://cvg25?speed=max&seed={seed}&name=table{seed}"
    simulate_session(Order(url, plan, "gyro", _STATED), folder)
    return folder
