"""Results whose model takes further effects."""

from abc import abstractmethod
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from core.procedures.added import NOTHING
from gui.jobs import Work
from gui.measuring.results import Results
from gui.services import Addition


class BendingResults(Results):
    """Calibrates what is on the page with effects that the plain model lacks."""

    addition: Addition | None = None
    """What the page was made with; None for the plain model."""

    @abstractmethod
    def work_with(self, addition: Addition, settings: Any, kept: Path | None) -> Work:
        """The work that calibrates a run with further effects.

        Parameters
        ----------
        addition : the run and the effects
        settings : what is on the screen
        kept : folder of the session that keeps its calibration; None for files
        """

    def add_effects(self, addition: Addition, settings: Any, folder: Path | None) -> None:
        """Calibrate a run with further effects, or without them again.

        Parameters
        ----------
        addition : the run and the effects
        settings : what is on the screen
        folder : of the session on the bench; None for none
        """
        if self.busy:
            return
        (path, *more) = addition.paths
        if path != folder:
            self.source_path = path
        kept = path if path.is_dir() and not more else None
        self.addition = addition if addition.added else None
        self.start(self.work_with(addition, settings, kept))

    def take_out(self, settings: Any, folder: Path | None) -> None:
        """Calibrate without the added effects again."""
        if self.addition is not None:
            old = self.addition
            self.add_effects(Addition(old.run, old.paths, NOTHING), settings, folder)


def source_of(paths: Sequence[Path]) -> str:
    """Names of files for the page."""
    return " + ".join(path.name for path in paths)
