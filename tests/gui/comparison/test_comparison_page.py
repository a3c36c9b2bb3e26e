"""Compare gyros: files in, one column a unit, the best marked, CSV out."""

import csv
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from core.records.legacy.reader import read_legacy
from gui.comparison.page import ComparisonPage, make_page
from gui.comparison.tables import BEST
from gui.services import Services

LEGACY = Path(__file__).parents[2] / "data" / "legacy"
TABLE = LEGACY / "RotationTable_202405151000.txt"
HEAD = next(
    path
    for path in sorted(LEGACY.glob("OpticalDividingHead_*.txt"))
    if read_legacy(path).layout.id == "clbdus_head"
)
NOISE = (
    "device,channel,term,symbol,method,convention,unit,value,u,lower95,upper95,upper_limit,"
    "regressed,file\n"
    "CVG25,z,random_walk,N,likelihood,w,deg/sqrt(s),2e-4,2e-6,1.9e-4,2.1e-4,0,,a\n"
    "CVG25,z,bias_instability,B,likelihood,w,deg/s,1.4e-5,1e-6,1.2e-5,1.6e-5,0,,a\n"
    "CVG26,z,random_walk,N,likelihood,w,deg/sqrt(s),5e-4,5e-6,4.9e-4,5.1e-4,0,,a\n"
)


@pytest.fixture
def page(qtbot: QtBot, services: Services) -> ComparisonPage:
    made = make_page(services)
    qtbot.addWidget(made.widget)
    qtbot.addWidget(made.side)
    return made


def add(page: ComparisonPage, qtbot: QtBot, *paths: Path) -> None:
    page.side.added.emit(list(paths))
    qtbot.waitUntil(lambda: not page.presenter.state.busy, timeout=10_000)


def rows(page: ComparisonPage) -> dict[str, tuple[str, ...]]:
    findings = page.presenter.state.findings
    assert findings is not None
    return {row[0]: row for row in findings.tables[0].rows}


def test_nothing_yet(page: ComparisonPage):
    assert page.presenter.state.findings is None
    assert page.content.currentWidget() is not page.content.findings
    page.exporting.export("csv", "a.csv")


def test_two_files_of_one_unit_and_the_noise_of_two_others(
    page: ComparisonPage, qtbot: QtBot, tmp_path: Path
):
    noise = tmp_path / "noise.csv"
    noise.write_text(NOISE, encoding="utf-8")
    add(page, qtbot, TABLE, HEAD, noise)
    state = page.presenter.state
    assert [row.name for row in state.rows] == ["ADXRS610 gyro_1", "Gyro31 gyro_1", "CVG25 z",
                                                "CVG26 z"]  # fmt: skip
    # Tables 3.2 and 3.3 bear different names: the operator says that they are one unit.
    first = page.side.list.topLevelItem(0)
    second = page.side.list.topLevelItem(1)
    first.setText(0, "ADXRS610")
    second.setText(0, "ADXRS610")
    qtbot.waitUntil(lambda: "ADXRS610" == page.presenter.state.rows[1].name)
    qtbot.waitUntil(lambda: "ADXRS610" == page.presenter.state.rows[0].name)
    findings = page.presenter.state.findings
    assert findings is not None
    assert findings.tables[0].header == ("Quantity", "Unit", "ADXRS610", "CVG25 z", "CVG26 z")
    found = rows(page)
    assert found["Scale factor"][2].startswith("−79.379 ± ")
    assert found["Acceleration-sensitive drift, largest axis"][2].startswith("−0.015 ± ")
    assert found["Acceleration-sensitive drift, largest axis"][1] == "(deg/s)/(m/s²)"
    walk = found["Angle random walk"]
    assert walk[2] == "not measured"
    assert walk[3].startswith(f"{BEST} 0.000200")
    assert BEST not in walk[4]
    texts = [note.text for note in findings.notes]
    assert any("ADXRS610: no angle random walk; add an Allan" in text for text in texts)
    assert page.content.currentWidget() is page.content.findings


def test_what_is_no_gyro_is_told_and_the_rest_goes_on(page: ComparisonPage, qtbot: QtBot):
    add(page, qtbot, LEGACY / "Accuracy_202405141110.txt", TABLE)
    assert len(page.presenter.state.rows) == 1
    banner = page.presenter._messages.current
    assert banner is not None
    assert "Accuracy_202405141110.txt is not compared" in banner.what
    key = page.presenter.state.rows[0].key
    page.side.removed.emit([key])
    assert page.presenter.state.findings is None


@pytest.mark.parametrize(("key", "separator", "mark"), [("csv", ",", "."), ("excel", ";", ",")])
def test_the_table_as_a_file(
    page: ComparisonPage, qtbot: QtBot, tmp_path: Path, key: str, separator: str, mark: str
):
    add(page, qtbot, TABLE)
    page.exporting.export(key, "out.csv")
    with (tmp_path / "out.csv").open(encoding="utf-8-sig", newline="") as file:
        lines = list(csv.reader(file, delimiter=separator))
    assert lines[0] == ["Quantity", "Unit", "ADXRS610 gyro_1"]
    assert lines[1][0] == "Scale factor"
    assert f"79{mark}379" in lines[1][2] or "79.379" in lines[1][2]
