"""Tables, matrices and residuals as the operator sees, copies and hears them."""

import math

import pytest
from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QGuiApplication, QImage
from PySide6.QtWidgets import QLabel

from gui.widgets.chart_export import save_chart
from gui.widgets.colours import LIGHT
from gui.widgets.matrix_view import MatrixView
from gui.widgets.number_text import MINUS
from gui.widgets.residual_plot import ResidualPlot
from gui.widgets.result_table import ResultTable
from gui.widgets.states import MatrixState, ResidualSeries, ResidualState, TableState, Tone
from gui.widgets.table_text import number_cell, table_text

GAP = "\N{NARROW NO-BREAK SPACE}"
TABLE = TableState(
    "Parameters (Table 2.7)",
    "U = K·a + U0   (2.2)",
    ("Sensor", "Parameter", "Value", "±U (95 %)", "Unit"),
    (
        ("X", "U0", f"{MINUS}375.1", "3.2", "code"),
        ("X", "k_x", f"{MINUS}1334.90", "0.41", "code/(m/s²)"),
        ("Y", "3; 4", f"12{GAP}480", "—", "code"),
    ),
    2,
)


@pytest.fixture
def table(qtbot):
    widget = ResultTable()
    qtbot.addWidget(widget)
    widget.resize(700, 300)
    widget.show()
    widget.render(TABLE)
    return widget


def clipboard():
    return QGuiApplication.clipboard().text()


def test_numbers_as_spreadsheets_read_them():
    assert table_text(TABLE).splitlines() == [
        "Sensor\tParameter\tValue\t±U (95 %)\tUnit",
        "X\tU0\t-375.1\t3.2\tcode",
        "X\tk_x\t-1334.90\t0.41\tcode/(m/s²)",
        "Y\t3; 4\t12480\t—\tcode",
    ]
    comma = table_text(TABLE, separator=";", decimal=",").splitlines()
    assert comma[1] == "X;U0;-375,1;3,2;code"
    assert comma[3] == 'Y;"3; 4";12480;—;code'


def test_words_that_hold_numbers_stay():
    assert number_cell("1.25 ± 0.03", ",") == "1.25 ± 0.03"
    assert number_cell("2.4", ",") == "2,4"


def test_copy_takes_the_selection_or_all(table, qtbot):
    view = table._view
    qtbot.keyClick(view, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert len(clipboard().splitlines()) == 4
    view.selectRow(1)
    table.copy(separator=";", decimal=",")
    assert clipboard().splitlines()[1:] == ["X;k_x;-1334,90;0,41;code/(m/s²)"]


def test_numbers_right_and_units_left(table):
    model = table._view.model()
    sides = [
        model.index(0, column).data(Qt.ItemDataRole.TextAlignmentRole) & Qt.AlignmentFlag.AlignRight
        for column in range(5)
    ]
    assert [bool(side) for side in sides] == [False, False, True, True, False]


def test_points_are_under_one_another(table):
    model = table._view.model()
    shown = [model.index(row, 2).data() for row in range(3)]
    metrics = table._view.fontMetrics()
    tails = [
        metrics.horizontalAdvance(text)
        - metrics.horizontalAdvance(text[: text.find(".")] if "." in text else text.rstrip())
        for text in shown
    ]
    assert max(tails) - min(tails) <= 1


def test_table_is_as_high_as_its_rows(table, qtbot):
    qtbot.waitUntil(lambda: table._view.verticalScrollBar().maximum() == 0)
    labels = [label.text() for label in table.findChildren(QLabel) if label.isVisible()]
    assert labels == ["Parameters (Table 2.7)", "U = K·a + U0   (2.2)"]
    before = table.sizeHint().height()
    table.render(TableState("t", "", ("a",), (("1",),), 0))
    assert table.sizeHint().height() < before


def test_matrix_is_read_out_and_copied(qtbot):
    view = MatrixView()
    qtbot.addWidget(view)
    cells = (((f"{MINUS}1.50", "0.02"), ("0.10", "0.02")), (("0.20", ""), ("1.40", "0.02")))
    view.render(MatrixState("K =", cells, "code/(m/s²)", "U = K·a", ("x", "y")))
    view.show()
    assert "± 0.02" in view.accessibleDescription()
    qtbot.keyClick(view, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert clipboard() == "x\ty\n-1.50\t0.10\n0.20\t1.40\n"
    view.render(MatrixState("Q =", cells))
    qtbot.keyClick(view, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert clipboard() == "-1.50\t0.10\n0.20\t1.40\n"
    assert not view.grab().isNull()
    view.render(MatrixState("", ()))
    qtbot.keyClick(view, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert not view.grab().isNull()


@pytest.fixture
def residuals(qtbot):
    plot = ResidualPlot()
    qtbot.addWidget(plot)
    plot.resize(600, 300)
    plot.render(
        ResidualState(
            ("1: 0°", "2: 90°", "3: 180°"),
            (
                ResidualSeries("X", (0.5, -3.0, math.nan), (2.0, 2.0, 2.0)),
                ResidualSeries("Y", (1.0, 1.0, 1.0)),
            ),
            "code",
        )
    )
    plot.show()
    return plot


def test_what_is_out_of_its_band_is_named_and_signed(residuals):
    assert residuals.accessibleDescription() == f"X 2: 90° {MINUS}3.00"
    image = residuals.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    colours = {
        image.pixelColor(x, y).name() for x in range(image.width()) for y in range(image.height())
    }
    assert LIGHT.tones[Tone.BAD] in colours
    assert LIGHT.curves[1] in colours


def test_bars_go_the_way_of_their_sign(residuals):
    image = residuals.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    rows = [
        y
        for y in range(image.height() // 8, image.height())
        for x in range(image.width())
        if image.pixelColor(x, y) == QColor(LIGHT.curves[0])
    ]
    centre = residuals._places[0][0].center().y()
    up, down = centre - min(rows), max(rows) - centre
    assert down == pytest.approx(6 * up, rel=0.1)


def test_pointing_tells_the_value(residuals):
    residuals.grab()
    bar = residuals._places[2][0]
    assert residuals.words_at(bar.center()) == f"2: 90°, X: {MINUS}3.000 code (±2.0)"
    assert residuals.words_at(QPointF(1, 1)) == ""


def test_residuals_as_a_file(residuals, tmp_path):
    save_chart(residuals.paint, QSize(500, 300), tmp_path / "r.svg")
    assert "180°" in (tmp_path / "r.svg").read_text(encoding="utf-8")


def test_nothing_to_draw(qtbot):
    plot = ResidualPlot()
    qtbot.addWidget(plot)
    plot.show()
    assert not plot.grab().isNull()
    assert plot._reach() == 1.0
    assert not any(bar.contains(QPointF(10, 10)) for bar, _ in plot._places)
