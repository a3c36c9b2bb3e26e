"""The page Fourier tumble: load, decide, refuse, export; what is shown is what was found."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtGui import QImage
from pytestqt.qtbot import QtBot

from core.records.open import read_any
from core.records.run_file import write_run
from gui.methods.tab import MethodsTab
from gui.tumble.page import TumblePage
from gui.tumble.presenter import TumblePresenter

LEGACY = Path(__file__).parents[2] / "data" / "legacy" / "OpticalDividingHead_202405131405.txt"


@pytest.fixture
def page(tab: MethodsTab) -> TumblePage:
    tab.open("tumble")
    made = tab.pages["tumble"]
    assert isinstance(made, TumblePage)
    return made


def done(presenter: TumblePresenter, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not presenter._busy, timeout=20_000)


def load(page: TumblePage, path: Path, qtbot: QtBot) -> None:
    page.widget.file_chosen.emit(str(path))
    done(page.presenter, qtbot)


def both_mounts(tumble_file: Callable[..., Path]) -> Path:
    one, other = (read_any(tumble_file(f"{f}.run.csv", flipped=f)) for f in (False, True))
    rows = [*range(len(one)), *range(len(other))]
    joined = replace(
        one.rows(rows),
        mount=(*one.mount, *other.mount),
        y=np.vstack([one.y, other.y]),
    )
    path = tumble_file("both.run.csv")
    write_run(joined, path)
    return path


def test_a_run_is_shown_with_all_that_it_tells(
    page: TumblePage, tumble_file: Callable[..., Path], qtbot: QtBot
):
    assert page.presenter.state.frame.hint
    load(page, tumble_file(), qtbot)
    state = page.presenter.state
    assert state.frame.hint == ""
    assert state.frame.findings is not None
    first, split, drift, pairs = state.frame.findings.tables
    assert [row[0] for row in first.rows][-2:] == ["sin 2α", "cos 2α"]
    assert first.rows[0][1].startswith("2.5000")
    assert split.rows[3][0].startswith("k_xy")
    assert "40" in drift.rows[0][0]
    assert len(pairs.rows) == 4
    assert any("K2" in note.text for note in state.frame.findings.notes)
    assert page.widget.findings.isVisible()
    assert [table.isVisible() for table in page.widget.findings.tables] == [True] * 4


def test_the_pictures_hold_every_reading_and_every_harmonic(
    page: TumblePage, tumble_file: Callable[..., Path], qtbot: QtBot
):
    load(page, tumble_file(noise=1e-4), qtbot)
    state = page.presenter.state
    assert state.polar is not None
    assert state.bars is not None
    assert sum(len(series.residual) for series in state.polar.series) == 400
    assert len(state.polar.series) == 5
    outside = sum(int(np.sum(abs(s.residual) > s.u95)) for s in state.polar.series)
    # 5 % of 400, less what the stated error of the head makes room for.
    assert 5 <= outside <= 30
    assert [bar.label for bar in state.bars.bars] == ["sin α", "cos α", "sin 2α", "cos 2α"]
    assert [bar.seen for bar in state.bars.bars[:3]] == [True, True, True]
    page.presenter.decide(replace(state.choices, harmonics=3))
    done(page.presenter, qtbot)
    bars = page.presenter.state.bars
    assert bars is not None
    assert [bar.seen for bar in bars.bars[4:]] == [False, False]


def test_two_mounts_tell_fixture_and_sensor_apart(
    page: TumblePage, tumble_file: Callable[..., Path], qtbot: QtBot
):
    load(page, both_mounts(tumble_file), qtbot)
    findings = page.presenter.state.frame.findings
    assert findings is not None
    assert len(findings.tables) == 5
    assert [row[0] for row in findings.tables[2].rows][-1] == "K2"


def test_the_form_decides_and_the_numbers_follow(
    page: TumblePage, tumble_file: Callable[..., Path], qtbot: QtBot
):
    load(page, tumble_file(), qtbot)
    page.side.g.setValue(1.0)
    done(page.presenter, qtbot)
    study = page.presenter.study
    assert study is not None
    assert study.tumbles[0].sensitivity.value == pytest.approx(-1.0, abs=1e-3)
    assert study.split is not None
    before = study.split.k_x.value
    page.side.projection.setChecked(True)
    done(page.presenter, qtbot)
    study = page.presenter.study
    assert study is not None
    assert study.split is not None
    assert study.split.k_x.value == pytest.approx(-before)


def test_what_is_decided_while_it_computes_is_not_lost(
    page: TumblePage, tumble_file: Callable[..., Path], qtbot: QtBot
):
    load(page, tumble_file(), qtbot)
    presenter = page.presenter
    for g in (1.0, 2.0, 3.0):
        presenter.decide(replace(presenter.state.choices, g_mps2=g))
    done(presenter, qtbot)
    assert presenter.study is not None
    assert presenter.study.tumbles[0].g_mps2 == 3.0


def test_a_run_at_right_angles_alone_is_refused_in_words(
    tab: MethodsTab, page: TumblePage, tumble_file: Callable[..., Path], qtbot: QtBot
):
    run = read_any(tumble_file())
    path = tumble_file("quarters.run.csv")
    write_run(run.rows([i for i, a in enumerate(run.head_deg) if a % 90.0 == 0.0]), path)
    load(page, path, qtbot)
    assert page.presenter.study is None
    assert "second harmonic is invisible" in page.presenter.state.frame.hint
    assert not page.widget.action_bar.button("export").isEnabled()
    assert tab.messages.current is not None


def test_a_file_that_is_none_leaves_the_result_that_was_there(
    tab: MethodsTab, page: TumblePage, tumble_file: Callable[..., Path], qtbot: QtBot
):
    load(page, tumble_file(), qtbot)
    load(page, Path(tab.root) / "absent.csv", qtbot)
    assert tab.messages.current is not None
    assert "absent.csv" in tab.messages.current.meaning
    assert page.presenter.study is not None


def test_there_is_no_measured_session_yet(tab: MethodsTab, page: TumblePage, qtbot: QtBot):
    page.widget.action_bar.button("session").click()
    done(page.presenter, qtbot)
    assert tab.messages.current is not None
    assert "no session of the dividing head" in tab.messages.current.meaning


@pytest.mark.parametrize("key", ["csv", "json", "svg", "png", "pdf"])
def test_every_export_is_written(
    page: TumblePage, tumble_file: Callable[..., Path], qtbot: QtBot, tmp_path: Path, key: str
):
    load(page, tumble_file(), qtbot)
    page.exporting.export(key, str(tmp_path / f"out.{key}"))
    path = tmp_path / f"out.{key}"
    if key == "json":
        data = json.loads(path.read_text("utf-8"))
        assert data["tumble"]["tumbles"][0]["bias"]["value"] == pytest.approx(2.5, abs=1e-4)
    elif key == "csv":
        assert "\nsin 2α,0.0004997" in path.read_text("utf-8")
    elif key == "png":
        assert QImage(str(path)).width() > 500
    else:
        assert path.stat().st_size > 5000


def test_export_without_a_result_writes_nothing(page: TumblePage, tmp_path: Path):
    page.exporting.export("csv", str(tmp_path / "none.csv"))
    assert not (tmp_path / "none.csv").exists()


def test_the_pictures_paint_in_any_size(
    page: TumblePage, tumble_file: Callable[..., Path], qtbot: QtBot
):
    load(page, tumble_file(noise=5e-3), qtbot)
    for width, height in ((200, 160), (900, 300), (1600, 1200)):
        page.content.resize(width, height)
        assert not page.content.grab().isNull()


def test_a_legacy_file_of_two_devices_asks_which_one_is_meant(
    tab: MethodsTab, page: TumblePage, qtbot: QtBot, tmp_path: Path
):
    text = LEGACY.read_text("utf-8")
    rows = [line for line in text.splitlines() if "Colibrys" in line]
    path = tmp_path / "two.txt"
    others = "\n".join(line.replace("Colibrys", "Other") for line in rows)
    path.write_text(f"{text.rstrip()}\n{others}\n", encoding="utf-8")
    load(page, path, qtbot)
    banner = tab.messages.current
    assert banner is not None
    assert [action.text for action in banner.actions] == ["Colibrys", "Other"]
    tab.messages.press(banner.actions[1].key)
    done(page.presenter, qtbot)
    assert page.presenter.device == "Other"
    # Four positions of a unit show no second harmonic.
    assert "multiples of 90" in page.presenter.state.frame.hint
