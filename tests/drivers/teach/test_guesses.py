"""Numbers are found in bytes."""

import numpy as np
import pytest

from drivers.fields import write_raw
from drivers.profile_types import TYPES, FieldSpec
from drivers.teach.guesses import Hint, bits_of, counted, field_of, guess_fields, hint_of


def rows_of(
    fields: list[tuple[str, np.ndarray]], endian: str
) -> tuple[np.ndarray, list[FieldSpec]]:
    width = sum(TYPES[type_] for type_, _ in fields)
    rows = np.zeros((len(fields[0][1]), width), np.uint8)
    specs, at = [], 0
    for type_, numbers in fields:
        spec = field_of(f"b{at}", type_, at, endian)
        write_raw(rows, spec, numbers.reshape(-1, 1))
        specs.append(spec)
        at += TYPES[type_]
    return rows, specs


@pytest.mark.parametrize("endian", ["little", "big"])
def test_a_counter_three_codes_and_a_float_are_told_apart(endian: str):
    rng = np.random.default_rng(2)
    noise = [np.rint(rng.normal(level, 9000.0, 300)).astype(int) for level in (-9e3, 2e4, 1e5)]
    rows, specs = rows_of(
        [
            ("u16", np.arange(60_000, 60_300)),
            *[("i24", numbers) for numbers in noise],
            ("f32", rng.normal(25.0, 0.01, 300)),
        ],
        endian,
    )
    order, found = guess_fields(rows, 0, rows.shape[1])
    assert order == endian
    assert [(field.at, field.type) for field in found] == [(s.at, s.type) for s in specs]
    assert hint_of(rows, found[0]) == Hint("counter", 1)
    assert {hint_of(rows, field).kind for field in found[1:]} == {"noise"}


def test_the_right_beginning_is_written_down_more_briefly():
    rng = np.random.default_rng(3)
    rows, _ = rows_of([("i16", rng.integers(-90, 90, 300)) for _ in range(6)], "little")
    assert bits_of(rows, 0, 12) < bits_of(np.roll(rows, 1, axis=1), 0, 12) - 5.0


def test_a_byte_that_wraps_without_a_carry_is_a_short_counter():
    rows, _ = rows_of([("u8", np.arange(600) % 256), ("u8", np.full(600, 7))], "little")
    assert [field.type for field in guess_fields(rows, 0, 2)[1]] == ["u8"]


def test_what_counts_backwards_or_jumps_is_no_counter():
    assert counted(np.array([9, 8, 7, 6, 5]), 8)[0] == 0
    assert counted(np.array([250, 252, 254, 0, 2]), 8) == (2, 1.0)


def test_ramps_flags_and_constants_are_named():
    t = np.arange(300)
    assert hint_of(
        rows_of([("f32", 20.0 + 0.01 * t)], "big")[0], field_of("t", "f32", 0, "big")
    ) == (Hint("ramp"))
    flags = rows_of([("u8", (t > 150) * 4)], "little")[0]
    assert hint_of(flags, field_of("s", "u8", 0, "little")).kind == "flags"
    assert hint_of(np.zeros((9, 1), np.uint8), field_of("c", "u8", 0, "little")).kind == "constant"
