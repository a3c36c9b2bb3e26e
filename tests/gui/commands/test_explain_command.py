"""explain, and simulate with effects by their identifiers, as a user calls them."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.records.run_file import write_run
from drivers.virtual.devices import make_device
from gui.commands.table import run_command
from tests.core.discrepancy.hidden import APART, head_run


def test_a_hidden_effect_is_named_in_words_and_in_json(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    path, out = tmp_path / "bent.run.csv", tmp_path / "out.json"
    write_run(head_run(lambda q: 4e-4 * q.a[:, 2] ** 2, APART), path)
    assert run_command("explain", [str(path), "--json", str(out)]) == 0
    printed = capsys.readouterr().out
    assert "second_order_nonlinearity" in printed
    assert "noise floor" in printed
    document = json.loads(out.read_text("utf-8"))
    (step,) = document["steps"]
    assert step["effect"] == "second_order_nonlinearity"
    assert step["gap_after"] < document["before"]["gap"]


def test_a_clean_run_lists_what_it_could_have_shown(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    path = tmp_path / "clean.run.csv"
    write_run(head_run(), path)
    assert run_command("explain", [str(path), "--max-effects", "2", "--alpha", "0.02"]) == 0
    printed = capsys.readouterr().out
    assert "adequate" in printed
    assert "smallest sizes" in printed


def test_four_rows_are_told_to_be_too_few(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    path = tmp_path / "four.run.csv"
    write_run(head_run(rows=[(1, "X_from", a) for a in (0.0, 90.0, 180.0, 270.0)]), path)
    assert run_command("explain", [str(path)]) == 0
    assert "not_enough_data" in capsys.readouterr().out


def test_an_output_that_is_no_number_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    run = head_run()
    y = run.y.copy()
    y[2] = np.nan
    path = tmp_path / "hole.run.csv"
    write_run(replace(run, y=y), path)
    assert run_command("explain", [str(path)]) == 2
    assert capsys.readouterr().err.startswith("calrig explain: ")


def test_the_rig_plays_the_effect_that_explain_then_names(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    """4 mg/g^2 on one sensor of the unit: eight positions see it, and cannot tell K2 alone."""
    folder = tmp_path / "played"
    arguments = ["pointer", str(folder), "--accumulation", "1", "--replicates", "3"]
    arguments += ["--effects", "acc.z/second_order_nonlinearity=4", "--setting-arcsec", "1"]
    assert run_command("simulate", arguments) == 0
    assert run_command("explain", [str(folder), "--json", "-"]) == 0
    text = capsys.readouterr().out
    document = json.loads(text[text.index("{\n") :])
    named = {
        name
        for step in document["steps"]
        for name in (step["effect"], *step["indistinguishable_from"])
    }
    assert "second_order_nonlinearity" in named


def test_shapes_follow_the_parameters_and_what_lies_between_rows_is_refused():
    device = make_device("clbacc", 1)
    warm = device.with_effect("adc.1/warm_up", (2.0, 7.5)).outputs[0].model.effects[-1]
    assert warm.shape[0][1] == 7.5
    assert device.with_effect("adc.1/warm_up", (2.0,)).timed
    with pytest.raises(ValueError, match="takes 1 values"):
        device.with_effect("adc.1/warm_up", (1.0, 2.0, 3.0))
    with pytest.raises(ValueError, match="between rows"):
        device.with_effect("positions_swapped", ())


def test_the_rig_plays_an_effect_by_the_response_of_its_sensor():
    device = make_device("clbacc", 1)
    bent = device.with_effect("adc.1/second_order_nonlinearity", (1.0,)).outputs[0]
    assert bent.model.sensor.sensitivity[2] == pytest.approx(1328.0691)
