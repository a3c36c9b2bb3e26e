import numpy as np
import pytest
from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QImage

from gui.widgets.chart_export import save_chart
from gui.widgets.colours import DARK, LIGHT, blend
from gui.widgets.fast_axis import FastAxis, decade_text, minor_decades
from gui.widgets.plot import Plot
from gui.widgets.theme import apply_theme


def shown(plot):
    return plot.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)


def colours(image):
    return {
        image.pixelColor(x, y).name() for x in range(image.width()) for y in range(image.height())
    }


@pytest.fixture
def allan(qtbot):
    plot = Plot("τ, s", "σ(τ), deg/s", log_x=True, log_y=True)
    qtbot.addWidget(plot)
    plot.resize(500, 400)
    tau = np.logspace(-2, 3, 30)
    sigma = 0.01 / np.sqrt(tau)
    plot.add_band(tau, 0.8 * sigma, 1.2 * sigma, 0)
    plot.add_curve(tau, sigma, 0, "PW09")
    plot.add_points(tau, sigma, 1, "measured", low=0.9 * sigma, high=1.1 * sigma)
    plot.add_text(1.0, 0.01, "N")
    plot.show()
    return plot


def test_points_of_a_logarithmic_plot_are_logarithms(allan):
    (x0, x1), (y0, y1) = allan.getPlotItem().viewRange()
    assert x0 < -2 < 3 < x1
    assert y0 < np.log10(0.01 / np.sqrt(1e3)) < -1 < y1


def test_what_a_logarithmic_axis_cannot_show_is_left_out(qtbot):
    plot = Plot(log_y=True)
    qtbot.addWidget(plot)
    plot.add_curve(np.array([1.0, 2.0, 3.0]), np.array([1.0, -1.0, 100.0]), 0)
    y = plot._items[0].item.getData()[1]
    assert y[0] == 0.0
    assert np.isnan(y[1])
    assert y[2] == 2.0


def test_colours_follow_the_look(qapp, allan):
    before = colours(shown(allan))
    assert {LIGHT.base, LIGHT.curves[1]} <= before
    assert blend(LIGHT.curves[0], LIGHT.base, 0.25).name() in before
    apply_theme(qapp, "dark")
    after = colours(shown(allan))
    assert {DARK.base, DARK.curves[1]} <= after
    assert LIGHT.base not in after


def test_a_closed_plot_survives_a_change_of_the_look(qapp, allan):
    allan.close()
    apply_theme(qapp, "dark")
    qapp.processEvents()


def test_grid_is_opaque_and_beneath_the_curves(allan):
    image = shown(allan)
    assert LIGHT.grid in colours(image)
    assert all(axis.zValue() < -100 for axis in allan._axes.values())


def test_lines_of_decades_are_stronger_than_those_between(qtbot):
    plot = Plot(log_x=True)
    qtbot.addWidget(plot)
    plot.resize(500, 300)
    plot._plot.setRange(xRange=(0.0, 2.0), yRange=(0.0, 1.0), padding=0)
    plot.show()
    plot.grab()
    image = shown(plot)
    box = plot._plot.getViewBox()
    found = []
    for power in (1.0, np.log10(50.0)):
        place = plot.mapFromScene(box.mapViewToScene(QPointF(power, 0.53)))
        near = {image.pixelColor(place.x() + offset, place.y()).name() for offset in (-1, 0, 1)}
        found.append(near - {LIGHT.base})
    assert found == [{LIGHT.grid}, {blend(LIGHT.grid, LIGHT.base, 0.5).name()}]


def test_clear(allan):
    allan.clear_items()
    image = shown(allan)
    assert LIGHT.curves[1] not in colours(image)
    assert allan._items == []


def test_home_shows_everything_again(allan, qtbot):
    allan.getPlotItem().setXRange(0.0, 0.1)
    qtbot.keyClick(allan, Qt.Key.Key_Home)
    allan.grab()
    assert allan.getPlotItem().viewRange()[0][1] > 3.0


@pytest.mark.parametrize("suffix", [".svg", ".png", ".pdf"])
def test_export(allan, tmp_path, suffix):
    path = tmp_path / f"allan{suffix}"
    save_chart(allan.paint, QSize(640, 480), path)
    assert path.stat().st_size > 2000
    if suffix == ".svg":
        assert "PW09" in path.read_text(encoding="utf-8")


def test_ticks_of_a_linear_axis(qapp):
    axis = FastAxis("bottom", LIGHT)
    ((step, values),) = axis.tickValues(0.0, 10.0, 1200.0)
    assert step == 1.0
    assert axis.tickStrings(values, 1.0, step) == [str(number) for number in range(11)]


def test_ticks_of_a_logarithmic_axis(qapp):
    axis = FastAxis("left", LIGHT)
    axis.setLogMode(y=True)  # type: ignore[arg-type]
    axis.setRange(-2.0, 1.0)
    (_, decades), (spacing, minors) = axis.tickValues(-2.0, 1.0, 400.0)
    assert axis.tickStrings(decades, 1.0, 1.0) == ["0.01", "0.1", "1", "10"]
    assert spacing is None
    assert len(minors) == 3 * 8
    assert set(axis.tickStrings(minors, 1.0, None)) == {""}
    axis.setRange(-0.1, 0.9)
    assert [t for t in axis.tickStrings(minor_decades(-0.1, 0.9), 1.0, None) if t] == ["2", "5"]


def test_decades():
    assert [decade_text(power) for power in (-4, -2, 0, 2, 3)] == [
        "10⁻⁴",
        "0.01",
        "1",
        "100",
        "10³",
    ]


def test_blend_is_opaque():
    mixed = blend("#000000", "#ffffff", 0.25)
    assert mixed == QColor(191, 191, 191)
    assert mixed.alpha() == 255
