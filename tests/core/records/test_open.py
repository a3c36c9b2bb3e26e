import hashlib
import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import FormatError
from core.plans.plan import load_plans
from core.records.legacy.reader import read_legacy
from core.records.open import read_any
from core.records.run_file import write_run
from core.records.session.start import SessionStart
from core.records.session.store import Session
from core.samples.accumulate import accumulation_of
from core.samples.block import Channel

SPECIMENS = Path(__file__).parents[2] / "data" / "legacy"
TABLE_2_2 = SPECIMENS / "OpticalDividingHead_202405140930.txt"


@pytest.fixture
def session(tmp_path):
    channels = tuple(
        Channel(f"{kind}{axis}", "code", f"{kind}.{axis}")
        for kind in ("acc", "rate")
        for axis in "xyz"
    )
    plan = load_plans()["pointer_8"]
    start = SessionStart("PW09", "accelerometer", channels, 100.0, plan, "2024-05-14T09:30+03:00")
    with Session.create(tmp_path / "s", start) as session:
        data = np.random.default_rng(1).normal(5.0, 1.0, (64, 6))
        session.accept(plan.steps[0], accumulation_of(channels, np.arange(64) / 100, data))
        session.finish()
    return session


def test_all_kinds_are_told_by_what_they_hold(tmp_path, session):
    legacy = read_any(TABLE_2_2)
    assert legacy.meta["legacy_layout"] == "pointer"
    other = tmp_path / "copy.txt"
    write_run(legacy, other)
    np.testing.assert_array_equal(read_any(other).y, legacy.y)
    bom = tmp_path / "bom.dat"
    bom.write_bytes(b"\xef\xbb\xbf" + other.read_bytes())
    np.testing.assert_array_equal(read_any(bom).y, legacy.y)
    by_folder = read_any(session.folder)
    for name in ("session.json", "positions.jsonl", "PW09.run.csv"):
        np.testing.assert_array_equal(read_any(session.folder / name).y, by_folder.y)


def test_choices_that_a_source_leaves(session):
    assert read_any(TABLE_2_2, sensor="gyro").sensor == "gyro"
    assert read_any(session.folder, sensor="gyro").channels == ("gyro_x", "gyro_y", "gyro_z")
    assert read_any(TABLE_2_2, device="PW09").device == "PW09"
    assert read_any(SPECIMENS / "OpticalDividingHead_202405131405.txt", mounts=["Y_to"]).mount == (
        ("Y_to",) * 4
    )


def test_choices_that_do_not_fit(session):
    run_file = session.folder / "PW09.run.csv"
    with pytest.raises(FormatError, match="not of the gyro"):
        read_any(run_file, sensor="gyro")
    for path in (session.folder, run_file, TABLE_2_2):
        with pytest.raises(FormatError, match="already tell"):
            read_any(path, mounts=["X_from"])
        with pytest.raises(FormatError, match="no rows of 'PW10'"):
            read_any(path, device="PW10")


def test_what_holds_no_run(tmp_path):
    with pytest.raises(FormatError, match="cannot be read"):
        read_any(tmp_path)
    with pytest.raises(FormatError, match="cannot be read"):
        read_any(tmp_path / "none.txt")
    path = tmp_path / "a.json"
    path.write_text(json.dumps({"schema": "calrig-calibration"}))
    with pytest.raises(FormatError, match="JSON document"):
        read_any(path)


@given(st.binary(max_size=300) | st.text(max_size=100).map(lambda t: b"# calrig-run" + t.encode()))
def test_any_bytes_give_a_run_or_a_format_error(tmp_path_factory, content):
    path = tmp_path_factory.mktemp("fuzz") / "a"
    path.write_bytes(content)
    with pytest.raises(FormatError):
        read_any(path)


def test_a_legacy_file_is_read_as_its_reader_reads_it():
    np.testing.assert_array_equal(read_any(TABLE_2_2).y, read_legacy(TABLE_2_2).to_run().y)


def test_a_run_file_tells_its_name_and_hash(tmp_path: Path):
    path = tmp_path / "one.run.csv"
    path.write_text(
        '# calrig-run = 1\n# test = "dividing_head"\n# sensor = "accelerometer"\n'
        '# output_unit = "V"\nrun,order,mount,head_deg,y\n0,0,X_from,0,1.5\n',
        encoding="utf-8",
    )
    meta = read_any(path).meta
    assert meta["source"] == "one.run.csv"
    assert meta["source_sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()
