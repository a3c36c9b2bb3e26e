import numpy as np
import pytest
from scipy.io import loadmat

from core.records.export_mat import mat_bytes


@pytest.fixture
def load(tmp_path):
    def load(calibration, **options):
        path = tmp_path / "a.mat"
        path.write_bytes(mat_bytes(calibration))
        return loadmat(str(path), **options)["calibration"]

    return load


VIEW = {"squeeze_me": True, "struct_as_record": False}


def test_a_triad_as_matlab_sees_it(load, triad):
    found = load(triad, **VIEW)
    np.testing.assert_array_equal(found.K, triad.triad().k)
    np.testing.assert_array_equal(found.Q, triad.triad().q)
    np.testing.assert_array_equal(found.U0, triad.triad().bias)
    np.testing.assert_array_equal(found.covariance, triad.triad().covariance)
    assert (found.device, found.unit, found.input_unit) == ("PW09", "code", "m/s^2")
    assert found.g_mps2 == 9.8106
    assert list(found.order) == ["acc_x", "acc_y", "acc_z"]
    for place, fit in enumerate(triad.fits):
        channel = found.channel[place]
        assert channel.name == triad.channels[place]
        assert list(channel.parameter) == list(fit.names)
        np.testing.assert_array_equal(channel.value, fit.values)
        np.testing.assert_array_equal(channel.covariance, fit.covariance)


def test_vectors_are_columns(load, triad):
    raw = load(triad)[0, 0]
    assert raw["U0"].shape == (3, 1)
    assert raw["channel"].shape[-1] == 3
    assert raw["channel"].flat[0]["residuals"].shape == (8, 1)


def test_one_sensor(load, single):
    found = load(single, **VIEW)
    assert not hasattr(found, "Q")
    assert found.channel.name == "acc_1"
    np.testing.assert_array_equal(found.channel.value, single.fits[0].values)
    assert any("mount" in note or "pass" in note for note in np.atleast_1d(found.notes))
