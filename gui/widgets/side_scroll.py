"""A column of settings that scrolls up and down and is never cut at its sides."""

from PySide6.QtCore import QEvent, QObject, QSize
from PySide6.QtWidgets import QWidget

from gui.widgets.page_scroll import PageScroll


class SideScroll(PageScroll):
    """Asks for the width that its content needs, which changes with rows and languages.

    Parameters
    ----------
    content : what scrolls
    least : pixels that are asked for at least
    """

    def __init__(self, content: QWidget, least: int = 0, parent: QWidget | None = None) -> None:
        super().__init__(content, parent)
        self._least = least

    def minimumSizeHint(self) -> QSize:
        content = self.widget()
        size = super().minimumSizeHint()
        if content is None:
            return size
        needed = content.minimumSizeHint().width() + self.verticalScrollBar().sizeHint().width()
        return QSize(max(self._least, needed), size.height())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # Qt looks at the content's events as well, and lets no other layout know.
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().eventFilter(watched, event)
