from pathlib import Path

import numpy as np
import pytest

from core.errors import FormatError
from core.records.legacy.reader import parse_legacy, read_legacy

SPECIMENS = Path(__file__).parents[3] / "data" / "legacy"
LAYOUTS = {
    "OpticalDividingHead_202405131405.txt": "clbacc",
    "OpticalDividingHead_202405140930.txt": "pointer",
    "OpticalDividingHead_202405151045.txt": "clbdus_head",
    "RotationTable_202405151000.txt": "rotation_table",
    "Accuracy_202405141110.txt": "accuracy_15",
    "Accuracy_202405141111.txt": "accuracy",
}


def text_of(name: str) -> str:
    return (SPECIMENS / name).read_text(encoding="utf-8")


def refused(text: str, path: str = "f.txt") -> FormatError:
    with pytest.raises(FormatError) as caught:
        parse_legacy(text, path)
    assert path in str(caught.value)
    return caught.value


@pytest.mark.parametrize("device", ["MS 9002", "Colibrys MS9002.D", "PW 09 31", "1234567", "a, b"])
@pytest.mark.parametrize("name", LAYOUTS)
def test_names_with_blanks_and_numbers_are_counted_from_the_right(name, device):
    printed = read_legacy(SPECIMENS / name)
    text = text_of(name).replace(printed.devices[0], device).replace("\t", " ")
    read = parse_legacy(text, "")
    assert read.layout.id == printed.layout.id
    assert set(read.devices) == {device}
    np.testing.assert_array_equal(read.values, printed.values)


def test_one_row_that_two_layouts_can_hold():
    row = "Gyro 31 0 0 0 -719.40" + " 0" * 8 + " 24803" + " 0" * 8
    with pytest.raises(FormatError, match=r"fit .*Table 3.3.*'Gyro 31'.*Table 3.2.*'Gyro'"):
        parse_legacy(row, "copy.txt")
    assert parse_legacy(row, "OpticalDividingHead_202405151045.txt").devices == ("Gyro 31",)
    tabbed = "Gyro 31\t" + row.removeprefix("Gyro 31 ").replace(" ", "\t")
    assert parse_legacy(tabbed, "copy.txt").layout.id == "clbdus_head"


def test_a_missing_column_is_told_with_its_line():
    lines = text_of("OpticalDividingHead_202405140930.txt").splitlines()
    lines[4] = lines[4].rsplit("\t", 1)[0]
    error = refused("\n".join(lines))
    assert error.line == 5
    assert "18 columns" in error.why
    assert "19" in error.why


@pytest.mark.parametrize("name", LAYOUTS)
def test_a_column_missing_throughout_is_never_taken_for_another_layout(name):
    rows = text_of(name).splitlines()[:4]
    error = refused("\n".join(row.rsplit("\t", 1)[0] for row in rows), name)
    assert "columns" in error.why


def test_layouts_mixed_in_one_file_are_refused():
    text = text_of("OpticalDividingHead_202405140930.txt") + text_of(
        "OpticalDividingHead_202405151045.txt"
    )
    error = refused(text)
    assert error.line == 9
    assert "another layout" in error.why
