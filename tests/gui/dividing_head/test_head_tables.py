"""Numbers of the results page against those of the calibration, and against each other."""

import numpy as np

from core.plans.orientation import specific_force
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.samples.run import Conditions
from gui.dividing_head.tables import matrices, parameter_table
from tests.plain_run import plain_run

G = 9.8106
K = np.array([[-1335.0, -12.8, -72.6], [35.7, -1338.8, 11.7], [1.4, 14.4, 1335.0]])
BIAS = np.array([-378.0, -195.0, -230.0])
PLACES = [(mount, 90.0 * i) for mount in ("X_from", "Y_from") for i in range(4)]


def calibrated(columns: tuple[int, ...]) -> Calibration:
    """Rows with their own errors and a drift that is not stated: freedoms differ by parameter."""
    n = len(PLACES)
    force = np.array([specific_force(mount, head, G) for mount, head in PLACES])
    y = force @ K.T + BIAS + np.random.default_rng(5).normal(0.0, 1.0, (n, 3))
    run = plain_run(
        device="unit",
        channels=tuple(f"acc_{'xyz'[i]}" for i in columns),
        axes=tuple("xyz"[i] for i in columns),
        y=y[:, columns],
        y_se=np.ones((n, 3)),
        run=np.zeros(n, np.int64),
        mount=tuple(mount for mount, _ in PLACES),
        head_deg=np.array([head for _, head in PLACES]),
    )
    stated = Conditions(g_mps2=G, u_g_mps2=0.0005, head_u_arcsec=10.0, repeatability=np.nan)
    return calibrate(run, stated)


def test_the_matrices_show_the_parameters_of_the_table_whatever_the_order_of_channels() -> None:
    calibration = calibrated((2, 0, 1))
    (k, bias), _ = matrices(calibration)
    shown = {
        (sensor, symbol): (value, half)
        for sensor, symbol, value, half, _ in parameter_table(calibration).rows
    }
    for i, own in enumerate("xyz"):
        assert bias.cells[i][0] == shown[f"acc_{own}", "U0"]
        for j, other in enumerate("xyz"):
            symbol = f"k_{own}" if own == other else f"k_{own}{other}"
            assert k.cells[i][j] == shown[f"acc_{own}", symbol]
    assert float(k.cells[0][2][0].replace("\N{MINUS SIGN}", "-")) < -70.0
