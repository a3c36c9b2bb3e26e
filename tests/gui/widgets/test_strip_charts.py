import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QWheelEvent
from PySide6.QtWidgets import QApplication

from core.arrays import frozen
from core.errors import StorageError
from core.samples.block import Channel
from gui.widgets.chart_export import EXPORTS, save_chart
from gui.widgets.colours import DARK, LIGHT
from gui.widgets.history import History
from gui.widgets.strip_charts import StripCharts
from gui.widgets.strip_view import Follow, Interval, Mark
from gui.widgets.theme import apply_theme

SEVEN = tuple(Channel(f"c{number}", "V") for number in range(7))


def history(seconds=100, channels=SEVEN, rate=100.0):
    made = History(channels, rate)
    extend(made, seconds)
    return made


def extend(made, seconds):
    index = np.arange(made.end, made.end + round(seconds * made.rate))
    wave = np.sin(index / 300.0)[:, None] * np.arange(1, len(made.channels) + 1)
    made.append(index, frozen(wave))


@pytest.fixture
def charts(qtbot):
    widget = StripCharts()
    qtbot.addWidget(widget)
    widget.resize(1000, 700)
    widget.show()
    widget.set_history(history())
    with qtbot.waitActive(widget):
        widget.activateWindow()
    widget._canvas.setFocus()
    return widget


def x_of(charts, seconds):
    canvas = charts._canvas
    return round(canvas._layout().x_of(canvas.view, seconds))


def wheel(charts, position, notches, modifiers=Qt.KeyboardModifier.NoModifier):
    event = QWheelEvent(
        QPointF(position),
        QPointF(charts._canvas.mapToGlobal(position)),
        QPoint(),
        QPoint(0, 120 * notches),
        Qt.MouseButton.NoButton,
        modifiers,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(charts._canvas, event)


def test_full_time_scale_grows_in_steps(charts):
    assert charts.follow is Follow.ALL
    start, stop = charts.window_s
    assert start == 0.0
    assert 100.0 <= stop <= 106.0
    extend(charts._canvas.history, 1)
    charts.refresh()
    assert charts.window_s == (start, stop)
    extend(charts._canvas.history, 10)
    charts.refresh()
    assert charts.window_s[1] >= 111.0


def test_tracking_keeps_the_span_and_steps_on(charts):
    charts.track(10.0)
    start, stop = charts.window_s
    assert stop - start == pytest.approx(10.0)
    assert start < 100.0 < stop
    moves = 0
    for _ in range(100):
        extend(charts._canvas.history, 0.033)
        charts.refresh()
        if charts.window_s[1] != stop:
            stop = charts.window_s[1]
            moves += 1
        assert charts.window_s[0] < charts._canvas.history.end / 100.0 <= stop
    assert moves <= 4


def test_tracking_a_young_record_starts_at_zero(charts):
    charts.track(500.0)
    assert charts.window_s == (0.0, 500.0)
    extend(charts._canvas.history, 401)
    charts.refresh()
    assert charts.window_s == pytest.approx((51.0, 551.0))


def test_pause_freezes_the_picture_and_not_the_history(charts):
    charts.set_paused(True)
    window = charts.window_s
    extend(charts._canvas.history, 50)
    charts.refresh()
    assert charts.window_s == window
    charts.set_paused(False)
    assert charts.window_s[1] > 150.0


def test_wheel_zooms_about_the_pointer(charts, qtbot):
    place = QPoint(x_of(charts, 40.0), 200)
    before = charts._canvas._layout().time_of(charts._canvas.view, place.x())
    with qtbot.waitSignal(charts.follow_changed):
        wheel(charts, place, 3)
    start, stop = charts.window_s
    assert stop - start == pytest.approx(105.0 * 1.25**-3)
    assert charts._canvas._layout().time_of(charts._canvas.view, place.x()) == pytest.approx(before)
    assert charts.follow is Follow.NOTHING
    charts.show_all()
    assert charts.window_s[0] == 0.0


def test_wheel_on_the_axis_zooms_values_and_double_click_undoes_it(charts, qtbot):
    view = charts._canvas.view
    own = view.limits(2)
    middle = charts._canvas._layout().plot(2).center().toPoint()
    wheel(charts, QPoint(20, middle.y()), 2)
    assert view.limits(2)[1] - view.limits(2)[0] == pytest.approx((own[1] - own[0]) * 1.25**-2)
    qtbot.mouseDClick(charts._canvas, Qt.MouseButton.LeftButton, pos=QPoint(20, middle.y()))
    charts.grab()
    assert view.limits(2) == pytest.approx(own)


def test_click_sets_a_shift_click_sets_b_and_both_can_be_dragged(charts, qtbot):
    canvas = charts._canvas
    qtbot.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x_of(charts, 20.0), 100))
    qtbot.mouseClick(
        canvas,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.ShiftModifier,
        QPoint(x_of(charts, 60.0), 100),
    )
    a, b = charts.cursors
    assert (a, b) == pytest.approx((20.0, 60.0), abs=0.1)
    qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x_of(charts, 60.0), 300))
    qtbot.mouseMove(canvas, QPoint(x_of(charts, 80.0), 300))
    qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x_of(charts, 80.0), 300))
    assert charts.cursors == pytest.approx((20.0, 80.0), abs=0.1)
    assert charts.follow is Follow.ALL


def test_dragging_moves_the_window(charts, qtbot):
    canvas = charts._canvas
    qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=QPoint(500, 300))
    qtbot.mouseMove(canvas, QPoint(450, 300))
    qtbot.mouseMove(canvas, QPoint(400, 300))
    qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=QPoint(400, 300))
    span = charts.window_s[1] - charts.window_s[0]
    assert charts.window_s[0] == pytest.approx(100 * span / canvas._layout().area.width(), rel=0.2)
    assert charts.cursors == (None, None)


def test_interval_is_drawn_only_while_selecting(charts, qtbot):
    canvas = charts._canvas
    charts.set_selecting(True)
    with qtbot.waitSignal(charts.interval_selected) as told:
        qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x_of(charts, 70.0), 100))
        qtbot.mouseMove(canvas, QPoint(x_of(charts, 30.0), 100))
        qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x_of(charts, 30.0), 100))
    assert told.args == pytest.approx([30.0, 70.0], abs=0.1)


def test_everything_by_keys(charts, qtbot):
    canvas = charts._canvas
    qtbot.keyClick(canvas, Qt.Key.Key_Plus)
    assert charts.window_s[1] - charts.window_s[0] == pytest.approx(105.0 * 0.8)
    start = charts.window_s[0]
    qtbot.keyClick(canvas, Qt.Key.Key_Right)
    assert charts.window_s[0] > start
    qtbot.keyClick(canvas, Qt.Key.Key_A)
    a = charts.cursors[0]
    qtbot.keyClick(canvas, Qt.Key.Key_Right, Qt.KeyboardModifier.ControlModifier)
    assert charts.cursors[0] > a
    qtbot.keyClick(canvas, Qt.Key.Key_B)
    both = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    b = charts.cursors[1]
    qtbot.keyClick(canvas, Qt.Key.Key_Left, both)
    assert charts.cursors[1] < b
    qtbot.keyClick(canvas, Qt.Key.Key_C)
    assert charts.cursors == (None, None)
    qtbot.keyClick(canvas, Qt.Key.Key_Home)
    assert charts.follow is Follow.ALL
    qtbot.keyClick(canvas, Qt.Key.Key_End)
    assert charts.follow is Follow.TAIL
    qtbot.keyClick(canvas, Qt.Key.Key_Left)
    assert charts.follow is Follow.NOTHING


def test_values_beside_the_charts(charts):
    canvas = charts._canvas
    charts.set_cursors(10.0, 20.0)
    lines = dict(canvas._lines(canvas.history, 3))
    expected = [4 * np.sin(number / 300.0) for number in (1000, 2000)]
    shown = [float(lines[key].replace("\N{MINUS SIGN}", "-")) for key in ("A", "B", "B−A")]
    assert shown == pytest.approx([*expected, expected[1] - expected[0]], abs=0.005)
    charts.set_cursors(1e6, None)
    assert dict(canvas._lines(canvas.history, 3))["A"] == "—"


def test_sixty_four_channels_scroll(qtbot):
    widget = StripCharts()
    qtbot.addWidget(widget)
    widget.resize(900, 500)
    widget.show()
    channels = tuple(Channel(f"adc {number}") for number in range(64))
    widget.set_history(history(5, channels))
    assert widget._bar.isVisible()
    rows = widget._canvas.rows()
    assert 3 < rows < 64
    widget._bar.setValue(10)
    assert widget._canvas.shown() == tuple(range(10, 10 + rows))
    wheel(widget, QPoint(400, 200), -1, Qt.KeyboardModifier.ShiftModifier)
    assert widget._bar.value() == 11
    widget.set_channels((3, 5))
    assert widget._canvas.shown() == (3, 5)
    assert not widget._bar.isVisible()


def test_curve_is_where_its_values_are(charts):
    charts.set_channels([0])
    charts.set_range(0, (-2.0, 2.0))
    image = charts._canvas.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    plot = charts._canvas._layout().plot(0)
    colour = QColor(LIGHT.curves[0])
    for seconds in (10.0, 37.0, 80.0):
        x = x_of(charts, seconds)
        y = plot.bottom() - (np.sin(seconds / 3.0) + 2.0) / 4.0 * plot.height()
        near = [image.pixelColor(x, int(y) + offset) for offset in range(-3, 4)]
        assert colour in near, seconds


def test_samples_that_never_came_are_not_drawn(qtbot):
    widget = StripCharts()
    qtbot.addWidget(widget)
    made = History(SEVEN[:1], 100.0)
    made.append(np.arange(3000), frozen(np.zeros((3000, 1))))
    made.append(np.arange(6000, 9000), frozen(np.zeros((3000, 1))))
    widget.resize(900, 300)
    widget.show()
    widget.set_history(made)
    image = widget._canvas.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    column = {x_of(widget, 45.0): False, x_of(widget, 15.0): True, x_of(widget, 75.0): True}
    for x, drawn in column.items():
        colours = {image.pixelColor(x, y).name() for y in range(image.height())}
        assert (LIGHT.curves[0] in colours) is drawn


def test_a_change_of_the_look_is_drawn(qapp, charts):
    charts.grab()
    apply_theme(qapp, "dark")
    image = charts._canvas.grab().toImage()
    corner = image.pixelColor(3, image.height() - 3)
    assert corner == QColor(DARK.window)


def test_curves_are_not_drawn_again_for_the_pointer(charts, qtbot, monkeypatch):
    charts.grab()
    drawn = []
    monkeypatch.setattr(charts._canvas, "_draw_frame", lambda layout: drawn.append(layout))
    qtbot.mouseMove(charts._canvas, QPoint(400, 300))
    charts._canvas.repaint()
    assert charts.hover is not None
    assert drawn == []


def test_nothing_to_show(qtbot):
    widget = StripCharts()
    qtbot.addWidget(widget)
    widget.show()
    widget.refresh()
    widget.set_history(History(SEVEN, 100.0))
    widget.refresh()
    assert not widget.grab().isNull()
    widget.set_history(None)
    assert not widget.grab().isNull()


@pytest.mark.parametrize("suffix", EXPORTS)
def test_export(charts, tmp_path, suffix):
    charts.set_marks([Mark(30.0, "Подія")])
    charts.set_intervals([Interval(10.0, 20.0, "1", selected=True)])
    charts.set_overlays([history(50)])
    path = tmp_path / f"chart{suffix}"
    save_chart(charts.paint, QSize(800, 600), path, "Title")
    head = path.read_bytes()[:8]
    assert {".svg": b"<?xml", ".pdf": b"%PDF", ".png": b"\x89PNG"}[suffix] in head
    assert path.stat().st_size > 3000
    assert list(tmp_path.iterdir()) == [path]
    if suffix == ".png":
        assert QImage(str(path)).size() == QSize(1600, 1200)
    if suffix == ".svg":
        assert "Подія" in path.read_text(encoding="utf-8")


def test_export_that_fails_says_so_and_keeps_the_old_file(charts, tmp_path):
    with pytest.raises(StorageError, match="no such picture format"):
        save_chart(charts.paint, QSize(80, 60), tmp_path / "chart.gif")
    for suffix in EXPORTS:
        with pytest.raises(StorageError, match="cannot be written"):
            save_chart(charts.paint, QSize(80, 60), tmp_path / "nowhere" / f"chart{suffix}")

    def fail(painter: QPainter, size: QSize) -> None:
        painter.drawLine(0, 0, size.width(), 3)
        raise ZeroDivisionError

    for suffix in EXPORTS:
        old = tmp_path / f"chart{suffix}"
        old.write_text("old", encoding="utf-8")
        with pytest.raises(ZeroDivisionError):
            save_chart(fail, QSize(80, 60), old)
        assert old.read_text(encoding="utf-8") == "old"
