"""The page Gyrocompass: north from a run, the advice from the noise, refusals in words."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from gui.gyrocompass.page import CompassPage
from gui.methods.tab import MethodsTab

NOISE = (2e-5, 1e-6, 5e-8)


@pytest.fixture
def page(tab: MethodsTab) -> CompassPage:
    tab.open("gyrocompass")
    made = tab.pages["gyrocompass"]
    assert isinstance(made, CompassPage)
    return made


def done(page: CompassPage, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not page.presenter._busy, timeout=30_000)


def load(page: CompassPage, path: Path, qtbot: QtBot) -> None:
    page.widget.file_chosen.emit(str(path))
    done(page, qtbot)


def test_heading_and_drift_of_a_run(
    page: CompassPage, headings_file: Callable[..., Path], qtbot: QtBot
):
    load(page, headings_file(), qtbot)
    found = page.presenter.found.compass
    assert found is not None
    assert found.heading.value == pytest.approx(37.3, abs=0.3)
    assert found.drift.value == pytest.approx(0.8, abs=0.05)
    rose = page.presenter.state.rose
    assert rose.low_deg < 37.3 < rose.high_deg
    assert rose.readings_deg[1] == pytest.approx(found.heading.value + 90.0)
    assert "37." in page.content.compass.accessibleDescription()
    assert not page.side.headings.isEnabled()


def test_the_latitude_is_compared_and_the_south_is_no_other_world(
    page: CompassPage, headings_file: Callable[..., Path], qtbot: QtBot
):
    load(page, headings_file(), qtbot)
    page.side.latitude.setValue(10.0)
    done(page, qtbot)
    notes = page.presenter.state.frame.findings.notes
    assert any(note.subject == "level_rate" for note in notes)
    page.side.latitude.setValue(-50.45)
    done(page, qtbot)
    notes = page.presenter.state.frame.findings.notes
    assert not any(note.subject == "level_rate" for note in notes)
    page.side.latitude.setValue(page.side.latitude.minimum())
    done(page, qtbot)
    assert np.isnan(page.presenter.state.choices.latitude_deg)
    notes = page.presenter.state.frame.findings.notes
    assert any(note.subject == "latitude_missing" for note in notes)


def test_at_the_pole_it_says_that_there_is_no_heading(
    page: CompassPage, headings_file: Callable[..., Path], qtbot: QtBot
):
    load(page, headings_file(), qtbot)
    page.presenter.set_noise(NOISE)
    done(page, qtbot)
    page.side.latitude.setValue(90.0)
    done(page, qtbot)
    texts = [note.text for note in page.presenter.state.frame.findings.notes]
    assert len(texts) == 2
    assert any("at a pole" in text for text in texts)
    assert page.presenter.state.advice is None


def test_an_output_that_is_no_rate_needs_the_scale_factor(
    page: CompassPage, headings_file: Callable[..., Path], qtbot: QtBot
):
    load(page, headings_file("code.run.csv", "code", 25.0), qtbot)
    findings = page.presenter.state.frame.findings
    assert "state the scale factor" in findings.notes[0].text
    page.side.scale.setValue(25.0 * 3600.0)
    done(page, qtbot)
    found = page.presenter.found.compass
    assert found is not None
    assert found.drift.value == pytest.approx(0.8, abs=0.05)


def test_opposite_headings_are_refused_in_words(
    page: CompassPage, headings_file: Callable[..., Path], qtbot: QtBot
):
    load(page, headings_file(headings=(0.0, 180.0, 0.0, 180.0)), qtbot)
    assert "steps of 90" in page.presenter.state.frame.findings.notes[0].text


def test_the_noise_tells_how_long_to_average_before_anything_is_measured(
    page: CompassPage, qtbot: QtBot
):
    assert page.presenter.state.advice is None
    page.presenter.set_noise(NOISE)
    done(page, qtbot)
    advice = page.presenter.state.advice
    assert advice is not None
    # The paper's figure: 0.1 degree by four steps of 90 degrees with averages of 10 s.
    assert advice.now_deg == pytest.approx(0.098, abs=0.003)
    assert advice.curve.enough_s == pytest.approx(10.0, rel=0.15)
    page.side.average.setValue(40.0)
    done(page, qtbot)
    better = page.presenter.state.advice
    assert better is not None
    assert better.now_deg == pytest.approx(advice.now_deg / 2.0, rel=0.1)
    assert page.content.plot.isVisible()


def test_more_headings_are_planned_for(page: CompassPage, qtbot: QtBot):
    page.presenter.set_noise(NOISE)
    done(page, qtbot)
    page.side.headings.setCurrentIndex(3)
    done(page, qtbot)
    advice = page.presenter.state.advice
    assert advice is not None
    assert advice.headings_deg == tuple(45.0 * n for n in range(8))
    assert page.presenter.state.rose.readings_deg == advice.headings_deg


def test_the_noise_of_a_record_is_taken(page: CompassPage, qtbot: QtBot, tmp_path: Path):
    rate, n = 50.0, 60_000
    white = 2e-4 * np.sqrt(rate) * np.random.default_rng(2).standard_normal(n)
    path = tmp_path / "rest.csv"
    rows = "\n".join(f"{i / rate:.3f},{w:.9f}" for i, w in enumerate(white))
    path.write_text("t_s,rate_z_dps\n" + rows + "\n", encoding="utf-8")
    page.side.noise.record_chosen.emit(str(path))
    qtbot.waitUntil(lambda: page.presenter.state.advice is not None, timeout=30_000)
    done(page, qtbot)
    choices = page.presenter.state.choices
    assert choices.noise[0] == pytest.approx(2e-4, rel=0.05)
    assert "rest.csv" in choices.noise_source
    assert page.side.noise.fields[0].value() == pytest.approx(60.0 * choices.noise[0], abs=1e-5)


def test_a_field_that_is_not_touched_keeps_its_digits(page: CompassPage, qtbot: QtBot):
    page.presenter.set_noise((1.23456789e-5, 1.1e-9, 0.0))
    done(page, qtbot)
    page.side.noise.fields[2].setValue(0.5)
    done(page, qtbot)
    n, b, k = page.presenter.state.choices.noise
    assert (n, b) == (1.23456789e-5, 1.1e-9)
    assert k == pytest.approx(0.5 / 3600.0 / 60.0)


def test_a_refused_file_leaves_what_was_there(
    tab: MethodsTab, page: CompassPage, headings_file: Callable[..., Path], qtbot: QtBot
):
    load(page, headings_file(), qtbot)
    load(page, Path(tab.root) / "absent.csv", qtbot)
    assert tab.messages.current is not None
    assert page.presenter.found.compass is not None


def test_the_ramp_is_a_row_of_the_table(
    page: CompassPage, headings_file: Callable[..., Path], qtbot: QtBot
):
    load(page, headings_file(), qtbot)
    rows = len(page.presenter.state.frame.findings.tables[0].rows)
    page.presenter.decide(replace(page.presenter.state.choices, ramp=True))
    done(page, qtbot)
    assert len(page.presenter.state.frame.findings.tables[0].rows) == rows + 1


def test_results_are_exported(
    page: CompassPage, headings_file: Callable[..., Path], qtbot: QtBot, tmp_path: Path
):
    load(page, headings_file(), qtbot)
    page.presenter.set_noise(NOISE)
    done(page, qtbot)
    page.exporting.export("json", str(tmp_path / "g.json"))
    data = json.loads((tmp_path / "g.json").read_text("utf-8"))
    assert data["gyrocompass"]["heading"]["value"] == pytest.approx(37.3, abs=0.3)
    assert data["advice"]["curve"]["best_s"] > 10.0
    page.exporting.export("svg", str(tmp_path / "g.svg"))
    assert (tmp_path / "g.svg").stat().st_size > 5000
