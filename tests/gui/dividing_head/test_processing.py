"""What stands between shaft and case reaches the calibration."""

from dataclasses import replace

import numpy as np
import pytest

from core.model.stimulus import stimulus_of
from core.plans.orientation import BaseOrientation
from core.plans.plan import load_plans
from core.samples.run import Conditions, Run
from gui.dividing_head.processing import Stand, of_run
from gui.dividing_head.settings import HeadSettings, Tilter
from tests.plain_run import plain_run

G = 9.8106
K = np.array([[1000.0, 5.0, -3.0], [2.0, 1100.0, 4.0], [-6.0, 1.0, 1200.0]])
BASE = BaseOrientation(alpha_arcmin=30.0, beta_arcmin=-20.0)
TILT = (0.0, 12.0, -7.0)


@pytest.fixture
def run() -> Run:
    """A triad on a leaning plate, on a tilter."""
    plan = load_plans()["pointer_8"]
    n = len(plan.steps)
    run = plain_run(
        y=np.zeros((n, 3)),
        y_se=np.full((n, 3), 0.5),
        run=np.zeros(n, dtype=np.int64),
        mount=tuple(step.mount for step in plan.steps),
        head_deg=np.array([step.head_deg for step in plan.steps]),
        conditions=Conditions(g_mps2=G),
    )
    return replace(run, y=stimulus_of(run, G, base=BASE, tilter_deg=TILT).a @ K.T)


def settings(base: BaseOrientation = BASE, mode: str = "Manual") -> HeadSettings:
    return replace(HeadSettings(), g_mps2=G, base=base, tilter=Tilter(mode, 1, 1, *TILT))


def test_plate_and_tilter_on_the_screen_are_taken_into_account(run: Run):
    found = of_run(run, "here", settings())
    assert np.allclose(found.calibration.triad().k, K, atol=1e-6)
    (check,) = (table for table in found.tables if table.title.startswith("Attitude"))
    errors = [abs(float(row[4].replace("\N{MINUS SIGN}", "-"))) for row in check.rows]
    assert max(errors) < 1e-3
    wrong = of_run(run, "here", settings(mode="None"))
    assert not np.allclose(wrong.calibration.triad().k, K, atol=1.0)


def test_a_session_knows_better_than_the_screen(run: Run):
    told = {
        **{f"base_{name}": getattr(BASE, name) for name in ("alpha_arcmin", "beta_arcmin")},
        "base_gamma_deg": 0.0,
        "base_psi_deg": 0.0,
        "tilter_mode": "Manual",
        "tilter_theta_deg": TILT[1],
        "tilter_gamma_deg": TILT[2],
    }
    screen = settings(BaseOrientation(alpha_arcmin=999.0), "None")
    stand = Stand.of(replace(run, meta=told), screen)
    assert stand == Stand(BASE, TILT)
    assert Stand.of(run, screen) == Stand(screen.base, (0.0, 0.0, 0.0))
    found = of_run(replace(run, meta=told), "session", screen)
    assert np.allclose(found.calibration.triad().k, K, atol=1e-6)
