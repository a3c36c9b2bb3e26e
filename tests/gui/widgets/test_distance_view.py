"""The distance view: nothing above its foot is smaller than what is read from three metres."""

import pytest
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QFontMetricsF

from core.errors import Severity
from gui.widgets.distance_view import LEAST_SHARE, DistanceView
from gui.widgets.states import BannerState, Pose, StageState, Tone

LONG = StageState(
    "Mount X from ODH and turn to 292.5°",
    "Position 14, 14 of 24. Turn the unit by a quarter on its base, then the head to 292.5°."
    " Then press Space to accumulate 600 s.",
    Tone.ACTION,
    pose=Pose("X_from", 292.5),
)
TIMED = StageState(
    "Measuring", "Position 14, 14 of 24. Do not touch the head.", Tone.BUSY, 0.4, 7.0
)
SIZES = pytest.mark.parametrize("size", [QSize(1280, 800), QSize(1920, 1080)])


@SIZES
@pytest.mark.parametrize("words", [LONG.headline, LONG.detail, TIMED.detail])
def test_words_fit_their_place_and_are_never_too_small(qtbot, size, words):
    view = DistanceView()
    qtbot.addWidget(view)
    view.resize(size)
    place = QRectF(0, 0, 0.42 * size.width(), 0.40 * size.height())
    font, shown = view._fit(place, words, bold=words == LONG.headline)
    assert font.pixelSize() >= round(LEAST_SHARE * size.height()) >= 44
    wrapped = Qt.TextFlag.TextWordWrap
    assert QFontMetricsF(font).boundingRect(place, wrapped, shown).height() <= place.height()
    assert words.startswith(shown)


def test_escape_leaves_and_other_keys_go_on(qtbot):
    view = DistanceView()
    qtbot.addWidget(view)
    view.render(TIMED)
    view.show()
    with qtbot.waitSignal(view.left):
        qtbot.keyClick(view, Qt.Key.Key_Escape)
    typed = []
    view.typed.connect(lambda event: typed.append(event.key()))
    qtbot.keyClick(view, Qt.Key.Key_3)
    assert typed == [Qt.Key.Key_3]
    assert view.accessibleName() == "Measuring"
    assert "Do not touch" in view.accessibleDescription()


def test_a_doubt_takes_the_place_of_the_words_and_an_information_does_not(qtbot):
    view = DistanceView()
    qtbot.addWidget(view)
    view.render(LONG)
    view.doubt(BannerState(Severity.WARNING, "It looks like position 3", "", "Turn to 90°."))
    assert view.accessibleDescription() == "It looks like position 3. Turn to 90°."
    view.doubt(BannerState(Severity.INFO, "Exported"))
    assert view.accessibleDescription() == LONG.detail


@SIZES
def test_a_timed_step_is_drawn_with_digits_a_sixth_of_the_screen_high(qtbot, size):
    view = DistanceView()
    qtbot.addWidget(view)
    view.resize(size)
    view.render(StageState("", "", Tone.IDLE, 0.0, 7.0))
    image = view.grab().toImage()
    ground = image.pixelColor(5, 5)
    dark = [
        y
        for y in range(round(0.3 * size.height()), round(0.9 * size.height()))
        if any(
            image.pixelColor(x, y).lightness() < 100 < ground.lightness()
            for x in range(size.width() // 2, size.width(), 3)
        )
    ]
    assert max(dark) - min(dark) > size.height() / 7
