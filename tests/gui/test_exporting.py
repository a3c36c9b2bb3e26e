"""What a panel of findings is offered, and what it has written."""

from pathlib import Path

from pytestqt.qtbot import QtBot

from core.records.atomic import make_folder
from gui.exporting import ExportFormat, Exporting, pictures
from gui.jobs import Jobs
from gui.messages import Messages
from gui.widgets.export_foot import ExportFoot


def test_a_panel_is_offered_names_and_has_files_written(qtbot: QtBot, tmp_path: Path):
    messages, jobs = Messages(), Jobs()
    foot = ExportFoot()
    qtbot.addWidget(foot)
    page: list[str] = []

    def write(words: str, path: Path) -> None:
        make_folder(path.parent)
        path.write_text(words, encoding="utf-8")

    exporting = Exporting(
        "export",
        (
            ExportFormat("text", "Text", lambda words: f"{words}.txt", write),
            *pictures("Plot, {suffix}", lambda words: words, write),
        ),
        lambda: page[0] if page else None,
        lambda: tmp_path / "new",
        jobs,
        messages,
    )
    exporting.serve(foot)
    assert [key for key, _ in exporting.formats] == ["text", "svg", "png", "pdf"]
    assert dict(exporting.formats)["pdf"] == "Plot, PDF"
    exporting.renew()
    foot.export()
    page.append("noise")
    exporting.renew()
    foot.export()
    qtbot.waitUntil(lambda: messages.current is not None)
    assert (tmp_path / "new" / "noise.txt").read_text(encoding="utf-8") == "noise"
    # A picture is drawn in the thread of the window: it is there at once.
    exporting.export("svg", exporting.propose("svg"))
    assert (tmp_path / "new" / "noise.svg").exists()
    (tmp_path / "file").touch()
    exporting.export("svg", str(tmp_path / "file" / "x.svg"))
    assert messages.current is not None
    assert messages.current.what == "Not exported"
    assert str(tmp_path / "file") in messages.current.meaning
    jobs.close()
