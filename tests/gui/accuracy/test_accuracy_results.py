"""Load Data, pages, traces, limits and lists of the Accuracy tab; Tables 2.4 and 2.5 on screen."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QObject, QPointF, QSize
from PySide6.QtGui import QImage, QPainter
from pytestqt.qtbot import QtBot

from core.procedures.dividing_head import calibrate
from core.records.calibration_json import write_calibration
from core.records.legacy.reader import read_legacy
from core.samples.run import Conditions
from gui.accuracy.checking import NONE, CheckRequest, check_file
from gui.accuracy.graph_view import ErrorGraph
from gui.accuracy.page import AccuracyPage
from gui.accuracy.results import AccuracyResults
from gui.accuracy.results_view import AccuracyResultsView
from gui.accuracy.settings import AccuracySettings, settings_of
from gui.accuracy.state import PAGES, GraphState, Series
from gui.accuracy.tables import lab_table
from gui.accuracy.written import formats
from gui.jobs import Jobs
from gui.messages import Messages
from gui.widgets.states import BannerState

LEGACY = Path(__file__).parents[2] / "data" / "legacy"
PITCH = LEGACY / "Accuracy_202405141110.txt"
G = 9.8106


def positions() -> Path:
    """Table 2.2."""
    return next(
        path
        for path in sorted(LEGACY.rglob("OpticalDividingHead_*.txt"))
        if read_legacy(path).layout.id == "pointer"
    )


@pytest.fixture
def root(tmp_path: Path) -> Path:
    made = calibrate(read_legacy(positions()).to_run(), Conditions(g_mps2=G))
    (tmp_path / "20240514_0930_PW09").mkdir()
    write_calibration(made, tmp_path / "20240514_0930_PW09" / "calibration.cal.json")
    return tmp_path


Load = Callable[..., AccuracyPage]


@pytest.fixture
def results(qapp: QObject, root: Path) -> AccuracyResults:
    return AccuracyResults("accuracy", Jobs(), Messages(), lambda: root)


@pytest.fixture
def load(results: AccuracyResults, qtbot: QtBot) -> Load:
    def act(path: Path = PITCH, **changes: object) -> AccuracyPage:
        results.load(path, replace(AccuracySettings(), **changes))
        qtbot.waitUntil(lambda: not results.busy, timeout=10_000)
        assert isinstance(results.page, AccuracyPage)
        return results.page

    return act


def test_table_2_5_with_the_calibration_of_table_2_2(load: Load, results: AccuracyResults):
    page = load(limit_deg=0.05)
    assert page.title == "PW09: pitch accuracy, 3 angles"
    assert "20240514_0930_PW09" in page.rule
    state = results.state
    assert state is not None
    lab = lab_table(state.found)
    assert [row[0] for row in lab.rows] == ["0", "30", "60"]
    # The unit's own pitch, then what the practicum's formulas make of the codes.
    assert [row[1] for row in lab.rows] == ["0.03", "30.02", "60.00"]
    assert [row[8] for row in lab.rows] == ["−0.0116", "30.0267", "60.0590"]
    assert [row[7] for row in lab.rows] == ["9.7943", "8.4830", "4.8926"]
    verdicts = {chip.name: chip.verdict for chip in page.chips}
    assert verdicts["Inter"] == "PASS"
    assert verdicts["Calibration"] == "FAIL"
    assert next(c.why for c in page.chips if c.name == "Calibration").startswith(
        "largest error 0.0590° at 60°"
    )


def test_without_a_calibration_the_unit_is_judged_alone_and_that_is_said(load: Load):
    page = load(calibration=NONE)
    assert [chip.name for chip in page.chips] == ["Inter", "Mags/Accels", "Tilter axes aligned"]
    assert "the unit's own angles alone" in page.rule
    assert any("no calibration was chosen" in note.text for note in page.notes)


def test_no_limit_no_verdict(load: Load):
    page = load(limit_deg=0.0)
    assert {chip.verdict for chip in page.chips} == {""}
    assert page.rule.startswith("No limit is stated")
    assert page.graph.limit == 0.0


def test_a_calibration_that_is_none_is_told_and_left_out(load: Load, root: Path):
    (root / "broken.cal.json").write_text("{}", encoding="utf-8")
    page = load(calibration=str(root / "broken.cal.json"))
    assert "Calibration" not in [chip.name for chip in page.chips]
    assert any("broken.cal.json is not used" in note.text for note in page.notes)


@pytest.mark.parametrize("key", PAGES[:4])
def test_every_page_of_the_graph(load: Load, results: AccuracyResults, key: str):
    load()
    results.show_page(key)
    assert isinstance(results.page, AccuracyPage)
    graph = results.page.graph
    assert results.page.shown == key
    assert graph.series
    assert (graph.low, graph.high) == (0.0, 90.0)
    assert graph.series[0].x == (0.0, 30.0, 60.0)


def test_a_file_without_temperatures_says_so(load: Load, results: AccuracyResults):
    load()
    results.show_page("temperature")
    assert isinstance(results.page, AccuracyPage)
    assert results.page.graph.series == ()
    assert "no temperature" in results.page.graph.hint


def test_traces_are_hidden_and_shown(load: Load, results: AccuracyResults):
    load()
    results.show_trace("inter", False)
    assert isinstance(results.page, AccuracyPage)
    assert "Inter" not in [series.name for series in results.page.graph.series]
    results.show_trace("inter", True)
    assert "Inter" in [series.name for series in results.page.graph.series]


def test_the_angle_of_now_stands_in_the_page_current(load: Load, results: AccuracyResults):
    load()
    results.show_page("current")
    results.set_level(29.5)
    assert isinstance(results.page, AccuracyPage)
    assert results.page.graph.level == 29.5
    results.set_level(float("nan"))
    assert np.isnan(results.page.graph.level)


def test_another_list_of_set_angles(load: Load, results: AccuracyResults, qtbot: QtBot):
    load()
    settings = AccuracySettings()
    assert "3 rows" in results.take_angles("0, 30", "pitch", settings)
    assert results.take_angles("0, 30, 59.9", "pitch", settings) == ""
    qtbot.waitUntil(lambda: not results.busy, timeout=10_000)
    state = results.state
    assert state is not None
    assert state.found.trace("inter").error == pytest.approx([0.03, 0.02, 0.10])
    # It stays with the file when limit or rule become others.
    results.process_again(replace(settings, limit_deg=0.2))
    qtbot.waitUntil(lambda: not results.busy, timeout=10_000)
    assert results.state is not None
    assert results.state.found.set_deg == pytest.approx([0.0, 30.0, 59.9])


def test_what_is_no_accuracy_check_is_refused(results: AccuracyResults, qtbot: QtBot):
    shown: list[BannerState | None] = []
    results._messages.shown.connect(shown.append)
    results.load(positions(), AccuracySettings())
    qtbot.waitUntil(lambda: not results.busy, timeout=10_000)
    assert results.page is None
    assert shown[-1] is not None
    assert "no accuracy check" in f"{shown[-1].meaning} {shown[-1].what}"


@pytest.mark.parametrize("key", [one.key for one in formats()])
def test_every_file_of_a_check(root: Path, tmp_path: Path, key: str):
    request = CheckRequest(Conditions(g_mps2=G, head_u_arcsec=10.0), "nearest", root)
    checked = check_file(PITCH, None, request)
    one = next(one for one in formats() if one.key == key)
    path = tmp_path / one.name(checked)
    one.write(checked, path)
    if key in ("legacy", "run"):
        again = check_file(path, None, request)
        for trace in checked.found.traces:
            assert again.found.trace(trace.source).error == pytest.approx(trace.error, abs=6e-3)
    else:
        text = path.read_text(encoding="utf-8-sig")
        assert "Pitch Accuracy, deg" in text
        assert "30.0267" in text or "30,0267" in text


def test_settings_survive_and_nonsense_takes_its_default():
    settings = replace(AccuracySettings(), limit_deg=0.25, rule="simple", calibration="/a/b.json")
    assert settings_of(settings.to_section()) == settings
    assert settings_of({"limit_deg": -3, "rule": "no", "plan_id": 5}) == AccuracySettings()


def test_the_page_as_widgets(load: Load, qtbot: QtBot):
    view = AccuracyResultsView()
    qtbot.addWidget(view)
    view.resize(900, 700)
    view.show()
    page = load(limit_deg=0.05)
    view.render(page)
    assert [chip.verdict for chip in view.chips] == [chip.verdict for chip in page.chips]
    names = [view.tabs.tabText(i) for i in range(view.tabs.count())]
    assert names == ["Pitch Error", "Roll", "Heading", "Current Pitch", "Temperature"]
    with qtbot.waitSignal(view.page_chosen) as chosen:
        view.tabs.setCurrentIndex(2)
    assert chosen.args == ["heading"]
    with qtbot.waitSignal(view.trace_toggled) as toggled:
        view.toggles["inter"].click()
    assert toggled.args == ["inter", False]
    view.graph.grab()
    point, words = view.graph._points[0]
    assert view.graph.words_at(point) == words
    assert "Calibration, 0°" in words
    assert view.graph.words_at(point + QPointF(0, 500)) == ""


@pytest.mark.parametrize(
    "state",
    [
        GraphState(hint="nothing"),
        GraphState("t", "deg", (Series("a", 0, (0.0,), (float("nan"),)),)),
        GraphState("t", "deg", (Series("a", 8, (0.0,), (0.0,)),), limit=0.1),
        GraphState("t", "deg", (Series("a", 3, (0.0, 1.0), (1.0, 2.0), (0.1, 0.1)),), limit=99.0),
    ],
)
def test_graphs_of_nothing_of_one_point_and_of_far_limits(qtbot: QtBot, state: GraphState):
    graph = ErrorGraph()
    qtbot.addWidget(graph)
    graph.render(state)
    image = QImage(QSize(500, 300), QImage.Format.Format_RGB32)
    painter = QPainter(image)
    graph.paint(painter, image.size())
    painter.end()
    colours = {image.pixel(x, y) for x in range(0, 500, 5) for y in range(0, 300, 3)}
    assert len(colours) > 1
