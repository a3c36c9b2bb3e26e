import pytest
from PySide6.QtGui import QFontMetricsF
from PySide6.QtWidgets import QLabel

from gui.widgets.stage import LEAST_PX, Stage
from gui.widgets.states import Pose, StageState, Tone


@pytest.fixture
def stage(qtbot):
    widget = Stage()
    qtbot.addWidget(widget)
    widget.resize(950, 420)
    widget.show()
    return widget


def headline(stage):
    return stage._headline


@pytest.mark.parametrize("text", ["Idle", "Turn to 90°", "Measuring 7 s", "Done ✓", "Link lost"])
def test_short_lines_are_one_line_of_at_least_48_px(stage, text):
    stage.render(StageState(text, "detail", Tone.ACTION, pose=Pose("X_from", 90)))
    font, lines = headline(stage)._fit(headline(stage).width())
    assert lines == [text]
    assert font.pixelSize() >= LEAST_PX


def test_long_line_wraps_and_is_not_cut(stage, qtbot):
    text = "Переставте блок віссю Y вздовж валу ділильної головки"
    stage.render(StageState(text, "detail", Tone.ACTION, pose=Pose("Y_from", 0)))
    qtbot.waitUntil(lambda: headline(stage).height() > LEAST_PX)
    font, lines = headline(stage)._fit(headline(stage).width())
    assert font.pixelSize() == LEAST_PX
    assert " ".join(lines) == text
    assert headline(stage).height() >= len(lines) * LEAST_PX


def test_parts_show_only_what_the_state_has(stage):
    stage.render(StageState("Idle"))
    assert not stage._picture.isVisible()
    assert not stage._ring.isVisible()
    assert not stage._next.isVisible()
    stage.render(
        StageState(
            "Measuring",
            progress=0.3,
            remaining_s=6.2,
            pose=Pose("X_from", 90),
            next_pose=Pose("X_from", 180),
            next_label="X from ODH 180°",
        )
    )
    assert stage._picture.isVisible()
    assert stage._ring.accessibleName() == "30%, 7"
    assert [label.text() for label in stage._next.findChildren(QLabel)] == [
        "Next",
        "X from ODH 180°",
    ]


def test_a_screen_reader_gets_the_words(stage):
    stage.render(StageState("Link lost", "COM4 vanished.", Tone.BAD))
    assert stage.accessibleName() == "Link lost"
    assert stage.accessibleDescription() == "COM4 vanished."


@pytest.mark.parametrize("tone", list(Tone))
def test_every_tone_is_drawn(stage, tone):
    stage.render(StageState("Words", tone=tone, progress=1.5, remaining_s=-1.0))
    assert not stage.grab().isNull()
    assert stage._ring.accessibleName() == "100%, 0"


def test_the_longest_word_is_never_cut(stage):
    stage.render(
        StageState(
            "Вимірювання", "", Tone.BUSY, 0.5, 7.0, Pose("X_from", 90), Pose("X_from", 180), "N"
        )
    )
    stage.layout().activate()
    stage.resize(stage.minimumSizeHint())
    stage.layout().activate()
    font, lines = headline(stage)._fit(headline(stage).width())
    assert lines == ["Вимірювання"]
    room = headline(stage).width() - 1.25 * LEAST_PX
    assert QFontMetricsF(font).horizontalAdvance(lines[0]) <= room


@pytest.mark.parametrize("size", [(700, 255), (940, 300), (1500, 420)])
def test_no_line_of_the_detail_is_cut(qtbot, size):
    stage = Stage()
    qtbot.addWidget(stage)
    stage.resize(*size)
    stage.show()
    stage.render(
        StageState(
            "Turn to 270°",
            "Position 16, 16 of 24. X from ODH, as before. Then press Space to accumulate 10 s.",
            Tone.ACTION,
            pose=Pose("X_from", 270.0),
            next_pose=Pose("Y_from", 0.0),
            next_label="Y from ODH 0°",
        )
    )
    qtbot.wait(20)
    stage._size_detail()
    qtbot.wait(20)
    detail = stage._detail
    assert detail.height() >= detail.heightForWidth(detail.width())
    assert stage.rect().contains(detail.geometry())


def test_without_a_picture_the_stage_needs_less_height(stage):
    stage.render(StageState("Turn to 90°", "detail", Tone.ACTION, pose=Pose("X_from", 90)))
    turning = stage.minimumHeight()
    stage.render(StageState("All positions done", "8 positions are on the disk.", Tone.GOOD))
    assert stage.minimumHeight() < 0.8 * turning
    assert stage.minimumHeight() > LEAST_PX + 2 * stage.fontMetrics().height()
