import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import FormatError
from core.records.decimals import read_decimals


@given(st.lists(st.floats(-99999.9, 99999.9, allow_nan=False), max_size=60), st.integers(1, 7))
def test_values_are_those_of_float(numbers, columns):
    texts = [f"{number:1.9f}" for number in numbers]
    lines = ["\t".join(texts[i : i + columns]) for i in range(0, len(texts), columns)]
    values, per_line = read_decimals("\r\n".join(lines).encode(), "x.txt", 1)
    assert values.tolist() == [float(text) for text in texts]
    assert per_line.sum() == len(texts)


def test_unusual_numbers_are_read_too():
    text = b"1\t-2.5\t1e-3\nnan 1234567.123456789  -0.000000001\n\n+7."
    values, per_line = read_decimals(text, "x.txt", 1)
    wanted = [1.0, -2.5, 1e-3, np.nan, 1234567.123456789, -1e-9, 7.0]
    assert np.array_equal(values, wanted, equal_nan=True)
    assert per_line.tolist() == [3, 3, 0, 1]


def test_many_stretches_count_their_lines():
    text = b"0.123456789\t1.000000000\r\n" * 30_000
    values, per_line = read_decimals(text, "x.txt", 1)
    assert len(values) == 60_000
    assert np.all(per_line == 2)
    with pytest.raises(FormatError) as caught:
        read_decimals(text + b"0.1\tx\r\n", "x.txt", 6)
    assert (caught.value.line, caught.value.column) == (30_006, 5)


@pytest.mark.parametrize("word", ["1.23456789a", "1..23456789", "--1.234567890", "0x1", "1,5", "µ"])
def test_what_is_no_number_is_refused_with_its_place(word):
    with pytest.raises(FormatError) as caught:
        read_decimals(f"1.000000000\n2.0 {word}\n".encode(), "f.txt", 8)
    assert (caught.value.line, caught.value.column) == (9, 5)


def test_nothing_is_read_from_nothing():
    values, per_line = read_decimals(b"", "x.txt", 1)
    assert not len(values)
    assert not len(per_line)
