from datetime import datetime
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.records.names import name_in_file, safe_name, stamp, stamp_of


@pytest.mark.parametrize(
    ("device", "part"),
    [
        ("PW09", "PW09"),
        ("Збірка №5", "Збірка_№5"),
        ("../x", "x"),
        ("..\\..\\windows", "windows"),
        ("/etc/passwd", "etc_passwd"),
        ("C:\\a", "C_a"),
        ("a/b", "a_b"),
        ("", "No_Name"),
        (" \t\n", "No_Name"),
        ("...", "No_Name"),
        ("CON", "_CON"),
        ("com1.txt", "_com1.txt"),
        ("COM10", "COM10"),
        ("nul", "_nul"),
        ("a\0b", "a_b"),
        ("name. ", "name"),
        ("x" * 300, "x" * 64),
    ],
)
def test_file_name_parts(device, part):
    assert safe_name(device) == part


@given(st.text(max_size=100))
def test_no_device_name_leaves_its_folder(device):
    part = safe_name(device)
    assert part
    assert len(part) <= 65
    root = Path("/data")
    assert (root / part).resolve().parent == root
    assert not set(part) & set('<>:"/\\|?*')
    assert safe_name(part) == part


@given(st.text(max_size=60))
def test_names_inside_files_keep_to_one_line(device):
    name = name_in_file(device)
    assert name
    assert len(name.splitlines()) == 1
    assert "\t" not in name


def test_stamps():
    when = datetime(2024, 5, 13, 14, 5, 59)
    assert stamp(when) == "202405131405"
    assert stamp_of("OpticalDividingHead_202405131405.txt") == when.replace(second=0)
    assert stamp_of("OpticalDividingHead_202405131405_2.txt") == when.replace(second=0)
    assert stamp_of("OpticalDividingHead_202413131405.txt") is None
    assert stamp_of("copy.txt") is None
