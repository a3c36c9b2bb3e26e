"""The panel Preferences, below the device strip."""

from dataclasses import replace

from PySide6.QtCore import QEvent, QSignalBlocker, Qt
from PySide6.QtGui import QKeyEvent, QPalette
from PySide6.QtWidgets import (
    QFileDialog,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from gui.preferences.presenter import Preferences, PreferencesState
from gui.widgets.fields import ChoiceField, NumberField
from gui.widgets.window_menu import WindowMenu

_NOT_STATED = -91.0
"""Below all latitudes."""


class PreferencesView(QWidget):
    """Fields for what holds in every tab; each is taken over when it is left.

    Parameters
    ----------
    presenter : what the fields call
    menu : of the window, whose looks, sounds and languages stand here as well
    """

    def __init__(
        self, presenter: Preferences, menu: WindowMenu, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._menu = menu
        self._dialog: QFileDialog | None = None
        self._title = QLabel()
        font = self._title.font()
        font.setBold(True)
        self._title.setFont(font)
        self._operator, self._folder = QLineEdit(), QLineEdit()
        self._g = NumberField(9.7, 9.9, 5, "m/s²")
        self._u_g = NumberField(0.0, 0.1, 5, "m/s²")
        self._latitude = NumberField(_NOT_STATED, 90.0, 3, "°")
        for field, step in ((self._g, 0.0001), (self._u_g, 0.0001), (self._latitude, 1.0)):
            field.setSingleStep(step)
        self._look, self._sounds, self._language = ChoiceField(), ChoiceField(), ChoiceField()
        self._browse, self._close = QPushButton(), QPushButton()
        self._hint = QLabel()
        self._hint.setWordWrap(True)
        self._hint.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self._labels = [QLabel() for _ in range(8)]
        self._build()
        self._connect()
        self._retranslate()
        self.render(presenter.state)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        grid = QGridLayout()
        grid.setHorizontalSpacing(unit)
        grid.setVerticalSpacing(unit // 3)
        fields = (
            self._operator,
            self._g,
            self._u_g,
            self._latitude,
            self._look,
            self._sounds,
            self._language,
        )
        for place, field in enumerate(fields):
            row, column = place % 2, 2 * (place // 2)
            grid.addWidget(self._labels[place], row, column)
            grid.addWidget(field, row, column + 1)
            self._labels[place].setBuddy(field)
            field.setMinimumWidth(11 * unit)
        grid.setColumnStretch(8, 1)
        folder = QHBoxLayout()
        folder.addWidget(self._labels[7])
        folder.addWidget(self._folder, 1)
        folder.addWidget(self._browse)
        self._labels[7].setBuddy(self._folder)
        head = QHBoxLayout()
        head.addWidget(self._title)
        head.addStretch(1)
        head.addWidget(self._close)
        column = QVBoxLayout(self)
        column.setContentsMargins(unit, unit // 2, unit, unit)
        column.setSpacing(unit // 2)
        column.addLayout(head)
        column.addLayout(grid)
        column.addLayout(folder)
        column.addWidget(self._hint)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def _connect(self) -> None:
        self._operator.editingFinished.connect(self._on_site)
        for field in (self._g, self._u_g, self._latitude):
            field.valueChanged.connect(self._on_site)
        self._folder.editingFinished.connect(self._on_folder)
        self._browse.clicked.connect(self._on_browse)
        self._look.activated.connect(self._on_look)
        self._sounds.activated.connect(self._on_sounds)
        self._language.activated.connect(self._on_language)
        self._close.clicked.connect(self.hide)
        self._presenter.changed.connect(self.render)

    def open(self) -> None:
        """Show the panel with what holds now."""
        self._fill_choices()
        self.render(self._presenter.state)
        self.show()
        self._operator.setFocus(Qt.FocusReason.OtherFocusReason)

    def render(self, state: PreferencesState) -> None:
        """Show a state."""
        site = state.site
        for field, value in (
            (self._g, site.g_mps2),
            (self._u_g, site.u_g_mps2),
            (self._latitude, _NOT_STATED if site.latitude_deg is None else site.latitude_deg),
        ):
            with QSignalBlocker(field):
                field.setValue(value)
        if not self._operator.hasFocus():
            self._operator.setText(site.operator)
        self._folder.setText(str(state.folder))
        later = state.folder != state.folder_now
        self._hint.setText(
            self.tr("Sessions go there from the next start on; nothing is moved.")
            if later
            else self.tr(
                "Gravity and latitude are taken by every tab that is not in the middle of a"
                " session; a tab may still state its own."
            )
        )

    def _fill_choices(self) -> None:
        for field, actions in (
            (self._look, self._menu.looks),
            (self._sounds, self._menu.volumes),
            (self._language, self._menu.languages),
        ):
            field.clear()
            for name, action in actions.items():
                field.addItem(action.text(), name)
                if action.isChecked():
                    field.setCurrentIndex(field.count() - 1)

    def _on_site(self) -> None:
        latitude = self._latitude.value()
        site = replace(
            self._presenter.state.site,
            operator=self._operator.text().strip(),
            g_mps2=self._g.value(),
            u_g_mps2=self._u_g.value(),
            latitude_deg=None if latitude <= _NOT_STATED else max(latitude, -90.0),
        )
        if site != self._presenter.state.site:
            self._presenter.set_site(site)

    def _on_folder(self) -> None:
        if self._folder.isModified():
            self._presenter.set_folder(self._folder.text())

    def _on_browse(self) -> None:
        """Choose a folder, in a window that does not block the others."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.tr("Folder of sessions"), self._folder.text())
            dialog.setFileMode(QFileDialog.FileMode.Directory)
            dialog.setModal(False)
            dialog.fileSelected.connect(self._presenter.set_folder)
            self._dialog = dialog
        self._dialog.show()

    def _on_look(self) -> None:
        self._menu.looks[self._look.currentData()].trigger()

    def _on_sounds(self) -> None:
        self._menu.volumes[self._sounds.currentData()].trigger()

    def _on_language(self) -> None:
        self._menu.languages[self._language.currentData()].trigger()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.hide()
        else:
            super().keyPressEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self._fill_choices()
            self.render(self._presenter.state)

    def _retranslate(self) -> None:
        self._title.setText(self.tr("Preferences"))
        words = (
            self.tr("Operator"),
            self.tr("Local g"),
            self.tr("u(g)"),
            self.tr("Latitude"),
            self.tr("Look"),
            self.tr("Sounds"),
            self.tr("Language"),
            self.tr("Folder of sessions"),
        )
        for label, text in zip(self._labels, words, strict=True):
            label.setText(text)
            buddy = label.buddy()
            if buddy is not None:
                buddy.setAccessibleName(text)
        self._operator.setPlaceholderText(self.tr("stated in every session"))
        self._latitude.setSpecialValueText(self.tr("not stated"))
        self._browse.setText(self.tr("Browse"))
        self._close.setText(self.tr("Close"))
