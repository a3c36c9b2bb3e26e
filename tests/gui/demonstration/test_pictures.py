"""The pictures of the documentation are renewed from the running program."""

from pathlib import Path

import pytest
from PySide6.QtCore import QLocale
from PySide6.QtGui import QImage

from core.errors import FormatError
from gui.demonstration import pictures
from gui.demonstration.pictures import renew
from gui.demonstration.scenes import SCENES, Scene


@pytest.mark.timeout(240)
def test_a_part_is_played_and_its_pictures_take_the_place_of_the_old_ones(tmp_path: Path):
    folder, scratch = tmp_path / "pictures", tmp_path / "scratch"
    folder.mkdir()
    old = QImage(1280, 800, QImage.Format.Format_RGB32)
    old.fill(0)
    assert old.save(str(folder / "drift-all-dark.png"))
    QLocale.setDefault(QLocale("uk_UA"))
    renewed = {one.file: one.changed for one in renew(folder, scratch, ["drift"], 1)}
    assert sorted(renewed) == sorted(SCENES["drift"].files)
    assert 0.5 < renewed["drift-all-dark.png"] <= 1.0
    for file in renewed:
        picture = QImage(str(folder / file))
        assert (picture.width(), picture.height()) == (1280, 800)
    dark, light = (QImage(str(folder / f"drift-all-{look}.png")) for look in ("dark", "light"))
    assert dark.pixelColor(2, 790).lightness() < 100 < light.pixelColor(2, 790).lightness()
    assert not scratch.exists()


def test_a_picture_that_was_not_taken_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(pictures, "demonstrate", lambda *_: (tmp_path / "s").mkdir())
    monkeypatch.setitem(SCENES, "drift", Scene("gui.drift.demo", ("drift-forgotten",)))
    with pytest.raises(FormatError, match=r"drift-forgotten-dark\.png.*drift made this picture"):
        renew(tmp_path / "pictures", tmp_path / "s", ["drift"], 1)
