"""A triad whose sensors bend, measured on the head, by formulas of its own."""

import numpy as np

from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

G, UNIT = 9.8106, 9.80665
STATED = Conditions(g_mps2=G, head_u_arcsec=1.0)
K = np.array([[-1334.9887, -12.82, -72.56], [35.69, -1338.834, 11.71], [1.44, 14.39, 1334.98]])
U0 = np.array([-378.75, -194.95, -229.76])
K2_X, K_YZ = 6.0, 4.0
"""mg/g^2: square of its own axis in X, product of the axes y and z in X."""


def outputs(a: np.ndarray) -> np.ndarray:
    """Codes (n, 3) at specific forces (n, 3), m/s^2."""
    own = a @ K[0] / K[0, 0] / UNIT
    bent = K[0, 0] * UNIT * 1e-3 * (K2_X * own**2 + K_YZ * a[:, 1] * a[:, 2] / UNIT**2)
    u = a @ K.T + U0
    u[:, 0] += bent
    return u


def forces(mount: list[str], head: np.ndarray) -> np.ndarray:
    """Specific force of each row on the case axes."""
    s, c = np.sin(np.radians(head)), np.cos(np.radians(head))
    zero = 0.0 * s
    felt = {"X_from": (zero, -s, c), "Y_from": (s, zero, c), "Z_from": (c, s, zero)}
    return G * np.array([[part[i] for part in felt[m]] for i, m in enumerate(mount)])


def bent_run(seed: int = 1, noise: float = 0.05) -> Run:
    """Three mountings, sixteen angles each."""
    angles = np.arange(0.0, 360.0, 22.5)
    mount = [m for m in ("X_from", "Y_from", "Z_from") for _ in angles]
    head = np.tile(angles, 3)
    n = len(head)
    rng = np.random.default_rng(seed)
    y = outputs(forces(mount, head)) + noise * rng.standard_normal((n, 3))
    return plain_run(
        y=y,
        y_se=np.full((n, 3), noise),
        mount=tuple(mount),
        head_deg=head,
        temperature_c=np.full(n, 27.0),
        t_s=60.0 * np.arange(n),
        conditions=STATED,
    )
