"""The nearest calibrations, from a real archive of a folder."""

import math
import subprocess
import sys
from datetime import UTC, datetime
from pathlib import Path

import pytest

from core.archive.store import Archive
from core.errors import FormatError
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.legacy.reader import read_legacy
from gui.nearest import NearestCalibrations
from tests.core.archive.conftest import SPECIMENS, STATED, calibrated

WHEN = datetime(2025, 3, 4, 10, tzinfo=UTC)


@pytest.fixture(scope="module")
def triad() -> Calibration:
    return calibrate(
        read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run(), STATED
    )


@pytest.fixture
def near(tmp_path: Path, triad: Calibration) -> NearestCalibrations:
    for name, day, warmth in (("a", "2025-03-01", 21.4), ("b", "2025-03-05", 60.0)):
        when = f"{day}T10:00:00+00:00"
        calibrated(triad, tmp_path / name, when=when, temperature_c=warmth)
    calibrated(triad, tmp_path / "c", when="2025-03-04T10:00:00+00:00", temperature_c=math.nan)
    return NearestCalibrations(lambda: tmp_path)


def test_they_come_in_the_order_of_their_distance_with_words(near: NearestCalibrations) -> None:
    found = near.find("PW09", WHEN, 22.0)
    assert [one.path.parent.name for one in found] == ["a", "c", "b"]
    words = [one.words.partition(", ")[2] for one in found]
    assert words == ["3 days earlier, 21.4 °C", "the same day", "one day later, 60.0 °C"]
    assert [one.path.parent.name for one in near.find("PW09", WHEN)] == ["c", "b", "a"]
    assert near.find("PW09", WHEN, 22.0, "gyro") == ()
    assert near.find("PW10", WHEN) == ()


def test_what_is_new_is_found_at_once_and_what_is_gone_is_not_proposed(
    near: NearestCalibrations, tmp_path: Path, triad: Calibration
) -> None:
    assert len(near.find("PW09", WHEN)) == 3
    path = calibrated(triad, tmp_path / "d", when="2025-03-04T11:00:00+00:00", temperature_c=22.0)
    assert near.find("PW09", WHEN, 22.0)[0].path == path
    path.unlink()
    assert path not in [one.path for one in near.find("PW09", WHEN, 22.0)]


def test_a_calibration_at_another_rig_is_not_usable_here(
    near: NearestCalibrations, tmp_path: Path, triad: Calibration
) -> None:
    shared = f"sqlite:///{tmp_path / 'shared.db'}"
    other = tmp_path / "other rig"
    calibrated(triad, other / "x", when="2025-03-04T10:00:00+00:00", temperature_c=22.0)
    with Archive(other, shared) as archive:
        archive.refresh()
    with Archive(tmp_path) as archive:
        text = (tmp_path / "archive.json").read_text("utf-8")
    (tmp_path / "archive.json").write_text(
        text.replace('"database": ""', f'"database": "{shared}"')
    )
    found = near.find("PW09", WHEN, 22.0)
    assert all(tmp_path in one.path.parents for one in found)
    assert [one.path.parent.name for one in found][:1] != ["x"] or found[0].path.is_file()


def test_without_a_folder_or_a_device_there_is_nothing(tmp_path: Path) -> None:
    assert NearestCalibrations(lambda: tmp_path / "none").find("PW09", WHEN) == ()
    assert NearestCalibrations(lambda: tmp_path).find("", WHEN) == ()
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "archive.json").write_text("{", "utf-8")
    with pytest.raises(FormatError):
        NearestCalibrations(lambda: tmp_path).find("PW09", WHEN)


def test_the_start_of_the_window_loads_no_database() -> None:
    program = "import sys, gui.nearest, gui.services; print('sqlalchemy' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.strip() == "False"
