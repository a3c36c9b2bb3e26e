"""The rate table in pictures and words."""

import numpy as np
import pytest
from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage, QPainter
from pytestqt.qtbot import QtBot

from gui.widgets.colours import THEMES
from gui.widgets.position_picture import PositionPicture, describe
from gui.widgets.states import Pose
from gui.widgets.table_picture import paint_table, rate_words, up_words


def drawn(pose: Pose, side: int = 200) -> np.ndarray:
    image = QImage(side, side, QImage.Format.Format_RGB32)
    image.fill(0)
    painter = QPainter(image)
    paint_table(painter, QRectF(0, 0, side, side), pose, THEMES["light"])
    painter.end()
    return np.frombuffer(image.constBits(), np.uint8).reshape(side, side, 4)[..., :3].copy()


def test_words():
    assert rate_words(-100.0) == "−100 deg/s"
    assert rate_words(20.0) == "+20 deg/s"
    assert rate_words(0.0) == "0 deg/s"
    assert (up_words("Z_from"), up_words("X_to")) == ("Z up", "X down")
    assert describe(Pose("Z_from", 0.0, rate_dps=40.0)) == (
        "Z up, +40 deg/s, counter-clockwise seen from above"
    )
    assert describe(Pose("Z_to", 0.0, rate_dps=-40.0)).endswith(" clockwise seen from above")
    assert describe(Pose("Y_from", 0.0, rate_dps=0.0)) == "Y up, 0 deg/s, the table stands"


@pytest.mark.usefixtures("qapp")
def test_the_two_senses_mirror_each_other_and_a_standing_table_has_no_arrow():
    left, right, still = (drawn(Pose("Z_from", 0.0, rate_dps=r)) for r in (40.0, -40.0, 0.0))
    arrow_left, arrow_right = ((a != still).any(axis=2) for a in (left, right))
    assert arrow_left.sum() > 1000
    # The arrows are mirror images up to a pixel of smoothing at their edges.
    overlap = (arrow_left == arrow_right[:, ::-1]).mean()
    assert overlap > 0.98
    # The head of the arrow is on the side to which the near edge moves.
    lower = slice(140, 200)
    assert arrow_left[lower, :100].sum() > 1.2 * arrow_left[lower, 100:].sum()
    assert arrow_right[lower, 100:].sum() > 1.2 * arrow_right[lower, :100].sum()


def test_the_picture_of_a_step_shows_the_table(qtbot: QtBot):
    picture = PositionPicture()
    qtbot.addWidget(picture)
    picture.resize(60, 60)
    picture.set_pose(Pose("X_from", 0.0, rate_dps=-20.0))
    picture.show()
    assert picture.accessibleName() == "X up, −20 deg/s, clockwise seen from above"
    assert not picture.grab().toImage().isNull()
