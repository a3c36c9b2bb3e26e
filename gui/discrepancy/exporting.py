"""Export: the report, the results, the model with the effects that were added."""

from collections.abc import Callable
from datetime import datetime
from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication

from core.discrepancy.to_json import explanation_to_json
from core.records.atomic import make_folder, write_text_atomic
from core.records.json_text import to_json
from core.records.names import safe_name, stamp
from core.version import SOFTWARE
from gui.discrepancy.report import write_report
from gui.discrepancy.working import Story
from gui.exporting import ExportFormat

SOURCE = "discrepancy export"


def formats() -> tuple[ExportFormat, ...]:
    """The formats of a story."""
    pdf = QCoreApplication.translate("Discrepancy", "Report, PDF")
    html = QCoreApplication.translate("Discrepancy", "Report, HTML")
    results = QCoreApplication.translate("Discrepancy", "Results, JSON")
    model = QCoreApplication.translate("Discrepancy", "Model, JSON")
    return (
        _format("pdf", pdf, "_model_vs_data.pdf", write_report),
        _format("html", html, "_model_vs_data.html", write_report),
        _format("json", results, "_model_vs_data.json", _write_results),
        _format("model", model, "_model.json", _write_model),
    )


def folder_of(story: Story | None, root: Path) -> Path:
    """Where files go that are named without a folder: into the session, else to the sessions."""
    return root if story is None or not story.paths[0].is_dir() else story.paths[0]


def _format(
    key: str, title: str, ending: str, put: Callable[[Story, Path], object]
) -> ExportFormat:
    def name(story: Story) -> str:
        return f"{safe_name(story.run.device)}_{stamp(datetime.now())}{ending}"

    def write(story: Story, path: Path) -> None:
        make_folder(path.parent)
        put(story, path)

    return ExportFormat(key, title, name, write, at_once=True)


def _write_results(story: Story, path: Path) -> None:
    told = story.proposed or story.told
    added = [step.effect for step in story.told.steps]
    write_text_atomic(path, to_json({**explanation_to_json(told), "added": added}))


def _write_model(story: Story, path: Path) -> None:
    write_text_atomic(path, to_json(model_document(story)))


def model_document(story: Story) -> dict[str, Any]:
    """The model of each output with the added effects: every parameter with its value.

    The terms add up to the output U: value times the column of each term (``equation``).
    """
    channels: list[dict[str, Any]] = []
    if story.ladder is not None:
        names = story.told.channels
        for name, (model, values) in zip(names, story.ladder.models, strict=True):
            terms: list[dict[str, Any]] = []
            for effect, place in zip(model.effects, model.places, strict=True):
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
                            {"name": p.name, "value": v, "unit": p.unit}
                            for p, v in zip(
                                model.parameters[place], values[place].tolist(), strict=True
                            )
                        ],
                    }
                )
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
