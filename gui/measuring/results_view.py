"""The results page beside the stage: tables with their equations, residuals, doubts, export."""

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from core.errors import Note
from gui.languages.shown import shown
from gui.measuring.page import CurveState, ResultsPage
from gui.widgets.export_foot import ExportFoot
from gui.widgets.matrix_view import MatrixView
from gui.widgets.note_line import NoteLine
from gui.widgets.page_scroll import PageScroll
from gui.widgets.residual_plot import ResidualPlot
from gui.widgets.result_table import ResultTable
from gui.widgets.states import MatrixState, ResidualState, TableState
from gui.widgets.word_label import WordLabel


class ResultsView(QWidget):
    """Shows a `ResultsPage`."""

    closed = Signal()
    certificate_requested = Signal()
    explain_requested = Signal()
    """The model of the page is to be compared with its rows."""
    take_out_requested = Signal()
    """The page is to be made without the added effects."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state: ResultsPage | None = None
        unit = self.fontMetrics().height()
        self._title, self._source = WordLabel(), WordLabel()
        font = self._title.font()
        font.setBold(True)
        font.setPointSizeF(font.pointSizeF() * 1.3)
        self._title.setFont(font)
        self._close = QToolButton()
        self._close.setText("✕")
        self._close.setAutoRaise(True)
        self._close.clicked.connect(self.closed)
        self.explain = QPushButton()
        self.explain.clicked.connect(self.explain_requested)
        head = QHBoxLayout()
        head.addWidget(self._title)
        head.addSpacing(unit // 2)
        # The name of a session is long; cut short it costs less than a page that cannot shrink.
        self._source.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        head.addWidget(self._source, 1)
        self.certificate = QPushButton()
        self.certificate.clicked.connect(self.certificate_requested)
        head.addWidget(self.explain)
        head.addWidget(self.certificate)
        head.addWidget(self._close)
        self._with, self.take_out = WordLabel(), QPushButton()
        self._with.setWordWrap(True)
        self.take_out.clicked.connect(self.take_out_requested)
        self._bent = QWidget()
        row = QHBoxLayout(self._bent)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self._with, 1)
        row.addWidget(self.take_out)
        self._bent.hide()
        self._page = QWidget()
        self._column = QVBoxLayout(self._page)
        self._column.setContentsMargins(0, 0, unit // 2, unit)
        self._column.setSpacing(unit // 2)
        self.foot = ExportFoot()
        column = QVBoxLayout(self)
        column.setContentsMargins(unit, unit // 2, unit // 2, unit // 2)
        column.setSpacing(unit // 2)
        column.addLayout(head)
        column.addWidget(self._bent)
        column.addWidget(PageScroll(self._page), 1)
        column.addWidget(self.foot)
        self._retranslate()

    def render(self, state: ResultsPage | None) -> None:
        """Show a state."""
        if state is self._state or state is None:
            self._state = state
            return
        self._state = state
        self._title.setText(state.title)
        self._source.setText(state.source)
        self._source.setToolTip(state.source)
        self._name_effects()
        while item := self._column.takeAt(0):
            if (old := item.widget()) is not None:
                old.hide()
                old.deleteLater()
        for part in state.parts:
            self._column.addWidget(_VIEWS[type(part)](part, self.fontMetrics().height()))
        self._column.addStretch(1)

    def _name_effects(self) -> None:
        effects = () if self._state is None else self._state.effects
        self._bent.setVisible(bool(effects))
        names = "; ".join(shown(name) for name in effects)
        self._with.setText(self.tr("With: {effects}").format(effects=names))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self.certificate.setText(self.tr("Certificate"))
        self.certificate.setToolTip(self.tr("Make a calibration certificate of these results"))
        self._close.setToolTip(self.tr("Close the results"))
        self._close.setAccessibleName(self._close.toolTip())
        self.explain.setText(self.tr("Model vs data"))
        self.explain.setToolTip(self.tr("Compare the model with the rows: find out what it lacks"))
        self.take_out.setText(self.tr("Take Out"))
        self.take_out.setToolTip(self.tr("Calibrate by the plain model again"))
        self._name_effects()


def _table(table: TableState, unit: int) -> QWidget:  # noqa: ARG001
    view = ResultTable()
    view.render(table)
    return view


def _matrices(matrices: tuple[MatrixState, ...], unit: int) -> QWidget:  # noqa: ARG001
    """Matrices of one equation stand in one row."""
    line = QWidget()
    row = QHBoxLayout(line)
    row.setContentsMargins(0, 0, 0, 0)
    for matrix in matrices:
        view = MatrixView()
        view.render(matrix)
        row.addWidget(view)
    row.addStretch(1)
    return line


def _residuals(state: ResidualState, unit: int) -> QWidget:
    plot = ResidualPlot()
    plot.render(state)
    plot.setMinimumHeight(14 * unit)
    return plot


def _curve(state: CurveState, unit: int) -> QWidget:
    # pyqtgraph is slow to import, and the page is not there when the window starts.
    from gui.measuring.curve_view import CurveView

    view = CurveView(state)
    view.setMinimumHeight(16 * unit)
    return view


def _note(note: Note, unit: int) -> QWidget:  # noqa: ARG001
    return NoteLine(note)


_VIEWS: dict[type, Callable[[Any, int], QWidget]] = {
    TableState: _table,
    tuple: _matrices,
    ResidualState: _residuals,
    CurveState: _curve,
    Note: _note,
}
"""How each kind of part is shown; the height of a line of text goes with it."""
