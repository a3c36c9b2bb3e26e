"""The widget of a measuring tab: plan left, stage middle, results right, actions below."""

from typing import Any

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QKeySequence, QPalette, QResizeEvent, QShortcut, QShowEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QSplitter,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from gui.languages.shown import shown
from gui.measuring.live_view import LiveTable
from gui.measuring.presenter import MeasuringPresenter
from gui.measuring.results_view import ResultsView
from gui.measuring.settings_view import SettingsForm
from gui.measuring.state import MeasuringState
from gui.widgets.action_bar import ActionBar
from gui.widgets.fields import ChoiceField
from gui.widgets.side_scroll import SideScroll
from gui.widgets.stage import Stage
from gui.widgets.states import Tone
from gui.widgets.step_list import StepList

_LIVE_MS = 250
_NO_LIMIT = 16777215
"""Qt's own largest size of a widget."""
_MANY = 4
"""From so many sensors the live table stands beside the graph."""
_WIDE = 92
"""Width in line heights from which stage and results have room side by side, long words too."""


class MeasuringView(QWidget):
    """The widget of the tab.

    Parameters
    ----------
    presenter : what clicks call, and what is rendered
    settings : the form of the operator's settings
    results : the results page; None for the common one
    """

    file_chosen = Signal(str)
    """Load Data: the file that the operator picked."""

    def __init__(
        self,
        presenter: MeasuringPresenter[Any],
        settings: SettingsForm[Any],
        results: ResultsView | None = None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self.stage = Stage()
        self.steps = StepList()
        self.action_bar = ActionBar()
        self.live = LiveTable()
        self.results = ResultsView() if results is None else results
        self.settings = settings
        self._plan_label, self._plan = QLabel(), ChoiceField()
        self.grade = QToolButton()
        self.grade.setText("?")
        self._session_label, self._session = QLabel(), QLineEdit()
        self._new = QPushButton()
        self._dialog: QFileDialog | None = None
        self._plans: tuple[tuple[str, str], ...] = ()
        self._graph_title, self._graph_hint = QLabel(), QLabel()
        self._graph_hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._graph_hint.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self.graph_place = QVBoxLayout()
        self._build()
        self._connect()
        self._state = presenter.state
        self._done = False
        self._retranslate()
        self._live_timer = QTimer(self)
        self._live_timer.timeout.connect(self._on_live)
        self._live_timer.start(_LIVE_MS)
        presenter.changed.connect(self.render)
        self.render(presenter.state)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        self._left = self._build_left(unit)
        graph = QWidget()
        self.graph_place.setContentsMargins(0, 0, 0, 0)
        graph.setLayout(self.graph_place)
        self.graph_place.addWidget(self._graph_title)
        self.graph_place.addWidget(self._graph_hint, 1)
        self._lower = QWidget()
        self._lower_box = QBoxLayout(QBoxLayout.Direction.TopToBottom, self._lower)
        self._lower_box.setContentsMargins(unit, unit // 2, unit, 0)
        self._lower_box.setSpacing(unit // 2)
        self._lower_box.addWidget(self.live, 0)
        self._lower_box.addWidget(graph, 1)
        self._middle = QSplitter(Qt.Orientation.Vertical)
        self._middle.addWidget(self.stage)
        self._middle.addWidget(self._lower)
        self._middle.setStretchFactor(0, 1)
        self._middle.setStretchFactor(1, 2)
        self._middle.setSizes([20 * unit, 22 * unit])
        self._middle.setChildrenCollapsible(False)
        self._across = QSplitter(Qt.Orientation.Horizontal)
        for part in (self._left, self._middle, self.results):
            self._across.addWidget(part)
        self.results.hide()
        self._across.setChildrenCollapsible(False)
        self._across.setStretchFactor(0, 0)
        self._across.setStretchFactor(1, 1)
        self._across.setStretchFactor(2, 2)
        self._across.setSizes([21 * unit, 30 * unit, 45 * unit])
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._across, 1)
        column.addWidget(self.action_bar)

    def _build_left(self, unit: int) -> QWidget:
        left = QWidget()
        plan = QHBoxLayout()
        plan.addWidget(self._plan_label)
        plan.addWidget(self._plan, 1)
        plan.addWidget(self.grade)
        # Titles of plans are long: the field shortens them, and the pane stays narrow.
        self._plan.setSizeAdjustPolicy(
            ChoiceField.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self._plan.setMinimumContentsLength(10)
        session = QHBoxLayout()
        session.addWidget(self._session_label)
        session.addWidget(self._session, 1)
        session.addWidget(self._new)
        column = QVBoxLayout(left)
        column.setContentsMargins(unit // 2, unit // 2, unit // 2, 0)
        column.setSpacing(unit // 2)
        column.addLayout(plan)
        column.addWidget(self.steps, 4)
        column.addWidget(SideScroll(self.settings, 20 * unit), 3)
        column.addLayout(session)
        return left

    def _connect(self) -> None:
        presenter = self._presenter
        self.steps.chosen.connect(presenter.choose)
        self.action_bar.triggered.connect(self._on_action)
        self.action_bar.hands_free_toggled.connect(presenter.set_hands_free)
        self.settings.edited.connect(presenter.set_settings)
        self._plan.activated.connect(self._on_plan)
        self._session.editingFinished.connect(self._on_session)
        self._new.clicked.connect(presenter.new_session)
        undo = QShortcut(QKeySequence(QKeySequence.StandardKey.Undo), self)
        undo.activated.connect(self._on_undo)
        # A pedal that bounces: Space does nothing while an accumulation runs, wherever it goes.
        self._swallow = QShortcut(QKeySequence(Qt.Key.Key_Space), self)

    def render(self, state: MeasuringState[Any]) -> None:
        """Show a state."""
        self._state = state
        self.stage.render(state.stage)
        self.steps.render(state.steps)
        self.action_bar.render(state.actions)
        self._swallow.setEnabled(bool(state.locked.timing))
        self.settings.render(state)
        if self._plans != state.plans:
            self._plans = state.plans
            self._plan.clear()
            for plan_id, title in state.plans:
                self._plan.addItem(shown(title), plan_id)
        self._plan.setCurrentIndex(self._plan.findData(state.settings.plan_id))
        why_not = state.locked.plan or state.locked.timing
        self._plan.setEnabled(not why_not)
        self._plan.setToolTip(shown(why_not))
        if not self._session.hasFocus():
            self._session.setText(state.session)
            self._session.setCursorPosition(0)
        self._session.setReadOnly(not state.session_editable)
        self._session.setToolTip(state.folder or self.tr("Folder of the session; can be changed"))
        self._new.setEnabled(not state.session_editable and not state.locked.timing)
        self._graph_hint.setVisible(not state.has_samples)
        self._arrange(state.sensors >= _MANY)
        if state.has_results != self.results.isVisibleTo(self):
            self.results.setVisible(state.has_results)
            self._place_results()
        done = state.stage.pose is None and state.stage.tone is Tone.GOOD
        if done != self._done:
            self._done = done
            # The stage tells how little it needs once it is laid out without its picture.
            QTimer.singleShot(0, self, self._share_height)

    def _arrange(self, beside: bool) -> None:
        """The nine rows of an assembly stand beside the graph, the three of a triad above it."""
        direction = QBoxLayout.Direction.LeftToRight if beside else QBoxLayout.Direction.TopToBottom
        if direction is not self._lower_box.direction():
            self._lower_box.setDirection(direction)
            top = Qt.AlignmentFlag.AlignTop
            self._lower_box.setAlignment(self.live, top if beside else Qt.AlignmentFlag(0))
        if beside and self.live.columnCount():
            self.live.setFixedWidth(self.live.needed_width())
        else:
            self.live.setMinimumWidth(0)
            self.live.setMaximumWidth(_NO_LIMIT)

    def _place_results(self) -> None:
        """Results stand right of the stage; where that is too narrow, below it for the graph."""
        shown = self.results.isVisibleTo(self)
        wide = self.width() >= _WIDE * self.fontMetrics().height()
        wanted = self._across if wide else self._middle
        if self.results.parentWidget() is not wanted:
            wanted.addWidget(self.results)
            self.results.setVisible(shown)
            wanted.setStretchFactor(2, 2)
            unit = self.fontMetrics().height()
            self._share_height()
            self.results.setMinimumWidth(34 * unit if wide else 0)
            self._across.setSizes([21 * unit, 36 * unit, 60 * unit])
        self._lower.setVisible(wide or not shown)

    def _share_height(self) -> None:
        """Where nothing is left to turn, the stage leaves its height to what stands below it."""
        unit = self.fontMetrics().height()
        below = [22 * unit, 44 * unit]
        # Less than the stage needs: it keeps that.
        self._middle.setSizes([unit, *below] if self._done else [17 * unit, *below])

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.steps.setFocus(Qt.FocusReason.OtherFocusReason)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place_results()

    def _on_live(self) -> None:
        if self.isVisible():
            self.live.render(self._presenter.live())

    def _on_action(self, key: str) -> None:
        if key == "load":
            self._open_dialog()
        elif key == "export":
            self.results.foot.export()
        else:
            self._presenter.act(key)

    def _open_dialog(self) -> None:
        """Choose a file, in a window that does not block the others."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.tr("Load Data"), self._presenter.folder)
            dialog.setModal(False)
            dialog.setNameFilters(
                [
                    self.tr("Measurements (*.txt *.run.csv session.json)"),
                    self.tr("All files (*)"),
                ]
            )
            dialog.fileSelected.connect(self.file_chosen)
            self._dialog = dialog
        self._dialog.show()

    def _on_undo(self) -> None:
        self._presenter.act("undo")

    def _on_plan(self, index: int) -> None:
        self._presenter.set_plan(self._plan.itemData(index))

    def _on_session(self) -> None:
        if self._session.isModified():
            self._session.setModified(False)
            self._presenter.set_session_name(self._session.text())

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self._dialog = None
            self._plans = ()
            self.render(self._state)

    def _retranslate(self) -> None:
        self._plan_label.setText(self.tr("Plan"))
        self._plan.setAccessibleName(self.tr("Plan"))
        self.grade.setToolTip(self.tr("What can this plan show?"))
        self.grade.setAccessibleName(self.grade.toolTip())
        self._session_label.setText(self.tr("Session"))
        self._session.setAccessibleName(self.tr("Name of the session's folder"))
        self._new.setText(self.tr("New session"))
        self._graph_title.setText(self.tr("Main Graph"))
        self._graph_hint.setText(self.tr("The graph begins when samples come."))
        self.steps.setAccessibleName(shown(self._state.lists))
