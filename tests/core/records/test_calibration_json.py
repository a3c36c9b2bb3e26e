import json
import math
from dataclasses import fields, is_dataclass, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import FormatError, Note, Severity, StorageError
from core.fit.result import LackOfFit
from core.model.catalogue.faults import Outlier
from core.procedures.added import Added
from core.procedures.compensation import compensated
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import (
    calibration_text,
    equation,
    parse_calibration,
    read_calibration,
    write_calibration,
)
from tests.core.procedures.bent_triad import STATED, bent_run
from tests.core.procedures.test_added import FOUND


def same(one, two, where="calibration"):
    """Equal to the last bit, in every member, however deep."""
    assert type(one) is type(two), where
    if is_dataclass(one):
        for item in fields(one):
            same(getattr(one, item.name), getattr(two, item.name), f"{where}.{item.name}")
    elif isinstance(one, np.ndarray):
        np.testing.assert_array_equal(one, two, err_msg=where)
    elif isinstance(one, tuple):
        assert len(one) == len(two), where
        for a, b in zip(one, two, strict=True):
            same(a, b, where)
    else:
        assert one == two or (one != one and two != two), where


@pytest.fixture(params=["triad", "single"])
def calibration(request):
    return request.getfixturevalue(request.param)


def test_a_calibration_comes_back_to_the_last_bit(calibration, tmp_path):
    path = tmp_path / "a.cal.json"
    write_calibration(calibration, path)
    same(read_calibration(path), calibration)
    assert calibration_text(read_calibration(path)) == path.read_text(encoding="utf-8")


def test_what_other_fits_hold_comes_back_as_well(single):
    (fit,) = single.fits
    fit = replace(
        fit,
        t_dof=np.array([math.inf, *fit.t_dof[1:]]),
        lack_of_fit=LackOfFit(1.5, 4, 30.25, 0.001),
        notes=(Note(Severity.ERROR, "їєґ", 'two\nlines "quoted"'),),
    )
    records = (("a.txt", "0" * 64),)
    full = replace(
        single, fits=(fit,), provenance=replace(single.provenance, records=records, plan="p")
    )
    same(parse_calibration(calibration_text(full), "f"), full)


def test_the_triad_stands_in_the_document(triad):
    document = json.loads(calibration_text(triad))
    block = document["triad"]
    wanted = triad.triad()
    for key, values in {
        "K": wanted.k,
        "U0": wanted.bias,
        "u_K": wanted.u_k(),
        "u_U0": wanted.u_bias(),
        "u_Q": wanted.u_q(),
        "covariance": wanted.covariance,
    }.items():
        np.testing.assert_array_equal(block[key], values)
    np.testing.assert_allclose(np.array(block["Q"]) @ block["K"], np.eye(3), atol=1e-12)
    assert block["channels"] == ["acc_x", "acc_y", "acc_z"]
    assert block["covariance_of"][:5] == ["U0_x", "K_xx", "K_xy", "K_xz", "U0_y"]
    assert len(block["covariance"]) == len(block["covariance_of"])
    assert "a = Q (U - U0)" in document["equation"]
    assert document["input_unit"] == "m/s^2"


def test_one_sensor_has_no_triad(single):
    assert "triad" not in json.loads(calibration_text(single))
    assert "Q" not in equation(single)


@pytest.mark.parametrize(
    ("path", "value", "why"),
    [
        (["schema_version"], 2, "newer CalRig"),
        (["schema"], "calrig-session", "is no calrig-calibration document"),
        (["sensor"], "clock", "sensor must be accelerometer or gyro"),
        (["channels"], [], "channels must be at least one channel"),
        (["channels", 0, "axis"], "w", r"channels\[0\]\.axis must be x, y, z"),
        (
            ["channels", 0, "fit", "covariance", 0],
            [1.0],
            r"fit\.covariance\[0\] must be \d numbers",
        ),
        (["channels", 0, "fit", "parameters", 0, "value"], None, "a parameter has no value"),
        (["channels", 0, "fit", "sigma"], [], r"fit\.sigma must be 4 numbers"),
        (["channels", 0, "fit", "dof"], 1.5, r"fit\.dof must be a whole number"),
        (["provenance", "records"], [{"name": "a"}], r"records\[0\]\.sha256 is missing"),
    ],
)
def test_damage_is_told_by_name(single, path, value, why):
    document = json.loads(calibration_text(single))
    place = document
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    with pytest.raises(FormatError, match=why):
        parse_calibration(json.dumps(document), "a.cal.json")


def test_a_condition_that_an_older_program_did_not_know(single):
    document = json.loads(calibration_text(single))
    del document["conditions"]["head_u_arcsec"]
    assert math.isnan(parse_calibration(json.dumps(document), "f").conditions.head_u_arcsec)


@given(data=st.data())
def test_any_damage_gives_a_calibration_or_a_format_error(single, data):
    text = calibration_text(single)
    at = data.draw(st.integers(0, len(text) - 1))
    junk = data.draw(st.text(max_size=4))
    damaged = text[:at] + junk + text[at + data.draw(st.integers(0, 8)) :]
    try:
        calibration = parse_calibration(damaged, "f")
    except FormatError:
        return
    assert calibration.sensor in ("accelerometer", "gyro")


def test_files_that_cannot_be_read_or_written(single, tmp_path):
    with pytest.raises(FormatError, match="cannot be read"):
        read_calibration(tmp_path / "none")
    with pytest.raises(StorageError):
        write_calibration(single, tmp_path / "none" / "a")


def test_added_effects_come_back_whole():
    found = Added((*FOUND.effects, ("acc_z", Outlier(5))))
    bent = calibrate(bent_run(), STATED, added=found)
    text = calibration_text(bent)
    again = parse_calibration(text, "a.cal.json")
    assert again.effects == bent.effects
    assert calibration_text(again) == text
    np.testing.assert_array_equal(compensated(again, bent_run().y), compensated(bent, bent_run().y))
    document = json.loads(text)
    first, second = document["channels"][0]["effects"]
    assert first["effect"] == "second_order_nonlinearity"
    assert first["parameters"] == ["second_order"]
    assert (first["in_use"], second["parameters"]) == (True, ["product_yz"])
    assert "effects" not in document["channels"][1]
    assert document["channels"][2]["effects"][0]["shape"][0]["value"] == 6.0
    assert "e(a)" in document["equation"]


@pytest.mark.parametrize(
    ("change", "named"),
    [({"effect": "magic"}, "catalogue"), ({"parameters": ["magic"]}, "parameters of the fit")],
)
def test_effects_that_are_not_there_are_refused(change, named):
    document = json.loads(calibration_text(calibrate(bent_run(), STATED, added=FOUND)))
    document["channels"][0]["effects"][0].update(change)
    with pytest.raises(FormatError, match=named):
        parse_calibration(json.dumps(document), "a.cal.json")
