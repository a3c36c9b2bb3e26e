import numpy as np
import pytest
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QImage, QPainter

from gui.widgets.colours import DARK, LIGHT
from gui.widgets.position_picture import PositionPicture, angle_text, describe, paint_pose
from gui.widgets.states import Pose


def drawn(pose, side=300, theme=LIGHT):
    image = QImage(side, side, QImage.Format.Format_RGB32)
    image.fill(QColor(theme.window))
    painter = QPainter(image)
    paint_pose(painter, QRectF(image.rect()), pose, theme)
    painter.end()
    view = np.frombuffer(image.constBits(), np.uint8).reshape(side, side, 4)
    return view[..., :3].astype(int)


def where(image, colour):
    """Pixels of a colour as (right, up) in half widths from the centre."""
    wanted = QColor(colour)
    target = [wanted.blue(), wanted.green(), wanted.red()]
    rows, columns = np.nonzero(np.abs(image - target).max(axis=2) < 12)
    half = image.shape[0] / 2
    return (columns - half) / half, (half - rows) / half


@pytest.mark.parametrize("side", [64, 300])
@pytest.mark.parametrize(("head_deg", "direction"), [(0, (0, 1)), (90, (1, 0)), (200, None)])
def test_mark_stands_at_the_angle_clockwise_from_the_top(qapp, side, head_deg, direction):
    angle = np.radians(head_deg)
    direction = direction or (np.sin(angle), np.cos(angle))
    right, up = where(drawn(Pose("X_from", head_deg), side), LIGHT.accent)
    found = np.array([right.mean(), up.mean()])
    assert found / np.hypot(*found) == pytest.approx(direction, abs=0.06)


@pytest.mark.parametrize("theme", [LIGHT, DARK])
def test_nothing_is_cut_off_at_the_edges(qapp, theme):
    for mount in ("X_from", "Y_to", "Z_from", "Z_to@90"):
        for head_deg in range(0, 360, 45):
            image = drawn(Pose(mount, head_deg), 64, theme)
            text = QColor(theme.text)
            target = [text.blue(), text.green(), text.red()]
            rim = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]])
            assert np.abs(rim - target).max(axis=1).min() > 60, (mount, head_deg)


def test_dot_and_cross_differ(qapp):
    assert (drawn(Pose("X_from", 0)) != drawn(Pose("X_to", 0))).any()


def test_words_for_a_screen_reader(qapp):
    assert describe(Pose("X_from", 90)) == "X from ODH, 90°, X from the head, Y down, Z right"
    assert describe(Pose("Y_to", 270)) == "Y to ODH, 270°, X up, Y to the head, Z left"
    assert angle_text(-22.5) == "\N{MINUS SIGN}22.5°"
    assert angle_text(360.0) == "360°"


def test_widget_takes_a_pose_and_goes_empty(qtbot):
    picture = PositionPicture()
    qtbot.addWidget(picture)
    picture.set_pose(Pose("X_from", 90))
    assert picture.accessibleName().startswith("X from ODH, 90°")
    assert picture.heightForWidth(123) == 123
    picture.set_pose(None)
    assert picture.accessibleName() == ""
    image = picture.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    assert image.pixelColor(10, 10) == image.pixelColor(100, 100)


def test_axes_may_be_given(qtbot):
    picture = PositionPicture()
    qtbot.addWidget(picture)
    picture.resize(200, 200)
    picture.set_pose(Pose("X_from", 0))
    own = picture.grab().toImage()
    picture.set_pose(Pose("X_from", 0), np.array([[-1.0, 0, 0], [0, -1, 0], [0, 0, 1]]))
    assert picture.grab().toImage() != own


def test_a_bad_pose_leaves_the_old_picture(qtbot):
    picture = PositionPicture()
    qtbot.addWidget(picture)
    picture.set_pose(Pose("X_from", 90))
    with pytest.raises(ValueError, match="unknown mount"):
        picture.set_pose(Pose("up", 0))
    assert picture.accessibleName().startswith("X from ODH, 90°")
