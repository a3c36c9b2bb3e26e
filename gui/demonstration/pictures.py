"""The pictures of the documentation, renewed from the running program."""

import shutil
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QImage

from core.errors import FormatError
from core.records.atomic import write_bytes_atomic
from gui.demonstration.playing import demonstrate
from gui.demonstration.scenes import SCENES, with_what_they_need
from gui.languages.choice import ENGLISH


@dataclass(frozen=True, slots=True)
class Renewed:
    """One picture.

    Parameters
    ----------
    file : its name
    changed : share of its pixels that are not what they were, 0 to 1; 1 for a new picture
    """

    file: str
    changed: float


def renew(folder: Path, scratch: Path, keys: Iterable[str], seed: int) -> list[Renewed]:
    """Play parts, each in a window of its own that speaks English; keep what pages show.

    Parameters
    ----------
    folder : of the pictures
    scratch : folder of all that is played, emptied before each window; pictures show its name
    keys : of `SCENES`
    seed : of the units and their noise

    Raises
    ------
    FormatError
        A part did not make a picture that it is registered for.
    """
    folder.mkdir(parents=True, exist_ok=True)
    done: list[Renewed] = []
    for chain in _chains(keys):
        shutil.rmtree(scratch, ignore_errors=True)
        demonstrate(scratch, chain, seed, ENGLISH)
        for file in (file for key in chain for file in SCENES[key].files):
            if not (scratch / file).is_file():
                raise FormatError(file, f"no part of {', '.join(chain)} made this picture")
            done.append(_put(scratch / file, folder / file))
    shutil.rmtree(scratch, ignore_errors=True)
    return done


def _chains(keys: Iterable[str]) -> list[tuple[str, ...]]:
    """Parts that share a window, since one works with the files of the other."""
    chains: dict[str, tuple[str, ...]] = {}
    for key in with_what_they_need(keys):
        first = key
        while SCENES[first].after:
            first = SCENES[first].after
        chains[first] = (*chains.get(first, ()), key)
    return list(chains.values())


def _put(new: Path, path: Path) -> Renewed:
    """Take the place of the picture of before; say how much of it is another one."""
    changed = _difference(QImage(str(new)), QImage(str(path)))
    write_bytes_atomic(path, new.read_bytes())
    return Renewed(path.name, changed)


def _difference(one: QImage, other: QImage) -> float:
    if one.size() != other.size():
        return 1.0
    return float(np.mean(_pixels(one) != _pixels(other)))


def _pixels(image: QImage) -> NDArray[np.uint32]:
    plain = image.convertToFormat(QImage.Format.Format_RGB32)
    return np.frombuffer(plain.constBits(), np.uint32).copy()
