import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import QLabel

from gui.widgets.colours import DARK, LIGHT
from gui.widgets.screenshots import save_pictures


def test_one_picture_for_each_look(qapp, tmp_path):
    written = save_pictures(qapp, lambda: QLabel("Turn to 90°"), tmp_path, "label", QSize(120, 40))
    assert [path.name for path in written] == ["label-light.png", "label-dark.png"]
    for path, theme in zip(written, (LIGHT, DARK), strict=True):
        image = QImage(str(path))
        assert image.size() == QSize(120, 40)
        assert image.pixelColor(1, 1) == QColor(theme.window)


def test_a_folder_that_is_not_there_is_an_error(qapp, tmp_path):
    with pytest.raises(OSError, match="could not be written"):
        save_pictures(qapp, QLabel, tmp_path / "nowhere", "label", QSize(10, 10))
