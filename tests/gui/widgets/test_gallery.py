"""Every widget is drawn in both looks, without a warning of Qt."""

import importlib.util
from pathlib import Path

from PySide6.QtGui import QImage

from gui.widgets.colours import DARK, LIGHT


def test_gallery(qapp, tmp_path):
    source = Path(__file__).parents[1] / "widget_gallery.py"
    spec = importlib.util.spec_from_file_location("widget_gallery", source)
    assert spec is not None
    assert spec.loader is not None
    gallery = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(gallery)
    written = gallery.main(tmp_path)
    assert len(written) == 2 * len(gallery.GALLERY)
    for path in written:
        image = QImage(str(path))
        theme = DARK if path.stem.endswith("dark") else LIGHT
        seen = {image.pixelColor(x, y).name() for x in range(0, 300, 3) for y in range(0, 300, 3)}
        assert seen & {theme.window, theme.base}, path.name
        assert not seen & {(LIGHT if theme is DARK else DARK).window}, path.name
