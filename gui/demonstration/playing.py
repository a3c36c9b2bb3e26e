"""Parts of the demonstration played in one window.

Nothing is told to the window but what an operator would do: hands-free on, Process Data, Export.
The hidden truth of the rig is looked at only afterwards.
"""

import importlib
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QApplication

from drivers.virtual.truth import Compared
from gui.app import Application, Options
from gui.demonstration.scenes import SCENES
from gui.demonstration.stage import SESSIONS, WindowStage
from gui.languages.choice import SYSTEM
from gui.measuring.demonstrating import Told


@dataclass(frozen=True, slots=True)
class Outcome:
    """What the demonstration left.

    Parameters
    ----------
    parts : what each tab told
    files : exports and pictures
    """

    parts: tuple[Told, ...]
    files: tuple[Path, ...]

    @property
    def parameters(self) -> tuple[Compared, ...]:
        """Every estimate of all parts beside its truth."""
        return tuple(row for part in self.parts for row in part.parameters)


def demonstrate(out: Path, keys: Iterable[str], seed: int, language: str = SYSTEM) -> Outcome:
    """Measure, process and export in the window; leave files and pictures in `out`.

    Parameters
    ----------
    out : folder, made if need be
    keys : of `SCENES`
    seed : of the units and their noise
    language : of the window

    Raises
    ------
    LinkError
        A session did not come to its end.
    """
    out.mkdir(parents=True, exist_ok=True)
    existing = QApplication.instance()
    qt = existing if isinstance(existing, QApplication) else QApplication(["calrig"])
    application = Application(
        qt, Options(root=out / SESSIONS, settings=out / "settings.json", quiet=True)
    )
    application.languages.choose(language)
    stage = WindowStage(qt, application, out, seed)
    try:
        stage.open()
        modules = [importlib.import_module(SCENES[key].module) for key in keys]
        parts = tuple(module.play(stage) for module in modules)
        return Outcome(parts, tuple(stage.files))
    finally:
        application.close()
        application.window.close()
        # What is connected to the window keeps it alive until Qt lets go of it.
        application.window.deleteLater()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
