"""Scale expressions: values, and everything that is no arithmetic refused."""

import math

import pytest

from drivers.expression import evaluate


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1", 1.0), ("20*9.80665/65536", 20 * 9.80665 / 65536), ("1/KG", 0.1), ("2**-14", 2.0**-14),
        ("-(3 - 1e-3)*+2", -(3 - 1e-3) * 2), (" 0x10 ", 16.0), ("2**3**2", 512.0),
    ],
)  # fmt: skip
def test_arithmetic(text: str, value: float):
    assert evaluate(text, {"KG": 10.0}) == value


@pytest.mark.parametrize(
    "text",
    [
        "", "1+", "abs(1)", "__import__('os')", "KG.real", "[1]", "1 if 1 else 2", "True", "'1'",
        "1;2", "lambda: 1", "1//2", "1%2", "1 < 2", "1j", "x:=1", "\0", "(" * 190, "9" * 201,
    ],
)  # fmt: skip
def test_anything_else_is_refused(text: str):
    with pytest.raises(ValueError, match=r"only numbers|is no expression|at most|null bytes"):
        evaluate(text, {"KG": 10.0})


@pytest.mark.parametrize("text", ["1/0", "1e999", "10**400", "(-1)**0.5", "1e308*1e308 - 1e999"])
def test_no_finite_value(text: str):
    with pytest.raises(ValueError, match="no finite value"):
        evaluate(text, {})


def test_an_unknown_name_is_named_with_the_likely_one():
    with pytest.raises(ValueError, match=r'"KGY" is not in .* did you mean "KGX"'):
        evaluate("1/KGY", {"KGX": 10.0, "other": 1.0})


def test_the_result_is_a_float():
    assert isinstance(evaluate("3", {}), float)
    assert math.isclose(evaluate("180/3.141592653589793", {}), 57.29577951308232)
