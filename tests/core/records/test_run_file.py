import math
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from core.arrays import frozen, frozen_int
from core.errors import FormatError, Note, Severity, StorageError
from core.records.legacy.reader import read_legacy
from core.records.run_file import NEEDED, parse_run, read_run, run_text, write_run
from core.samples.run import Conditions, Run

SPECIMENS = sorted((Path(__file__).parents[2] / "data" / "legacy").glob("*.txt"))

SINGLE = """\
# calrig-run = 1
# test = "dividing_head"
# sensor = "accelerometer"
# axis = "z"
# device = "MS9002 №7"
# output_unit = "code"
# g_mps2 = 9.8106
# head_u_arcsec = 5
# bench = "south"
# lamps = [1, 2]
# day = 2024-05-13
run,order,mount,head_deg,temperature_c,t_s,y,y_se,humidity,who
1,0,X_from,0,27.5,0,13185.47,0.5,41,Olena
1,1,X_from,90,27.5,30,521.57,,42,Ivan
2,2,X_from@90,0,,60,-12872.84,0.5,,Olena
"""


def same(one: Run, two: Run) -> None:
    for item in fields(Run):
        a, b = getattr(one, item.name), getattr(two, item.name)
        if isinstance(a, np.ndarray):
            np.testing.assert_array_equal(a, b)
        elif item.name == "extra":
            assert list(a) == list(b)
            for name in a:
                np.testing.assert_array_equal(a[name], b[name])
        else:
            assert repr(a) == repr(b), item.name


def test_a_run_file_is_read():
    run = parse_run(SINGLE, "a.run.csv")
    assert (run.test, run.sensor, run.device) == ("dividing_head", "accelerometer", "MS9002 №7")
    assert (run.channels, run.axes, run.unit) == (("y",), ("z",), "code")
    np.testing.assert_array_equal(run.y[:, 0], [13185.47, 521.57, -12872.84])
    np.testing.assert_array_equal(run.y_se[:, 0], [0.5, np.nan, 0.5])
    assert run.mount == ("X_from", "X_from", "X_from@90")
    assert run.run.tolist() == [1, 1, 2]
    np.testing.assert_array_equal(run.temperature_c, [27.5, 27.5, np.nan])
    assert np.isnan(run.set_rate_dps).all()
    assert run.conditions.g_mps2 == 9.8106
    assert run.conditions.head_u_arcsec == 5
    assert math.isnan(run.conditions.latitude_deg)
    assert run.meta["bench"] == "south"
    np.testing.assert_array_equal(run.extra["humidity"], [41, 42, np.nan])
    np.testing.assert_array_equal(run.extra["who"], [0, 1, 0])


def test_unknown_keys_and_columns_come_back():
    text = run_text(parse_run(SINGLE, "a"))
    assert "# lamps = [1, 2]" in text
    assert "# day = 2024-05-13" in text
    assert '# bench = "south"' in text
    assert text.splitlines()[-1].endswith(",,Olena")
    same(parse_run(text, "a"), parse_run(SINGLE, "a"))


def test_texts_of_a_column_follow_their_rows():
    part = parse_run(SINGLE, "a").rows([2, 1])
    assert [line.rsplit(",", 1)[1] for line in run_text(part).splitlines()[-2:]] == [
        "Olena",
        "Ivan",
    ]


@pytest.mark.parametrize("path", SPECIMENS, ids=lambda path: path.name)
def test_legacy_files_become_run_files_and_come_back(path, tmp_path):
    run = read_legacy(path).to_run()
    write_run(run, tmp_path / "a.run.csv")
    same(read_run(tmp_path / "a.run.csv"), run)


def test_a_triad_goes_by_its_axes():
    text = """# calrig-run = 1
# test = "static_positions"
# sensor = "gyro"
# output_unit = "V"
mount,head_deg,y_x,y_se_x,y_y,y_y_se,y_z
X_from,0,1,0.1,2,0.2,3
"""
    run = parse_run(text, "a")
    assert (run.channels, run.axes) == (("x", "y", "z"), ("x", "y", "z"))
    np.testing.assert_array_equal(run.y_se, [[0.1, 0.2, np.nan]])
    assert run.run.tolist() == [1]
    assert run.order.tolist() == [0]
    named = replace(run, channels=("GX", "GY", "GZ"))
    assert "y_x,y_se_x,y_y,y_se_y" in run_text(named)
    same(parse_run(run_text(named), "a"), named)


@pytest.mark.parametrize(
    ("channels", "axes"),
    [
        (("sensor_1", "sensor_2"), ("z", "z")),
        (("a", "se_b"), ("x", "x")),
        (("x", "y"), ("z", "z")),
        (("p", "q"), ("", "")),
        (("p", "q"), ("x", "")),
        (("one, two", 'q"'), ("y", "x")),
    ],
)
def test_any_channels_come_back(channels, axes):
    run = replace(
        parse_run(SINGLE, "a"),
        channels=channels,
        axes=axes,
        y=frozen([[1.0, 2.0]] * 3),
        y_se=frozen([[0.1, 0.2]] * 3),
    )
    same(parse_run(run_text(run), "a"), run)


_numbers = st.floats(allow_nan=False, allow_infinity=False, width=64)
_columns = st.floats(allow_infinity=False, width=64)
_names = st.text(st.characters(exclude_categories=("C", "Z")), min_size=1, max_size=12).filter(
    lambda name: not name.startswith(("y", "labels"))
)
_free = st.text(st.characters(exclude_categories=("Cs",)), max_size=20)


@st.composite
def runs(draw):
    n, c = draw(st.integers(1, 4)), draw(st.integers(1, 3))

    def column(elements=_columns):
        return frozen(draw(hnp.arrays(float, n, elements=elements)))

    test = draw(st.sampled_from(sorted(NEEDED)))
    extra = draw(st.lists(_names.map(lambda name: f"k {name}"), max_size=2, unique=True))
    return Run(
        test=test,
        sensor=draw(st.sampled_from(["accelerometer", "gyro"])),
        device=draw(_free),
        channels=tuple(f"c{i}" for i in range(c)),
        axes=tuple(draw(st.sampled_from(["x", "y", "z", ""])) for _ in range(c)),
        unit=draw(_free),
        y=frozen(draw(hnp.arrays(float, (n, c), elements=_numbers))),
        y_se=frozen(draw(hnp.arrays(float, (n, c), elements=_columns))),
        run=frozen_int(draw(st.lists(st.integers(-5, 99), min_size=n, max_size=n))),
        order=frozen_int(range(n)),
        mount=("X_from",) * n if test != "rate_table" else ("",) * n,
        head_deg=column(_numbers),
        set_rate_dps=column(_numbers),
        temperature_c=column(),
        t_s=column(_numbers),
        conditions=Conditions(*draw(st.lists(_columns, min_size=8, max_size=8))),
        extra={name: column() for name in extra},
        meta=draw(
            st.dictionaries(
                _free.map(lambda key: f"m{key}"), _free | st.booleans() | _numbers, max_size=2
            )
        ),
        notes=(Note(Severity.WARNING, draw(_free), draw(_free)),),
    )


@given(runs())
def test_every_run_comes_back_to_the_last_bit(run):
    same(parse_run(run_text(run), "a"), run)


def test_a_further_column_may_not_take_the_name_of_another():
    run = replace(parse_run(SINGLE, "a"), extra={"y": np.ones(3)})
    with pytest.raises(ValueError, match="name of another"):
        run_text(run)


def test_what_a_spreadsheet_makes_of_it():
    lines = SINGLE.splitlines()
    quoted = [
        '"' + line.replace('"', '""') + '";;;;;;;;;' if line.startswith("#") else line
        for line in lines[:11]
    ]
    rows = [line.replace(",", ";").replace(".", ",") for line in lines[11:]]
    text = "\ufeff" + "\r\n".join([*quoted, *rows, ";;;;;;;;;", ""])
    back = parse_run(text.removeprefix("\ufeff"), "a")
    plain = parse_run(SINGLE, "a")
    np.testing.assert_array_equal(back.y, plain.y)
    np.testing.assert_array_equal(back.extra["humidity"], plain.extra["humidity"])
    assert back.device == plain.device
    assert back.meta["bench"] == "south"


@pytest.mark.parametrize(
    ("old", "new", "line", "column", "why"),
    [
        ("# calrig-run = 1\n", "", 0, 0, "is no run file"),
        ("calrig-run = 1", "calrig-run = 2", 0, 0, "newer CalRig"),
        ("calrig-run = 1", 'calrig-run = "1"', 0, 0, "expected 1"),
        ('"dividing_head"', '"tumble"', 0, 0, "expected one of dividing_head"),
        ('"accelerometer"', '"clock"', 0, 0, "expected one of accelerometer, gyro"),
        ('axis = "z"', 'axis = "w"', 0, 0, "expected x, y or z"),
        ("9.8106", "9,8106", 7, 0, "no TOML value"),
        ("9.8106", "true", 0, 0, "expected a number"),
        ("# bench", "# g_mps2", 9, 0, "given twice"),
        ("mount,head_deg", "mount,mount", 12, 4, "comes twice"),
        ("head_deg", "heading", 12, 0, "needs a column 'head_deg'"),
        (",y,y_se", ",u,u_se", 0, 0, "no column of outputs"),
        ("521.57", "521.5.7", 14, 7, "'521.5.7' is no number"),
        ("521.57", "", 14, 7, "y is missing"),
        ("521.57", "inf", 14, 7, "no number"),
        ("1,1,X_from,90", "1,1,X_from,", 14, 4, "head_deg is missing"),
        ("1,1,X_from", "1.5,1,X_from", 14, 1, "no whole number"),
        (",42,Ivan", ",42", 14, 0, "9 cells, the names have 10"),
        (",42,Ivan", ',42,"Iv"an', 14, 0, "no CSV"),
    ],
)
def test_damage_is_told_with_its_place(old, new, line, column, why):
    assert SINGLE.count(old) >= 1
    with pytest.raises(FormatError) as caught:
        parse_run(SINGLE.replace(old, new, 1), "a.run.csv")
    assert why in caught.value.why
    assert (caught.value.line, caught.value.column) == (line, column)


@pytest.mark.parametrize("text", ["", "# calrig-run = 1\n", "# calrig-run = 1\nrun,y\n", "a,b\n"])
def test_a_file_without_rows(text):
    with pytest.raises(FormatError):
        parse_run(text, "a")


@given(st.binary(max_size=200), st.integers(0, 600), st.booleans())
def test_damaged_run_files_give_a_run_or_a_format_error(tmp_path_factory, junk, at, insert):
    content = SINGLE.encode()
    at %= len(content)
    path = tmp_path_factory.mktemp("fuzz") / "a.run.csv"
    path.write_bytes(content[:at] + junk + content[at + (0 if insert else len(junk)) :])
    try:
        run = read_run(path)
    except FormatError:
        return
    assert np.isfinite(run.y).all()


def test_a_folder_that_cannot_be_written(tmp_path):
    with pytest.raises(StorageError):
        write_run(parse_run(SINGLE, "a"), tmp_path / "none" / "a.run.csv")
