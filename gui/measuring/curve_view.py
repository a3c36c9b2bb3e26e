"""A plot of the results page: a quantity over another that was set."""

import numpy as np
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from core.arrays import FloatArray
from gui.measuring.page import CurveState
from gui.widgets.plot import Plot


class CurveView(QWidget):
    """Title and plot.

    Parameters
    ----------
    state : what is drawn
    """

    def __init__(self, state: CurveState, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        title = QLabel(state.title)
        font = title.font()
        font.setBold(True)
        title.setFont(font)
        self.plot = Plot(state.x_label, state.y_label)
        for colour, (name, x, y, u) in enumerate(state.series):
            px, py, pu = (np.array(values, dtype=np.float64) for values in (x, y, u))
            if state.joined:
                self.plot.add_curve(px, py, colour)
            low, high = _bars(py, pu)
            self.plot.add_points(px, py, colour, name, low=low, high=high)
        self.plot.show_everything()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(title)
        column.addWidget(self.plot, 1)


def _bars(y: FloatArray, u: FloatArray) -> tuple[FloatArray | None, FloatArray | None]:
    return (None, None) if u.size != y.size else (y - u, y + u)
