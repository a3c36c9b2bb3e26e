"""The source's sensor written out by hand from (1) and (12), in no way through the model."""

import numpy as np
import pytest

G = 9.8106
PAPER = {"u0": 2.5, "kx": 1.0, "ky": 0.0098, "kxy": 0.001, "alpha0": 0.1121}


def projected(
    alpha_deg: np.ndarray,
    *,
    u0: float = 2.5,
    kx: float = 1.0,
    ky: float = 0.0098,
    kxy: float = 0.001,
    k2: float = 0.0,
    k3: float = 0.0,
    alpha0: float = 0.1121,
    g: float = 1.0,
) -> np.ndarray:
    """Output by (1) with projections of gravity (12), per unit of the projections."""
    a = np.radians(alpha_deg + alpha0)
    ax, ay = -g * np.sin(a), -g * np.cos(a)
    return u0 + kx * ax + ky * ay + kxy * ax * ay + k2 * ax**2 + k3 * ax**3


@pytest.fixture
def paper():
    return projected


@pytest.fixture
def angles_400() -> np.ndarray:
    return np.arange(5.0, 401.0, 5.0)
