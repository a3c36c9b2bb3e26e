"""The Archive tab as an operator uses it."""

import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from core.errors import Severity
from core.procedures.calibration import Calibration
from gui.archive.tab import ArchiveTab
from tests.core.archive.conftest import SPECIMENS, calibrated, measured
from tests.gui.archive.conftest import settle, show


def cells(tab: ArchiveTab, column: int) -> list[str]:
    return [row.cells[column] for row in tab.presenter.state.rows]


def choose(tab: ArchiveTab, qtbot: QtBot, *places: int) -> None:
    rows = tab.presenter.state.rows
    tab.presenter.choose([rows[place].id for place in places])
    settle(tab, qtbot)


def places_of(tab: ArchiveTab, kind: str, serial: str = "PW09") -> list[int]:
    rows = enumerate(tab.presenter.state.rows)
    return [place for place, row in rows if row.cells[:2] == (serial, kind)]


def test_the_index_is_opened_when_the_tab_is_first_seen(
    tab: ArchiveTab, qtbot: QtBot, filled: Path
) -> None:
    assert not (filled / "archive.db").exists()
    show(tab, qtbot)
    assert (filled / "archive.db").exists()
    assert tab.presenter.state.status == "7 found"
    assert cells(tab, 0) == ["PW10"] + ["PW09"] * 6


def test_an_empty_archive_tells_what_will_be_in_it(tab: ArchiveTab, qtbot: QtBot) -> None:
    show(tab, qtbot)
    assert tab.view.hint.isVisible()
    assert "Import Folder" in tab.view.hint.text()
    assert not tab.view.action_bar.button("open").isEnabled()
    assert tab.view.action_bar.button("import").isEnabled()


def test_words_and_kind_narrow_the_list(tab: ArchiveTab, qtbot: QtBot, filled: Path) -> None:
    show(tab, qtbot)
    qtbot.keyClicks(tab.view.search, "pw09 2024")
    settle(tab, qtbot)
    assert cells(tab, 1) == ["calibration", "session"]
    tab.view.search.clear()
    tab.view.kind.setCurrentIndex(tab.view.kind.findData("session"))
    tab.view.kind.activated.emit(1)
    settle(tab, qtbot)
    assert set(cells(tab, 1)) == {"session"}
    assert len(cells(tab, 1)) == 4


def test_a_calibration_shows_its_parameters_and_their_history(
    tab: ArchiveTab, qtbot: QtBot, filled: Path
) -> None:
    (filled / "limits.toml").write_text(
        '[[limit]]\nparameter = "bias"\nunit = "code"\nlow = -400\nhigh = -370\n', "utf-8"
    )
    show(tab, qtbot)
    choose(tab, qtbot, places_of(tab, "calibration")[0])
    state = tab.presenter.state
    assert state.findings is not None
    parameters = state.findings.tables[0]
    assert parameters.rows[0][:2] == ("acc_x", "bias")
    assert parameters.rows[0][-1] == "fail"
    assert state.parameters[state.parameter] == "acc_x  bias"
    assert state.history is not None
    assert state.history.values.tolist() == pytest.approx([-378.75, -377.75, -348.75], abs=0.01)
    assert state.history.expanded[0] == pytest.approx(3.2, abs=0.05)
    assert state.history.chosen.tolist() == [2]
    assert (state.history.low, state.history.high) == (-400.0, -370.0)
    assert not tab.view.hint.isVisible()
    statistics = dict(row[:2] for row in state.findings.tables[-1].rows)
    spread = np.std(state.history.values, ddof=1)
    assert float(statistics["repeatability s"]) == pytest.approx(spread, rel=0.03)
    tab.view.parameter.activated.emit(1)
    settle(tab, qtbot)
    followed = tab.presenter.state
    assert followed.parameters[followed.parameter] == "acc_x  scale factor"
    assert followed.history is not None
    assert followed.history.unit == "code/(m/s^2)"


def test_only_calibrations_at_one_temperature_count(
    tab: ArchiveTab, qtbot: QtBot, root: Path, triad: Calibration
) -> None:
    for year, bias, warmth in ((2023, 0.0, 21.0), (2024, 9.0, 39.5), (2025, 2.0, 22.0)):
        when = f"{year}-03-01T10:00:00+00:00"
        folder = measured(root / f"{year}0301_PW09", started=when)
        calibrated(triad, folder, when=when, bias=bias, temperature_c=warmth)
    show(tab, qtbot)
    choose(tab, qtbot, places_of(tab, "calibration")[0])
    box = tab.view.temperature
    texts = [box.itemText(place) for place in range(box.count())]
    assert texts == ["all temperatures", "22 ± 5 °C", "40 ± 5 °C"]
    history = tab.presenter.state.history
    assert history is not None
    assert history.counted.tolist() == [1, 1, 1]
    box.setFocus()
    qtbot.keyClick(box, Qt.Key.Key_Down)
    settle(tab, qtbot)
    state = tab.presenter.state
    assert state.history is not None
    assert state.findings is not None
    assert state.history.counted.tolist() == [1, 0, 1]
    assert state.history.spread == pytest.approx(2.0 / 2**0.5)
    assert state.findings.tables[-1].title == "History of acc_x  bias, 2 calibrations"
    assert "1 calibrations not at about 21.5 °C" in state.findings.notes[-1].text
    tab.view.parameter.activated.emit(1)
    settle(tab, qtbot)
    assert tab.presenter.state.temperature == 1
    qtbot.keyClick(box, Qt.Key.Key_Up)
    settle(tab, qtbot)
    assert box.currentIndex() == 0
    assert tab.presenter.state.history is not None
    assert tab.presenter.state.history.counted.tolist() == [1, 1, 1]


def test_a_unit_that_was_never_at_the_chosen_temperature_is_followed_at_all(
    tab: ArchiveTab, qtbot: QtBot, filled: Path, triad: Calibration
) -> None:
    other = measured(filled / "20260301_PW12", device="PW12", started="2026-03-01T10:00:00+00:00")
    calibrated(triad, other, device="PW12", when="2026-03-01T10:00:00+00:00", temperature_c=-30.0)
    show(tab, qtbot)
    choose(tab, qtbot, places_of(tab, "calibration")[0])
    tab.presenter.at(1)
    settle(tab, qtbot)
    assert tab.presenter.state.temperature == 1
    choose(tab, qtbot, places_of(tab, "calibration", "PW12")[0])
    assert tab.presenter.state.temperature == 0
    assert tab.presenter.state.history is not None
    assert tab.presenter.state.history.counted.tolist() == [1]


def test_two_calibrations_are_compared(tab: ArchiveTab, qtbot: QtBot, filled: Path) -> None:
    show(tab, qtbot)
    newest, middle, _ = places_of(tab, "calibration")
    model = tab.view.table.model()
    viewport = tab.view.table.viewport()
    none, control = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ControlModifier
    for place, key in ((newest, none), (middle, control)):
        spot = tab.view.table.visualRect(model.index(place, 0)).center()
        qtbot.mouseClick(viewport, Qt.MouseButton.LeftButton, key, spot)
        settle(tab, qtbot)
    findings = tab.presenter.state.findings
    assert findings is not None
    assert findings.title == "PW09: 2024-03-01 → 2025-03-01"
    assert findings.source == "1 of 12 parameters differ by more than 2 u"
    bias = findings.tables[0].rows[0]
    assert bias[:3] == ("acc_x", "bias", "differs")
    assert float(bias[3]) == pytest.approx(29.0 / (1.1453 * 2**0.5), abs=0.06)
    assert [row[2] for row in findings.tables[0].rows[1:]] == [""] * 11
    history = tab.presenter.state.history
    assert history is not None
    assert history.chosen.tolist() == [1, 2]


def test_a_session_is_offered_its_nearest_calibrations_and_opens_in_its_tab(
    tab: ArchiveTab, qtbot: QtBot, filled: Path, opened: list[tuple[str, Path]]
) -> None:
    show(tab, qtbot)
    choose(tab, qtbot, places_of(tab, "session")[1])
    findings = tab.presenter.state.findings
    assert findings is not None
    proposals = findings.tables[1]
    assert "Nearest" in proposals.title
    assert proposals.rows[0][1] == "0.0"
    tab.presenter.act("open")
    choose(tab, qtbot, places_of(tab, "calibration")[1])
    tab.view.table.opened.emit()
    folder = filled / "20240301_PW09"
    assert opened == [("Dividing head", folder), ("Dividing head", folder)]


def test_a_calibration_without_its_session_is_shown_here_only(
    tab: ArchiveTab, qtbot: QtBot, root: Path, triad: Calibration
) -> None:
    calibrated(triad, root / "alone")
    show(tab, qtbot)
    choose(tab, qtbot, 0)
    button = tab.view.action_bar.button("open")
    assert not button.isEnabled()
    assert "shown here" in button.toolTip()


def test_a_certificate_is_made_of_one_entry(
    tab: ArchiveTab, qtbot: QtBot, filled: Path, opened: list[tuple[str, Path]]
) -> None:
    show(tab, qtbot)
    assert not tab.view.action_bar.button("certificate").isEnabled()
    choose(tab, qtbot, places_of(tab, "session")[1])
    qtbot.mouseClick(tab.view.action_bar.button("certificate"), Qt.MouseButton.LeftButton)
    assert opened == [("Certificates", filled / "20240301_PW09")]
    choose(tab, qtbot, *places_of(tab, "calibration")[:2])
    assert not tab.view.action_bar.button("certificate").isEnabled()


def test_old_files_are_imported_with_a_report(
    tab: ArchiveTab, qtbot: QtBot, root: Path, opened: list[tuple[str, Path]]
) -> None:
    show(tab, qtbot)
    tab.presenter.import_folder(str(SPECIMENS))
    settle(tab, qtbot)
    findings = tab.presenter.state.findings
    assert findings is not None
    assert findings.source == "6 taken, 1 not known"
    assert findings.tables[0].rows[0][0] == "not known"
    assert tab.presenter.state.status == "6 found"
    place = cells(tab, 6).index("accuracy")
    choose(tab, qtbot, place)
    tab.presenter.act("open")
    assert opened[-1][0] == "Accuracy"
    told = tab.presenter._messages.current
    assert told is not None
    assert "no tab Accuracy" in told.what
    tab.presenter.import_folder(str(root / "imported"))
    settle(tab, qtbot)
    shown = tab.presenter._messages.current
    assert shown is not None
    assert shown.severity is Severity.ERROR
    assert "archive itself" in shown.meaning


def test_a_session_without_raw_bytes_says_so(tab: ArchiveTab, qtbot: QtBot, filled: Path) -> None:
    show(tab, qtbot)
    choose(tab, qtbot, places_of(tab, "session")[0])
    tab.presenter.act("reprocess")
    settle(tab, qtbot)
    findings = tab.presenter.state.findings
    assert findings is not None
    assert findings.source == "0 of 2 positions give the same means"
    assert findings.notes[0].text == "its raw bytes were not recorded"


def test_a_new_session_comes_by_itself_when_the_tab_is_seen_again(
    tab: ArchiveTab, qtbot: QtBot, filled: Path
) -> None:
    show(tab, qtbot)
    tab.view.hide()
    measured(filled / "20250501_PW11", device="PW11", started="2025-05-01T10:00:00+00:00")
    show(tab, qtbot)
    assert cells(tab, 0)[0] == "PW11"


def test_what_is_chosen_stays_chosen_when_the_list_changes(
    tab: ArchiveTab, qtbot: QtBot, filled: Path
) -> None:
    show(tab, qtbot)
    choose(tab, qtbot, places_of(tab, "calibration")[1])
    chosen = tab.presenter.state.chosen
    tab.presenter.look_for("2024", "")
    settle(tab, qtbot)
    assert tab.presenter.state.chosen == chosen
    selected = tab.view.table.selectionModel().selectedRows()
    assert [tab.presenter.state.rows[index.row()].id for index in selected] == list(chosen)
    tab.presenter.look_for("PW10", "")
    settle(tab, qtbot)
    assert tab.presenter.state.chosen == ()
    assert tab.presenter.state.findings is None


def test_the_tables_are_exported(tab: ArchiveTab, qtbot: QtBot, filled: Path) -> None:
    show(tab, qtbot)
    choose(tab, qtbot, places_of(tab, "calibration")[0])
    tab.view.findings.foot.export()
    (path,) = (filled / "exports").iterdir()
    lines = path.read_text("utf-8-sig").splitlines()
    assert lines[0].startswith("PW09, 2025-03-01")
    assert any(line.startswith("acc_x,bias,-348.8,3.2,code") for line in lines)


def test_a_damaged_calibration_is_marked_and_its_reason_told(
    tab: ArchiveTab, qtbot: QtBot, filled: Path
) -> None:
    path = filled / "20250301_PW09" / "calibration.cal.json"
    path.write_text(path.read_text("utf-8")[:200], "utf-8")
    show(tab, qtbot)
    place = cells(tab, 3).index("damaged")
    model = tab.view.table.model()
    assert model.data(model.index(place, 3)) == "✕ damaged"
    choose(tab, qtbot, place)
    findings = tab.presenter.state.findings
    assert findings is not None
    assert "damaged JSON" in findings.notes[0].text


def test_a_folder_that_cannot_be_opened_is_told_and_harms_nothing(
    tab: ArchiveTab, qtbot: QtBot, root: Path
) -> None:
    (root / "archive.json").write_text("{", "utf-8")
    show(tab, qtbot)
    shown = tab.presenter._messages.current
    assert shown is not None
    assert "archive.json" in shown.meaning
    (root / "archive.json").unlink()
    tab.presenter.act("refresh")
    settle(tab, qtbot)
    assert tab.presenter.state.status == "0 found"


def test_a_long_look_is_told_and_broken_off_by_closing(
    tab: ArchiveTab, qtbot: QtBot, root: Path, triad: Calibration
) -> None:
    for number in range(450):
        calibrated(triad, root / f"s{number}")
    told: list[str] = []
    tab.presenter.changed.connect(lambda state: told.append(state.status))
    tab.view.show()
    qtbot.waitUntil(lambda: any("200 of 451" in status for status in told), timeout=30_000)
    begin = time.monotonic()
    tab.close()
    assert time.monotonic() - begin < 4.0


def test_a_start_of_the_window_loads_no_database() -> None:
    program = "import sys, gui.archive.tab; print('sqlalchemy' in sys.modules)"
    root = Path(__file__).parents[3]
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=root, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "False"
