import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.errors import FormatError, StorageError
from core.records.legacy.layout import (
    ACCURACY,
    CLBACC,
    CLBDUS_HEAD,
    POINTER,
    ROTATION_TABLE,
    position_of,
)
from core.records.legacy.reader import parse_legacy, read_legacy
from core.records.legacy.writer import (
    append_row,
    legacy_rows,
    legacy_text,
    write_legacy,
)

SPECIMENS = Path(__file__).parents[3] / "data" / "legacy"
FILES = sorted(SPECIMENS.glob("*.txt"))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_a_run_is_written_byte_for_byte_as_it_was_read(path, tmp_path):
    file = read_legacy(path)
    copy = tmp_path / path.name
    write_legacy(file.to_run(), file.layout, copy)
    assert copy.read_bytes() == path.read_bytes()
    write_legacy(file, file.layout, copy)
    assert copy.read_bytes() == path.read_bytes()


def test_one_row_of_table_1_2_as_text():
    file = read_legacy(SPECIMENS / "OpticalDividingHead_202405131405.txt")
    line = legacy_text(file, CLBACC).splitlines()[1]
    assert line == "\t".join(
        ["Colibrys", "+27", "90", "6", "0", "0", "521.57", *["0.00"] * 8, "14799", *["0"] * 8]
    )


@pytest.mark.parametrize(("angle", "position"), [(0, 0), (90, 6), (360, 24), (7.5, 1), (400, 27)])
def test_position_numbers_of_free_angles_are_those_of_a_neighbour(angle, position):
    assert position_of(angle) == position
    run = replace(
        read_legacy(SPECIMENS / "OpticalDividingHead_202405131405.txt").to_run(),
        head_deg=np.full(4, float(angle)),
    )
    back = parse_legacy(legacy_text(run, CLBACC), "f.txt")
    assert back.column("head angle").tolist() == [angle] * 4
    assert back.column("position number").tolist() == [position] * 4


@pytest.mark.parametrize(("value", "text"), [(27, "+27"), (-40, "-40"), (0, "+0"), (22.5, "+22.5")])
def test_set_temperatures_carry_their_sign(value, text):
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405131405.txt").to_run()
    run = replace(run, temperature_c=np.full(4, float(value)))
    assert {line.split("\t")[1] for line in legacy_text(run, CLBACC).splitlines()} == {text}
    measured = replace(run, extra={**run.extra, "set_temperature_c": np.full(4, 70.0)})
    assert "\t+70\t" in legacy_text(measured, CLBACC)


def test_a_triad_with_other_names_goes_by_its_axes():
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    turned = replace(run, channels=("AZ", "AX", "AY"), axes=("z", "x", "y"), y=run.y[:, [2, 0, 1]])
    assert legacy_text(turned, POINTER) == legacy_text(run, POINTER)


def test_outputs_that_are_no_codes_keep_their_digits():
    run = read_legacy(SPECIMENS / "RotationTable_202405151000.txt").to_run()
    volts = replace(run, unit="V", y=run.y * 1e-6)
    back = parse_legacy(legacy_text(volts, ROTATION_TABLE), "f.txt").to_run()
    np.testing.assert_allclose(back.y, volts.y, rtol=1e-8)


def test_names_stay_as_they_are_and_on_one_line():
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405151045.txt").to_run()
    for name, kept in (
        ("../x/Збірка  7", "../x/Збірка  7"),
        ("a\tb\r\nc", "a b  c"),
        ("", "No Name"),
        ("1;2", "1;2"),
    ):
        text = legacy_text(replace(run, device=name), CLBDUS_HEAD)
        assert len(text.splitlines()) == 4
        assert set(parse_legacy(text, "f.txt").devices) == {kept}


@pytest.mark.parametrize(
    ("name", "layout", "change", "why"),
    [
        ("Rot*", CLBACC, {}, "no columns for a gyro"),
        ("Rot*", CLBDUS_HEAD, {}, "holds the test 'static_positions'"),
        ("*0930*", POINTER, {"mount": ("Z_from",) * 8}, "row 1: .* no position for mount 'Z_from'"),
        ("*0930*", POINTER, {"axes": ("x", "x", "z"), "channels": ("a", "b", "c")}, "axes x, y, z"),
        ("*1405*", CLBACC, {"temperature_c": np.full(4, np.nan)}, "needs the set temperature"),
        ("*1405*", CLBACC, {"head_deg": np.full(4, np.nan)}, "needs the head angle"),
        ("*1405*", CLBACC, {"temperature_c": np.full(4, 300.0)}, "must be -200 to 200"),
        ("*1405*", CLBACC, {"y": np.full((4, 1), np.nan)}, "row 1: .* needs the acc_1"),
    ],
)
def test_what_a_layout_cannot_hold_is_refused(name, layout, change, why):
    run = read_legacy(next(iter(SPECIMENS.glob(name)))).to_run()
    with pytest.raises(FormatError, match=why):
        legacy_text(replace(run, **change), layout)


def test_a_file_of_one_layout_is_not_written_as_another(tmp_path):
    file = read_legacy(SPECIMENS / "Accuracy_202405141110.txt")
    with pytest.raises(FormatError, match="not of"):
        legacy_text(file, ACCURACY)
    write_legacy(file.to_run(), ACCURACY, tmp_path / "a.txt")
    assert read_legacy(tmp_path / "a.txt").layout.id == "accuracy"


def test_rate_numbers_without_steps_follow_the_rates():
    run = read_legacy(SPECIMENS / "RotationTable_202405151000.txt").to_run()
    shuffled = replace(run, extra={}).rows([3, 0, 10, 3])
    assert legacy_rows(shuffled, ROTATION_TABLE).column("rate number").tolist() == [1, 0, 2, 1]


def test_rows_are_appended_one_by_one(tmp_path):
    file = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt")
    run = file.to_run()
    path = tmp_path / "OpticalDividingHead_202405140930.txt"
    path.touch()
    for i in range(len(run)):
        append_row(path, legacy_rows(run.rows([i]), POINTER))
        assert len(read_legacy(path)) == i + 1
    assert path.read_bytes() == (SPECIMENS / path.name).read_bytes()


def test_a_folder_that_cannot_be_written(tmp_path):
    file = read_legacy(SPECIMENS / "Accuracy_202405141110.txt")
    nowhere = tmp_path / "none"
    with pytest.raises(StorageError, match="earlier rows are untouched"):
        append_row(nowhere / "a.txt", file)
    with pytest.raises(StorageError, match="choose another folder"):
        write_legacy(file, file.layout, nowhere / "a.txt")


def test_table_2_2_survives_the_round_trip_to_the_golden_numbers():
    golden = json.loads((SPECIMENS.parent / "golden.json").read_text(encoding="utf-8"))
    printed = golden["source001"]["table_2_2"]["input"]
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    back = parse_legacy(legacy_text(run, POINTER), "f.txt").to_run()
    np.testing.assert_array_equal(back.y.T, [printed["U_ax"], printed["U_ay"], printed["U_az"]])
