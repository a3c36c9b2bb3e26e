"""Export: the report, the results, the model with the effects that were added."""

from collections.abc import Callable
from datetime import datetime
from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication, QObject

from core.discrepancy.to_json import explanation_to_json
from core.errors import LabError, Severity, StorageError
from core.records.atomic import write_text_atomic
from core.records.json_text import to_json
from core.records.names import safe_name, stamp
from core.version import SOFTWARE
from gui.discrepancy.report import write_report
from gui.discrepancy.working import Story
from gui.messages import Messages
from gui.widgets.states import BannerState

SOURCE = "discrepancy export"
_SUFFIXES = {
    "pdf": "_model_vs_data.pdf",
    "html": "_model_vs_data.html",
    "json": "_model_vs_data.json",
    "model": "_model.json",
}


class Exporting(QObject):
    """Writes what is on the page.

    Parameters
    ----------
    story : returns what is on the page
    root : returns the folder where files go that are named without one
    messages : where it is told
    """

    def __init__(
        self,
        story: Callable[[], Story | None],
        root: Callable[[], Path],
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._story = story
        self._root = root
        self._messages = messages

    @property
    def formats(self) -> tuple[tuple[str, str], ...]:
        """Keys and titles."""
        return (
            ("pdf", QCoreApplication.translate("Discrepancy", "Report, PDF")),
            ("html", QCoreApplication.translate("Discrepancy", "Report, HTML")),
            ("json", QCoreApplication.translate("Discrepancy", "Results, JSON")),
            ("model", QCoreApplication.translate("Discrepancy", "Model, JSON")),
        )

    def propose(self, key: str) -> str:
        """A name for a format; empty while there is nothing."""
        story = self._story()
        if story is None:
            return ""
        folder = story.paths[0] if story.paths[0].is_dir() else self._root()
        name = f"{safe_name(story.run.device)}_{stamp(datetime.now())}{_SUFFIXES[key]}"
        return str(folder / name)

    def export(self, key: str, name: str) -> None:
        """Write a format under a name; a name without a folder goes to the sessions'."""
        story = self._story()
        if story is None or not name.strip():
            return
        path = self._root() / Path(name.strip()).expanduser()
        try:
            _make_folder(path.parent)
            if key in ("pdf", "html"):
                write_report(story, path)
            else:
                write_text_atomic(path, to_json(_document(story, key)))
        except LabError as error:
            words = QCoreApplication.translate("Discrepancy", "Not exported")
            self._messages.tell_error(SOURCE, words, error)
            return
        words = QCoreApplication.translate("Discrepancy", "Exported")
        self._messages.show(SOURCE, BannerState(Severity.INFO, words, str(path)))


def model_document(story: Story) -> dict[str, Any]:
    """The model of each output with the added effects: every parameter with its value.

    The terms add up to the output U: value times the column of each term (``equation``).
    """
    channels: list[dict[str, Any]] = []
    if story.ladder is not None:
        names = story.told.channels
        for name, (model, values) in zip(names, story.ladder.models, strict=True):
            terms: list[dict[str, Any]] = []
            place = 0
            for effect in model.effects:
                own = effect.parameters(model.sensor)
                terms.append(
                    {
                        "effect": effect.id,
                        "name": effect.name,
                        "equation": effect.equation,
                        "shape": [
                            {"name": p.name, "value": value, "unit": p.unit}
                            for p, value in effect.shape
                        ],
                        "parameters": [
                            {"name": p.name, "value": float(v), "unit": p.unit}
                            for p, v in zip(own, values[place:], strict=False)
                        ],
                    }
                )
                place += len(own)
            channels.append({"channel": name, "axis": model.sensor.axis, "terms": terms})
    run = story.run
    return {
        "device": run.device,
        "sensor": run.sensor,
        "test": run.test,
        "unit": run.unit,
        "g_mps2": run.conditions.g_mps2,
        "sources": [path.name for path in story.paths],
        "software": SOFTWARE,
        "channels": channels,
    }


def _document(story: Story, key: str) -> dict[str, Any]:
    if key == "model":
        return model_document(story)
    told = story.proposed or story.told
    return {**explanation_to_json(told), "added": [step.effect for step in story.told.steps]}


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(f"{folder}: cannot be made ({error.strerror})") from error
