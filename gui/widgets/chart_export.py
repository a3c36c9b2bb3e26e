"""A chart as a file: SVG and PDF for a paper, PNG for a screen.

Everything goes through QPainter; pyqtgraph's own SVG exporter fails on Qt 6.11 (its issue 3485).
"""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QMarginsF, QRect, QSize, QSizeF, Qt
from PySide6.QtGui import QGuiApplication, QImage, QImageWriter, QPageSize, QPainter, QPdfWriter
from PySide6.QtSvg import QSvgGenerator

from core.errors import StorageError
from core.records.atomic import write_bytes_atomic

Paint = Callable[[QPainter, QSize], None]
_MM_PER_INCH = 25.4
_PNG_SCALE = 2


def save_chart(paint: Paint, size: QSize, path: Path, title: str = "") -> None:
    """Write what `paint` draws; the suffix of `path` chooses the format.

    Parameters
    ----------
    paint : draws on a painter, on a surface of the given size
    size : of the surface, in device-independent pixels
    title : stored in the file where the format has a place for it

    Raises
    ------
    StorageError
        The suffix is unknown, or the file could not be written; an older file is left as it was.
    """
    draw = EXPORTS.get(path.suffix.lower())
    if draw is None:
        raise StorageError(f"{path}: no such picture format; use {', '.join(EXPORTS)}")
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    draw(paint, size, buffer, title)
    write_bytes_atomic(path, bytes(buffer.data().data()))


def _dpi() -> float:
    """Resolution that makes fonts, whose size is in points, as large as on the screen."""
    return QGuiApplication.primaryScreen().logicalDotsPerInch()


def _svg(paint: Paint, size: QSize, buffer: QBuffer, title: str) -> None:
    generator = QSvgGenerator()
    generator.setOutputDevice(buffer)
    generator.setSize(size)
    generator.setViewBox(QRect(0, 0, size.width(), size.height()))
    generator.setResolution(round(_dpi()))
    generator.setTitle(title)
    _run(paint, size, QPainter(generator))


def _pdf(paint: Paint, size: QSize, buffer: QBuffer, title: str) -> None:
    writer = QPdfWriter(buffer)
    dpi = _dpi()
    writer.setResolution(round(dpi))
    writer.setPageMargins(QMarginsF(0, 0, 0, 0))
    millimetres = QSizeF(size) * (_MM_PER_INCH / dpi)
    writer.setPageSize(QPageSize(millimetres, QPageSize.Unit.Millimeter))
    writer.setTitle(title)
    _run(paint, size, QPainter(writer))


def _png(paint: Paint, size: QSize, buffer: QBuffer, title: str) -> None:
    image = QImage(size * _PNG_SCALE, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(_PNG_SCALE)
    image.setText("Title", title)
    image.fill(Qt.GlobalColor.white)
    _run(paint, size, QPainter(image))
    QImageWriter(buffer, QByteArray(b"png")).write(image)


def _run(paint: Paint, size: QSize, painter: QPainter) -> None:
    # A painter that is still active when its surface goes takes the program with it.
    try:
        paint(painter, size)
    finally:
        painter.end()


EXPORTS: dict[str, Callable[[Paint, QSize, QBuffer, str], None]] = {
    ".svg": _svg,
    ".png": _png,
    ".pdf": _pdf,
}
