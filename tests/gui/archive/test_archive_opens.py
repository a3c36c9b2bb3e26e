"""What was really recorded is found, opened in its tab and decoded again, in the whole window."""

import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from core.plans.plan import load_plans
from core.samples.run import Conditions
from drivers.virtual.session import Order, simulate_record, simulate_session
from gui.allan.tab import AllanTab
from gui.archive.tab import ArchiveTab
from gui.measuring.tab import MeasuringTab
from tests.gui.archive.conftest import settle, show
from tests.gui.window_driver import Driver

CONDITIONS = Conditions(g_mps2=9.81, u_g_mps2=1e-4, head_u_arcsec=10.0, latitude_deg=50.0)
SESSIONS = {
    "head": ("pointer", "pointer_8", "accelerometer"),
    "rate": ("clbdus", "rate_table_100", "gyro"),
    "accuracy": ("pointer", "pitch_accuracy_3", "accelerometer"),
}


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A session of each measuring tab, with its raw bytes, and a record at rest."""
    root = tmp_path_factory.mktemp("recorded")
    for name, (device, plan, sensor) in SESSIONS.items():
        whole = load_plans()[plan]
        short = replace(whole.with_steps(whole.steps[:6]), accumulation_s=0.3)
        url = f"sim://{device}?speed=max&seed=5&name={name}-archive"
        simulate_session(Order(url, short, sensor, CONDITIONS), root / name)
    (root / "record").mkdir()
    simulate_record("sim://cvg25?speed=max&seed=5", 20.0, root / "record" / "cvg.calrec")
    return root


class Desk:
    """The archive in the window, and the keys on it."""

    def __init__(self, driver: Driver) -> None:
        self.driver = driver
        tab = driver.app.tabs["Archive"]
        assert isinstance(tab, ArchiveTab)
        self.tab = tab
        self.show()

    def show(self) -> None:
        self.driver.app.window.tabs.setCurrentWidget(self.tab.widget)
        self.settle()

    def settle(self) -> None:
        self.driver.until(lambda: self.tab.library.idle)

    def choose(self, kind: str, what: str) -> None:
        rows = self.tab.presenter.state.rows
        (number,) = (row.id for row in rows if row.cells[1] == kind and row.cells[-1] == what)
        self.tab.presenter.choose([number])
        self.settle()


@pytest.fixture
def desk(open_app: Callable[[], Driver], recorded: Path, tmp_path: Path) -> Desk:
    shutil.copytree(recorded, tmp_path / "data")
    return Desk(open_app())


def test_every_kind_opens_in_its_tab(desk: Desk) -> None:
    app = desk.driver.app
    for title, plan, rows in (
        ("Dividing head", "pointer_8", 6),
        ("Rate table", "rate_table_100", 6),
        ("Accuracy", "pitch_accuracy_3", 3),
    ):
        desk.show()
        desk.choose("session", plan)
        desk.driver.click(desk.tab.view.action_bar.button("open"))
        tab = app.tabs[title]
        assert isinstance(tab, MeasuringTab)
        assert app.window.tabs.currentWidget() is tab.widget
        desk.driver.until(lambda tab=tab: not tab.results.busy and tab.results.page is not None)
        assert str(rows) in f"{tab.results.page.title} {tab.results.page.source}"
    desk.show()
    desk.choose("record", "raw")
    desk.driver.click(desk.tab.view.action_bar.button("open"))
    allan = app.tabs["Allan"]
    assert isinstance(allan, AllanTab)
    assert app.window.tabs.currentWidget() is allan.widget
    desk.driver.until(lambda: allan.presenter.state.picture is not None)


def test_real_raw_bytes_are_decoded_again_beside_the_stored_means(
    tab: ArchiveTab, qtbot: QtBot, root: Path, recorded: Path
) -> None:
    shutil.copytree(recorded / "head", root / "head")
    show(tab, qtbot)
    tab.presenter.choose([tab.presenter.state.rows[0].id])
    settle(tab, qtbot)
    button = tab.view.action_bar.button("reprocess")
    for same, left_over in ((6, ()), (0, ("its raw bytes were not recorded",))):
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
        settle(tab, qtbot)
        findings = tab.presenter.state.findings
        assert findings is not None
        assert findings.source == f"{same} of 6 positions give the same means"
        assert tuple(note.text for note in findings.notes) == left_over
        (root / "head" / "raw.calrec").unlink(missing_ok=True)
