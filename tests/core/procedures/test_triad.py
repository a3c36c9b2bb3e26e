"""Q, its uncertainty and the calibrated input, against simulation and algebra."""

import numpy as np
import pytest

from core.arrays import frozen
from core.procedures.triad import Triad

K = np.array([[-1335.0, -12.8, -72.6], [35.7, -1338.8, 11.7], [1.4, 14.4, 1335.0]])
BIAS = np.array([-378.0, -195.0, -230.0])


def a_triad(covariance: np.ndarray) -> Triad:
    return Triad(frozen(K), frozen(BIAS), frozen(covariance), frozen([np.inf] * 3))


def a_covariance(seed: int = 1) -> np.ndarray:
    root = np.random.default_rng(seed).normal(size=(12, 12)) * 0.2
    return root @ root.T


def test_calibrated_undoes_the_model() -> None:
    a = np.random.default_rng(2).normal(0, 9.8, (20, 3))
    np.testing.assert_allclose(a_triad(np.eye(12)).calibrated(a @ K.T + BIAS), a, atol=1e-12)


@pytest.mark.slow
def test_uncertainties_of_q_and_of_calibrated_input_agree_with_simulation() -> None:
    covariance = a_covariance()
    triad = a_triad(covariance)
    rng = np.random.default_rng(3)
    draws = rng.multivariate_normal(np.zeros(12), covariance, 20000).reshape(-1, 3, 4)
    matrices = np.linalg.inv(K + draws[:, :, 1:])
    np.testing.assert_allclose(matrices.std(axis=0), triad.u_q(), rtol=0.03)
    a = np.array([3.0, -4.0, 8.0])
    u = K @ a + BIAS
    noise = rng.normal(0.0, 2.0, (20000, 3))
    values = np.einsum("nij,nj->ni", matrices, u + noise - BIAS - draws[:, :, 0])
    predicted = triad.calibrated_covariance(u[None], np.full((1, 3), 2.0))[0]
    simulated = np.cov(values.T)
    scale = np.sqrt(np.outer(np.diag(predicted), np.diag(predicted)))
    np.testing.assert_allclose(simulated / scale, predicted / scale, atol=0.03)


def test_mounting_is_kept_apart_from_non_orthogonality() -> None:
    """A square triad that is only turned has no skew, and its rotation comes out."""
    angle = np.radians(0.5)
    turned = np.array(
        [[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    k = np.diag([1300.0, -1310.0, 1320.0]) @ turned
    split = Triad(frozen(k), frozen(BIAS), frozen(np.eye(12)), frozen([4.0] * 3)).decompose()
    np.testing.assert_allclose(split.skew_deg, 0.0, atol=1e-9)
    np.testing.assert_allclose(split.mounting_deg, [0.0, 0.0, 0.5], atol=1e-4)
    np.testing.assert_allclose(split.sensitivity, [1300.0, 1310.0, 1320.0])


def test_skew_without_mounting() -> None:
    """Upper triangular with small angles: source 002 (1)-(2), no rotation."""
    k = np.diag([1000.0, 1000.0, 1000.0]) @ np.array([[1, 0.01, 0], [0, 1, 0], [0, 0, 1.0]])
    split = Triad(frozen(k), frozen(BIAS), frozen(np.eye(12)), frozen([4.0] * 3)).decompose()
    assert split.skew_deg[0] == pytest.approx(np.degrees(0.01), rel=1e-3)
    np.testing.assert_allclose(split.mounting_deg, 0.0, atol=1e-9)
