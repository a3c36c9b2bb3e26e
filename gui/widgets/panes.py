"""Panes side by side over a row of actions: how the analysis tabs are laid out."""

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSplitter, QVBoxLayout, QWidget


def lay_panes(
    page: QWidget, panes: Sequence[tuple[QWidget, int, int]], action_bar: QWidget
) -> None:
    """Fill a page.

    Parameters
    ----------
    panes : from the left: widget, share of the width to come, first width in heights of a line
    action_bar : below them
    """
    unit = page.fontMetrics().height()
    across = QSplitter(Qt.Orientation.Horizontal)
    for place, (pane, share, _) in enumerate(panes):
        across.addWidget(pane)
        across.setStretchFactor(place, share)
    across.setChildrenCollapsible(False)
    across.setSizes([width * unit for _, _, width in panes])
    rows = QVBoxLayout(page)
    rows.setContentsMargins(0, 0, 0, 0)
    rows.setSpacing(0)
    rows.addWidget(across, 1)
    rows.addWidget(action_bar)
