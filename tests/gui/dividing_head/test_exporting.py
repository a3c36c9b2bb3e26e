"""Process Data and every format of Export."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from core.records.calibration_json import read_calibration
from core.records.open import read_any
from gui.dividing_head.formats import formats
from gui.exporting import Exporting
from gui.measuring.nominal import nominal_of
from tests.gui.desk import Desk


@pytest.fixture
def processed(desk: Desk, qtbot: QtBot) -> Desk:
    for _ in range(8):
        desk.measure()
    desk.presenter.act("process")
    qtbot.waitUntil(lambda: desk.results.state is not None, timeout=10_000)
    return desk


@pytest.fixture
def exporting(processed: Desk, tmp_path: Path) -> Exporting:
    return Exporting(
        "head",
        formats(),
        lambda: processed.results.state,
        lambda: tmp_path,
        processed.jobs,
        processed.messages,
    )


def test_every_format_is_proposed_a_name_and_written(
    processed: Desk, exporting: Exporting, tmp_path: Path, qtbot: QtBot
):
    keys = [key for key, _ in exporting.formats if key != "legacy clbacc"]
    assert {"json", "c", "mat", "csv", "excel", "run", "legacy pointer"} <= set(keys)
    for key in keys:
        path = Path(exporting.propose(key))
        assert path.parent == tmp_path
        exporting.export(key, str(path))
        qtbot.waitUntil(lambda path=path: processed.messages.current is not None, timeout=10_000)
        qtbot.waitUntil(path.is_file, timeout=10_000)
        assert path.stat().st_size > 100
        processed.messages.dismiss()
    assert read_calibration(tmp_path / "PW09_accelerometer.cal.json").provenance.device == "PW09"
    (legacy,) = tmp_path.glob("OpticalDividingHead_*.txt")
    assert len(read_any(legacy)) == 8


def test_a_name_without_a_folder_goes_to_the_sessions(
    processed: Desk, exporting: Exporting, tmp_path: Path, qtbot: QtBot
):
    exporting.export("c", "mine.h")
    qtbot.waitUntil((tmp_path / "mine.h").is_file)
    exporting.export("c", "  ")
    assert sorted(tmp_path.glob("*.h")) == [tmp_path / "mine.h"]


def test_a_folder_that_is_not_there_is_told(
    processed: Desk, exporting: Exporting, tmp_path: Path, qtbot: QtBot
):
    exporting.export("json", str(tmp_path / "no" / "such" / "x.json"))
    qtbot.waitUntil(lambda: processed.what == "Not exported")


def test_a_format_that_cannot_hold_the_run_says_why(
    processed: Desk, exporting: Exporting, tmp_path: Path, qtbot: QtBot
):
    exporting.export("legacy clbacc", str(tmp_path / "x.txt"))
    qtbot.waitUntil(lambda: processed.what == "Not exported")
    assert not (tmp_path / "x.txt").exists()


def test_processing_keeps_the_calibration_for_the_next_session(processed: Desk):
    state = processed.results.state
    assert state is not None
    assert len(state.matrices) == 2
    assert state.calibration.provenance.records
    nominal = nominal_of(processed.root, "PW09", "accelerometer")
    assert nominal is not None
    triad = state.calibration.triad()
    assert abs(nominal.k - triad.k).max() < 1e-6
    assert nominal_of(processed.root, "PW10", "accelerometer") is None
    assert nominal_of(processed.root, "No Name", "accelerometer") is None
    assert nominal_of(processed.root, "PW09", "gyro") is None


def test_closing_the_page_forgets_the_results(processed: Desk):
    processed.results.clear()
    assert processed.results.state is None
    assert not processed.presenter.state.has_results
