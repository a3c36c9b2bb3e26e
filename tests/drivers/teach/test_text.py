"""Text lines are read whatever their separators."""

import numpy as np
import pytest

from drivers.teach.text import looks_like_text, propose_lines


def lines(form: str, count: int = 60) -> bytes:
    rng = np.random.default_rng(0)
    rows = [
        form.format(n=n, x=rng.normal(), y=9.8 + 0.1 * rng.normal(), t=5 * n) for n in range(count)
    ]
    return "".join(rows).encode()


@pytest.mark.parametrize(
    ("form", "delimiter", "columns"),
    [
        ("{t},{x:.3f},{y:.3f}\r\n", ",", 3),
        ("{x:.4f};{y:.4f}\n", ";", 2),
        ("a/g:\t{n}\t{x:.1f}\t{y:.2f}\r\n", "tab", 3),
        ("{x:.6f} {y:.6f}\r", "ws", 2),
    ],
)
def test_separators_and_columns_are_found(form: str, delimiter: str, columns: int):
    found = propose_lines(lines(form))
    assert (found.spec.delimiter, len(found.spec.channels)) == (delimiter, columns)
    assert found.share == 1.0


def test_decimal_commas_are_found():
    found = propose_lines(lines("{x:.3f};{y:.3f}\n").replace(b".", b","))
    assert (found.spec.delimiter, found.spec.decimal) == (";", ",")


def test_a_heading_names_the_columns_and_a_time_counts():
    text = b"half a li\nt ms,ax,ay\n" + lines("{t},{x:.3f},{y:.3f}\n")
    found = propose_lines(text)
    assert [channel.name for channel in found.spec.channels] == ["t ms", "ax", "ay"]
    assert (found.spec.counter.field, found.spec.counter.step) == ("t ms", 5)
    assert found.spec.digits == 3


def test_labels_with_a_unit_behind_them_are_read():
    found = propose_lines(lines("X: {x:.2f}, Y: {y:.2f} m/s^2\n"))
    assert (found.spec.style, found.spec.suffix) == ("labels", "m/s^2")
    assert [channel.name for channel in found.spec.channels] == ["X", "Y"]


def test_objects_are_read():
    found = propose_lines(lines('{{"id":"b","ax":{x:.3f},"n":{n}}}\n'))
    assert (found.spec.style, [c.name for c in found.spec.channels]) == ("json", ["ax", "n"])


def test_a_checksum_is_seen():
    body = "$IMU,1.5,{n}"
    text = "".join(
        f"{body.format(n=n)}*{_xor(body.format(n=n)[1:]):02X}\r\n" for n in range(20, 40)
    )
    found = propose_lines(text.encode())
    assert found.spec.checksum
    assert (found.spec.prefix, found.share) == ("$IMU,", 1.0)


def _xor(text: str) -> int:
    value = 0
    for byte in text.encode():
        value ^= byte
    return value


def test_bytes_are_no_text_and_prose_is_no_table():
    assert not looks_like_text(bytes(range(256)))
    assert not looks_like_text(b"")
    assert looks_like_text(b"1,2\r\n3,4\r\n")
    assert propose_lines(b"hello\nworld of words\nnothing here\nat all\nto read\nno\nno\n") is None
