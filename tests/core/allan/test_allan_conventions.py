import numpy as np
import pytest

from core.allan.conventions import CONVENTIONS, conventions, unit_of
from core.allan.model import TERMS


def factor(term, unit, name):
    (found,) = [one for one in conventions(term, unit) if one.name == name]
    return found.factor, found.unit


def test_a_random_walk_of_one_sixtieth_is_one_deg_per_root_hour():
    assert factor("random_walk", "deg/s", "per_root_hour") == (60.0, "deg/sqrt(h)")


def test_a_data_sheet_density_is_one_sided():
    """MPU-6050: 0.005 deg/s/sqrt(Hz) is N = 0.0035 deg/sqrt(s)."""
    value, unit = factor("random_walk", "deg/s", "one_sided")
    assert unit == "deg/s/sqrt(Hz)"
    assert 0.005 / value == pytest.approx(0.0035355, rel=1e-4)
    to_hour = factor("random_walk", "deg/s", "per_root_hour")[0]
    assert 1.0 / value * to_hour == pytest.approx(42.43, abs=0.005)


def test_b_and_the_floor_that_some_call_b():
    """Fig. 6.3: the floor 0.0083 deg/s is B = 0.0125 deg/s = 45 deg/h."""
    assert 0.0083 / factor("bias_instability", "deg/s", "floor")[0] == pytest.approx(0.012495, 1e-4)
    assert factor("bias_instability", "deg/s", "per_hour") == (3600.0, "deg/h")
    assert factor("bias_instability", "deg/s", "floor_per_hour")[0] == pytest.approx(2391.417)


def test_hours_in_walk_and_ramp():
    assert factor("rate_random_walk", "deg/s", "per_root_hour") == (216_000.0, "deg/h/sqrt(h)")
    assert factor("rate_ramp", "deg/s", "per_hour") == (3600.0**2, "deg/h/h")


def test_radians_for_programs_that_want_them():
    value, unit = factor("random_walk", "deg/s", "radian")
    assert (value, unit) == (pytest.approx(np.pi / 180.0), "rad/s/sqrt(Hz)")
    assert factor("rate_random_walk", "deg/s", "radian")[1] == "rad/s^2/sqrt(Hz)"


def test_accelerometers_in_micro_g():
    value, unit = factor("random_walk", "m/s^2", "one_sided")
    assert unit == "ug/sqrt(Hz)"
    assert 1e-3 * value == pytest.approx(np.sqrt(2.0) * 101.9716, rel=1e-6)
    assert factor("bias_instability", "m/s^2", "micro_g")[0] == pytest.approx(101971.62)


@pytest.mark.parametrize("term", TERMS)
@pytest.mark.parametrize("unit", ["deg/s", "m/s^2", "code", "V"])
def test_every_term_of_every_record_has_its_own_unit_first(term, unit):
    first = conventions(term, unit)[0]
    assert (first.name, first.factor, first.unit) == ("si", 1.0, unit_of(term, unit))


def test_other_units_pass_through():
    assert unit_of("random_walk", "code") == "code/sqrt(Hz)"
    assert unit_of("rate_ramp", "V") == "V/s"
    assert [one.name for one in conventions("bias_instability", "V")] == ["si", "floor"]


def test_names_are_unique_within_a_term():
    for ways in CONVENTIONS.values():
        assert len({one.name for one in ways}) == len(ways)
