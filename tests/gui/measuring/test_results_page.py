"""Every kind of part on the results page, and an export of anything."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from core.errors import Note, Severity, StorageError
from gui.exporting import ExportFormat, Exporting
from gui.jobs import Jobs
from gui.measuring.curve_view import CurveView
from gui.measuring.page import CurveState, ResultsPage
from gui.measuring.results_view import ResultsView
from gui.messages import Messages
from gui.widgets.matrix_view import MatrixView
from gui.widgets.note_line import NoteLine
from gui.widgets.residual_plot import ResidualPlot
from gui.widgets.result_table import ResultTable
from gui.widgets.states import MatrixState, ResidualSeries, ResidualState, TableState

NOTE = Note(Severity.WARNING, "bent", "the straight line is rejected")
TABLE = TableState("Rates", "", ("Sensor", "k"), (("gyro_1", "1"),))
CURVE = CurveState(
    "Errors",
    "Set rate, deg/s",
    "Error, deg/s",
    (
        ("gyro_1", (-1.0, 0.0, 1.0), (0.1, -0.2, 0.1), (0.05, 0.05, 0.05)),
        ("gyro_2", (-1.0, 0.0, 1.0), (0.0, 0.1, 0.0), ()),
    ),
)
PAGE = ResultsPage(
    "Gyro31, 3 rates",
    "a session",
    (
        TABLE,
        NOTE,
        CURVE,
        ResidualState(("1",), (ResidualSeries("x", (1.0,)),)),
        (MatrixState("K =", ((("1", ""),),)), MatrixState("U0 =", ((("2", ""),),))),
    ),
)


def count(view: ResultsView, kind: type[QWidget]) -> int:
    return len([part for part in view.findChildren(kind) if part.isVisibleTo(view)])


def test_each_part_has_its_widget_in_the_order_of_reading(qtbot: QtBot):
    view = ResultsView()
    qtbot.addWidget(view)
    view.resize(700, 900)
    view.show()
    view.render(PAGE)
    qtbot.wait(10)
    kinds = (ResultTable, NoteLine, CurveView, ResidualPlot)
    assert [count(view, kind) for kind in kinds] == [1, 1, 1, 1]
    assert count(view, MatrixView) == 2
    places = [view._column.itemAt(i).widget() for i in range(4)]
    assert [type(place) for place in places] == list(kinds)
    assert (PAGE.notes, PAGE.tables) == ((NOTE,), (TABLE,))
    view.render(ResultsPage("", "", ()))
    qtbot.wait(10)
    assert [count(view, kind) for kind in kinds] == [0, 0, 0, 0]


def test_exports_are_named_and_written_and_their_failures_told(qtbot: QtBot, tmp_path: Path):
    def refuse(state: object, path: Path) -> None:
        raise StorageError(f"{path} is full")

    messages, jobs = Messages(), Jobs()
    current: list[str] = []
    exporting = Exporting(
        "test",
        (
            ExportFormat("text", "Text", lambda s: f"{s}.txt", lambda s, path: path.write_text(s)),
            ExportFormat("never", "Never", lambda s: f"{s}.no", refuse),
        ),
        lambda: current[0] if current else None,
        lambda: tmp_path,
        jobs,
        messages,
    )
    assert exporting.formats == (("text", "Text"), ("never", "Never"))
    assert exporting.propose("text") == ""
    exporting.export("text", "x.txt")
    current.append("rates")
    assert exporting.propose("text") == str(tmp_path / "rates.txt")
    exporting.export("text", "rates.txt")
    qtbot.waitUntil(lambda: messages.current is not None)
    assert (tmp_path / "rates.txt").read_text() == "rates"
    exporting.export("never", "rates.no")
    qtbot.waitUntil(lambda: messages.current.what == "Not exported")
    jobs.close()


@pytest.mark.parametrize("joined", [True, False])
def test_a_curve_names_its_axes(qtbot: QtBot, joined: bool):
    view = CurveView(CurveState("t", "x, s", "y, V", CURVE.series, joined))
    qtbot.addWidget(view)
    assert view.plot.accessibleName() == "y, V / x, s"
