"""A calibration of a triad, and a laboratory that issues certificates."""

import numpy as np
import pytest

from core.certificates.certificate import Certificate, Order, Surroundings
from core.certificates.laboratory import Laboratory, Standard
from core.certificates.measured import measured_of
from core.plans.plan import load_plans
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.samples.run import Conditions
from tests.plain_run import plain_run

PRINTED = ({"kind": "note", "severity": "info", "subject": "rig", "text": "all is well"},)


@pytest.fixture(scope="session")
def calibration() -> Calibration:
    """Eight positions of a triad with K = 1000 code/(m/s^2) along the diagonal."""
    plan = load_plans()["accelerometer_8"]
    rng = np.random.default_rng(3)
    force = np.array([step.specific_force(9.8106) for step in plan.steps])
    n = len(plan.steps)
    run = plain_run(
        device="PW09 17",
        channels=("Ux", "Uy", "Uz"),
        y=1000.0 * force + 25.0 + rng.normal(0.0, 1.0, (n, 3)),
        run=np.zeros(n, dtype=np.int64),
        mount=tuple(step.mount for step in plan.steps),
        head_deg=np.array([step.head_deg for step in plan.steps]),
        temperature_c=np.full(n, 22.5),
    )
    return calibrate(run, Conditions(g_mps2=9.8106))


@pytest.fixture
def laboratory() -> Laboratory:
    """A laboratory with one standard."""
    return Laboratory(
        name="Laboratory of inertial sensors",
        address="Kyiv",
        authorised_by="O. Petrenko",
        standards=(
            Standard("dividing head", "114", "UA-24/118", "2027-03-01", "metrology institute"),
        ),
    )


@pytest.fixture
def certificate(calibration: Calibration, laboratory: Laboratory) -> Certificate:
    """What is issued for the triad."""
    return Certificate(
        number="2026-0001",
        laboratory=laboratory,
        order=Order(
            customer="Plant",
            contact="O. Ivanenko",
            item="inclinometer",
            serial="17",
            condition="without visible damage",
            calibrated="2026-11-20",
            issued="2026-11-22",
        ),
        measured=measured_of(calibration, PRINTED),
        surroundings=Surroundings(22.5, 41.0),
    )
