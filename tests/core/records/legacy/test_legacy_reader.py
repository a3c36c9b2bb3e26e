from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.errors import FormatError
from core.records.legacy.reader import parse_legacy, read_legacy
from core.samples.run import Run

DATA = Path(__file__).parents[3] / "data"
SPECIMENS = DATA / "legacy"
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


# --- the six specimens ---------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "layout"), LAYOUTS.items())
def test_each_specimen_is_recognised_whatever_its_name(name, layout, tmp_path):
    assert read_legacy(SPECIMENS / name).layout.id == layout
    copy = tmp_path / "copy.dat"
    copy.write_bytes((SPECIMENS / name).read_bytes())
    assert read_legacy(copy).layout.id == layout


# --- how lab computers write text ----------------------------------------------------------------

VARIANTS = {
    "lf": lambda t: t.replace("\r\n", "\n").encode(),
    "cr": lambda t: t.replace("\r\n", "\r").encode(),
    "bom": lambda t: b"\xef\xbb\xbf" + t.encode(),
    "blanks": lambda t: t.replace("\t", "   ").encode(),
    "tabs and blanks": lambda t: t.replace("\t", " \t ").encode(),
    "runs of tabs": lambda t: t.replace("\t", "\t\t").encode(),
    "semicolons": lambda t: t.replace("\t", ";").encode(),
    "semicolons at the end": lambda t: t.replace("\t", " ; ").replace("\r\n", ";\r\n").encode(),
    "decimal comma": lambda t: t.replace(".", ",").encode(),
    "decimal comma and semicolons": lambda t: t.replace(".", ",").replace("\t", ";").encode(),
    "blank lines": lambda t: b"\r\n" + t.replace("\r\n", "\r\n  \r\n").encode() + b"\r\n\t\r\n\r\n",
    "no last line end": lambda t: t.rstrip().encode(),
    "indented": lambda t: t.replace("\r\n", "\r\n  ").encode(),
    "exponents": lambda t: t.replace("13185.47", "1.318547E+04").encode(),
}


@pytest.mark.parametrize("name", LAYOUTS)
@pytest.mark.parametrize("variant", VARIANTS)
def test_every_way_of_writing_reads_the_same(name, variant, tmp_path):
    path = tmp_path / name
    path.write_bytes(VARIANTS[variant](text_of(name)))
    read, printed = read_legacy(path), read_legacy(SPECIMENS / name)
    assert read.layout.id == printed.layout.id
    assert read.devices == printed.devices
    np.testing.assert_array_equal(read.values, printed.values)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "cp1251"])
def test_a_ukrainian_name_in_any_encoding(encoding, tmp_path):
    text = text_of("OpticalDividingHead_202405131405.txt").replace("Colibrys", "Збірка №5 їєґ")
    path = tmp_path / "OpticalDividingHead_202405131405.txt"
    path.write_bytes(text.encode(encoding))
    file = read_legacy(path)
    assert set(file.devices) == {"Збірка №5 їєґ"}
    np.testing.assert_array_equal(file.column("acc_1")[0], 13185.47)


# --- refusals: the line, the column and the reason -----------------------------------------------


def refused(text: str, path: str = "f.txt") -> FormatError:
    with pytest.raises(FormatError) as caught:
        parse_legacy(text, path)
    assert path in str(caught.value)
    return caught.value


def edited(name: str, line: int, column: int, cell: str) -> str:
    lines = [row.split("\t") for row in text_of(name).splitlines()]
    lines[line - 1][column - 1] = cell
    return "\n".join("\t".join(row) for row in lines)


@pytest.mark.parametrize("name", LAYOUTS)
@pytest.mark.parametrize(
    ("cell", "why"),
    [
        ("NaN", "no measurement"),
        ("inf", "no measurement"),
        ("12x4.5", "no number"),
        ("1.2.3", "no number"),
        ("1_000", "no number"),
        ("٣", "no number"),
        ("--5", "no number"),
        ("", "empty"),
    ],
)
def test_a_damaged_number_is_told_with_line_and_column(name, cell, why):
    column = {"accuracy": 14, "accuracy_15": 14}.get(LAYOUTS[name], 9)
    error = refused(edited(name, 2, column, cell).replace("\t", ";"))
    assert (error.line, error.column) == (2, column)
    assert why in error.why


def test_numbers_beyond_double_precision_are_refused():
    assert "no number" in refused(edited("RotationTable_202405151000.txt", 3, 6, "1e999")).why


@pytest.mark.parametrize(
    ("name", "line", "column", "cell", "why"),
    [
        ("OpticalDividingHead_202405131405.txt", 2, 4, "5", "does not belong to head angle 90"),
        ("OpticalDividingHead_202405131405.txt", 2, 4, "6.5", "whole number"),
        ("OpticalDividingHead_202405131405.txt", 3, 2, "+999", "-200 to 200"),
        ("OpticalDividingHead_202405131405.txt", 4, 5, "7", "must be 0"),
        ("OpticalDividingHead_202405140930.txt", 3, 2, "16", "0 to 15"),
        ("OpticalDividingHead_202405140930.txt", 3, 2, "2.5", "whole number"),
        ("OpticalDividingHead_202405140930.txt", 5, 2, "-1", "0 to 15"),
        ("OpticalDividingHead_202405151045.txt", 4, 2, "8", "0 to 7"),
        ("RotationTable_202405151000.txt", 7, 2, "5.5", "whole number"),
        ("Accuracy_202405141111.txt", 3, 5, "461.2", "-360 to 360"),
    ],
)
def test_impossible_numbers_are_told_with_line_and_column(name, line, column, cell, why):
    error = refused(edited(name, line, column, cell))
    assert (error.line, error.column) == (line, column)
    assert why in error.why


@pytest.mark.parametrize(
    "text",
    [
        "",
        "\r\n \n",
        "hello world\n",
        "t,ax,ay,az\n0,1,2,3\n",
        "1 2 3\n4 5 6\n",
        '{"a": 1}',
        "<html><body>404</body></html>",
        ",".join(["PW09", *map(str, range(18))]),
    ],
)
def test_foreign_files_are_refused(text):
    refused(text)


def test_columns_parted_by_commas_are_named():
    text = text_of("OpticalDividingHead_202405140930.txt").replace("\t", ",")
    assert "parted by commas" in refused(text).why


@pytest.mark.parametrize(
    "content",
    ["Colibrys 1\r\n".encode("utf-16"), b"\x00\x01\x02", b"PW09 \x98 0", b"\xff" * 100],
)
def test_binary_and_utf_16_files_are_refused(content, tmp_path):
    path = tmp_path / "f.txt"
    path.write_bytes(content)
    with pytest.raises(FormatError):
        read_legacy(path)


def test_a_file_that_cannot_be_opened(tmp_path):
    for path in (tmp_path / "none.txt", tmp_path, Path("a\0b")):
        with pytest.raises(FormatError, match="cannot be read"):
            read_legacy(path)


# --- fuzz ----------------------------------------------------------------------------------------

_CELL = st.sampled_from(
    ["PW09", "0", "1", "15", "-517.00", "+27", "90", "6", "NaN", "1,5", "12e3", "", "x", ";", "№"]
)
_LINE = st.lists(_CELL, max_size=30).map(" ".join) | st.lists(_CELL, max_size=30).map("\t".join)


@given(st.binary(max_size=400) | st.lists(_LINE, max_size=6).map(lambda x: "\n".join(x).encode()))
@settings(max_examples=400, deadline=None)
def test_any_bytes_give_a_run_or_a_format_error(tmp_path_factory, content):
    path = tmp_path_factory.mktemp("fuzz") / "OpticalDividingHead_202405131405.txt"
    path.write_bytes(content)
    try:
        run = read_legacy(path).to_run()
    except FormatError:
        return
    assert isinstance(run, Run)
    assert np.isfinite(run.y).all()


@given(
    st.sampled_from(sorted(LAYOUTS)),
    st.integers(0, 5000),
    st.binary(min_size=1, max_size=3),
    st.booleans(),
)
@settings(max_examples=400, deadline=None)
def test_damaged_specimens_give_a_run_or_a_format_error(tmp_path_factory, name, at, junk, cut):
    content = (SPECIMENS / name).read_bytes()
    at %= len(content)
    path = tmp_path_factory.mktemp("fuzz") / name
    path.write_bytes(content[:at] + junk + (b"" if cut else content[at + 1 :]))
    try:
        run = read_legacy(path).to_run()
    except FormatError:
        return
    assert isinstance(run, Run)
    assert np.isfinite(run.y).all()
