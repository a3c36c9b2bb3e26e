"""Limits of the laboratory, and the identity of a folder."""

import math
from pathlib import Path

import pytest

from core.archive.entry import Entry, Quantity
from core.archive.limits import Limit, limit_of, read_limits
from core.archive.place import place_of, save_place
from core.errors import FormatError
from core.procedures.conformity import Verdict

ENTRY = Entry("calibration", "a", "PW09", sensor="accelerometer", profile="pw09_raw")


def bias(value: float, u: float = 1.0) -> Quantity:
    return Quantity("acc_x", "bias", "U0", "code", value, u)


@pytest.mark.parametrize(
    ("value", "u", "verdict"),
    [
        (8.0, 1.0, Verdict.PASS),
        (9.0, 1.0, Verdict.UNDECIDED),
        (11.0, 1.0, Verdict.UNDECIDED),
        (12.0, 1.0, Verdict.FAIL),
        (-12.0, 1.0, Verdict.FAIL),
        (0.0, math.nan, Verdict.UNDECIDED),
    ],
)
def test_a_limit_is_guarded_by_the_expanded_uncertainty(
    value: float, u: float, verdict: Verdict
) -> None:
    assert Limit("bias", "code", -10.0, 10.0).judge(bias(value, u)) is verdict


def test_the_first_limit_that_fits_holds(tmp_path: Path) -> None:
    (tmp_path / "limits.toml").write_text(
        '[[limit]]\nparameter = "bias"\nunit = "code"\nhigh = 5\nchannel = "acc_x"\n'
        '[[limit]]\nparameter = "bias"\nunit = "code"\nlow = -9.5\nhigh = 9.5\n',
        "utf-8",
    )
    limits = read_limits(tmp_path)
    assert limit_of(limits, ENTRY, bias(0.0)) == Limit("bias", "code", high=5.0, channel="acc_x")
    other = Quantity("acc_y", "bias", "U0", "code", 0.0, 1.0)
    assert limit_of(limits, ENTRY, other) == Limit("bias", "code", -9.5, 9.5)
    volts = Quantity("acc_y", "bias", "U0", "V", 0.0, 1.0)
    assert limit_of(limits, ENTRY, volts) is None
    assert limit_of([Limit("bias", "code", sensor="gyro")], ENTRY, bias(0.0)) is None


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("[[limit]\n", "no TOML"),
        ("a = 1\n", "something else"),
        ("limit = [1]\n", "write"),
        ('[[limit]]\nunit = "code"\nlow = 1\n', "names no parameter"),
        ('[[limit]]\nparameter = "bias"\nunit = "code"\n', "needs a number"),
        ('[[limit]]\nparameter = "bias"\nlow = 3\nhigh = 2\n', "below high"),
        ('[[limit]]\nparameter = "bias"\nlow = 3\nhihg = 2\n', "hihg is not known"),
        ("[[limit]]\nparameter = 5\nlow = 3\n", "are texts"),
        ('[[limit]]\nparameter = "bias"\nlow = true\n', "needs a number"),
    ],
)
def test_a_wrong_file_of_limits_tells_where(tmp_path: Path, text: str, why: str) -> None:
    (tmp_path / "limits.toml").write_text(text, "utf-8")
    with pytest.raises(FormatError, match=why):
        read_limits(tmp_path)


def test_without_a_file_there_are_no_limits(tmp_path: Path) -> None:
    assert read_limits(tmp_path) == ()


def test_a_folder_keeps_its_identity(tmp_path: Path) -> None:
    first = place_of(tmp_path)
    assert first.stored
    assert place_of(tmp_path) == first
    save_place(first.__class__(tmp_path, first.id, "rig 2", "postgresql://db/rigs"))
    again = place_of(tmp_path)
    assert (again.id, again.name, again.database) == (first.id, "rig 2", "postgresql://db/rigs")
    (tmp_path / "other").mkdir()
    assert place_of(tmp_path / "other").id != first.id


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("{", "damaged"),
        ('{"schema": "calrig-archive", "schema_version": 9}', "newer"),
        (
            '{"schema": "calrig-archive", "schema_version": 1, "id": "", "name": "",'
            ' "database": ""}',
            "id is empty",
        ),
    ],
)
def test_a_wrong_identity_is_told(tmp_path: Path, text: str, why: str) -> None:
    (tmp_path / "archive.json").write_text(text, "utf-8")
    with pytest.raises(FormatError, match=why):
        place_of(tmp_path)
