"""Effects that were added to a calibration: their numbers, and what they do to the plain ones."""

import numpy as np
import pytest

from core.errors import RankDeficient
from core.model.catalogue.faults import Outlier
from core.model.catalogue.listing import CATALOGUE
from core.model.catalogue.nonlinear import CrossCoupling
from core.procedures.added import Added
from core.procedures.dividing_head import calibrate
from core.procedures.rate_calibration import calibration_of
from core.procedures.rate_table import calibrate_rate_table
from core.samples.run import Conditions, Run
from tests.core.procedures.bent_triad import K2_X, K_YZ, STATED, K, bent_run
from tests.plain_run import plain_run

FOUND = Added((("acc_x", CATALOGUE["second_order_nonlinearity"]), ("acc_x", CrossCoupling("yz"))))


def test_the_effects_are_estimated_and_no_longer_bend_the_rest():
    run = bent_run()
    plain, bent = calibrate(run, STATED), calibrate(run, STATED, added=FOUND)
    fit = bent.fits[0]
    assert fit.names[-2:] == ("second_order", "product_yz")
    assert abs(fit.value("second_order") - K2_X) < 4.0 * fit.u("second_order")
    assert abs(fit.value("product_yz") - K_YZ) < 4.0 * fit.u("product_yz")
    assert fit.u("second_order") < 0.05
    assert abs(fit.value("bias") + 378.75) < 5.0 * fit.u("bias") < 1.0
    assert abs(plain.fits[0].value("bias") + 378.75) > 10.0
    np.testing.assert_allclose(bent.triad().k, K, atol=0.05)
    first, second = bent.effects[0]
    assert (first.effect, first.places, first.in_use) == ("second_order_nonlinearity", (4,), True)
    assert (second.effect, second.places) == ("cross_coupling", (5,))
    assert bent.effects[1:] == ((), ())
    assert bent.fits[1] is not None
    np.testing.assert_array_equal(bent.fits[1].values, plain.fits[1].values)


def test_what_is_explained_is_no_longer_doubted():
    run = bent_run()
    doubts = [note.subject for note in calibrate(run, STATED).fits[0].notes]
    assert "bias_pairs_differ" in doubts
    assert calibrate(run, STATED, added=FOUND).fits[0].notes == ()


def test_a_fault_of_a_row_belongs_to_the_test_and_is_told_apart():
    run = bent_run(noise=0.05)
    y = run.y.copy()
    y[5, 2] += 30.0
    y[9, 2] -= 20.0
    wrong = Run(**{**{n: getattr(run, n) for n in run.__dataclass_fields__}, "y": y})
    added = Added((("acc_z", Outlier(5)), ("acc_z", Outlier(9))))
    found = calibrate(wrong, STATED, added=added)
    fit = found.fits[2]
    assert fit.names[-2:] == ("error", "error_2")
    assert not any(one.in_use for one in found.effects[2])
    assert found.effects[2][1].shape[0][:2] == ("row", 10.0)
    np.testing.assert_allclose(found.triad().k[2], K[2], atol=0.05)


def test_changes_put_the_rows_right():
    run = bent_run()
    change = np.zeros(len(run))
    change[3] = 100.0
    y = run.y.copy()
    y[3, 1] -= 100.0
    wrong = Run(**{**{n: getattr(run, n) for n in run.__dataclass_fields__}, "y": y})
    found = calibrate(wrong, STATED, added=Added(changes={"acc_y": change}))
    right = calibrate(run, STATED)
    np.testing.assert_allclose(found.fits[1].values, right.fits[1].values, rtol=1e-12)


def test_what_the_rows_cannot_tell_is_refused():
    run = bent_run().rows([0, 4, 8, 12, 16, 20, 24, 28])
    twice = Added((("acc_x", CATALOGUE["second_order_nonlinearity"]),) * 2)
    with pytest.raises(RankDeficient):
        calibrate(run, STATED, added=twice)


def table_run(asymmetry_ppm: float) -> Run:
    rate = np.tile(np.arange(-100.0, 101.0, 20.0), 2)
    n = len(rate)
    rng = np.random.default_rng(3)
    y = -438.0 - 79.4 * (rate + 1e-6 * asymmetry_ppm * np.abs(rate) / 2.0)
    return plain_run(
        test="rate_table",
        sensor="gyro",
        device="G1",
        channels=("gyro_z",),
        axes=("z",),
        y=(y + 0.02 * rng.standard_normal(n))[:, None],
        y_se=np.full((n, 1), 0.02),
        set_rate_dps=rate,
    )


def test_a_gyro_on_the_table():
    run = table_run(400.0)
    found = calibrate_rate_table(run, Conditions())
    effect = CATALOGUE["scale_factor_asymmetry"]
    bent = calibration_of(found, run, Added((("", effect),)))
    fit = bent.fits[0]
    assert abs(fit.value("asymmetry") - 400.0) < 4.0 * fit.u("asymmetry") < 80.0
    assert abs(fit.value("scale_factor") + 79.4) < 1e-3
    assert bent.effects[0][0].in_use
    assert calibration_of(found).effects == ()
