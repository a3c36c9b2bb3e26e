"""A column of settings asks for the width of what is in it."""

from PySide6.QtWidgets import QLabel, QSplitter, QVBoxLayout, QWidget

from gui.widgets.side_scroll import SideScroll


def test_the_width_follows_the_content(qtbot):
    content, words = QWidget(), QLabel("short")
    QVBoxLayout(content).addWidget(words)
    scroll = SideScroll(content, 100)
    across = QSplitter()
    qtbot.addWidget(across)
    across.addWidget(scroll)
    across.addWidget(QWidget())
    across.resize(600, 200)
    across.show()
    assert scroll.minimumSizeHint().width() == 100
    words.setText("a caption that is as long as it is in another language")
    needed = content.minimumSizeHint().width() + scroll.verticalScrollBar().sizeHint().width()
    assert needed > 300
    qtbot.waitUntil(lambda: scroll.width() >= needed)
    assert scroll.viewport().width() >= content.minimumSizeHint().width()
