"""Sealed cases, the judgement of answers, and the page of trials."""

import hashlib
import json

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from core.discrepancy.settings import Settings
from core.model.catalogue.listing import CATALOGUE
from gui.discrepancy.cards import following_of
from gui.discrepancy.overview import found_of, notes_of
from gui.discrepancy.tab import DiscrepancyTab
from gui.discrepancy.trial import (
    KINDS,
    Score,
    hidden_in,
    is_right,
    make_case,
    named_by_operator,
    named_by_program,
    score_of,
    story_of,
)
from gui.discrepancy.trial_presenter import SECTION, kind_words, section_of
from gui.discrepancy.working import searched
from gui.widgets.states import Tone

_LONG = 60_000


def test_a_case_is_the_same_for_everybody_and_its_seal_holds():
    case, again = make_case(5), make_case(5)
    np.testing.assert_array_equal(case.run.y, again.run.y)
    assert case.seal == again.seal == hashlib.sha256(case.key.encode()).hexdigest()
    document = json.loads(case.key)
    assert sorted(one["effect"] for one in document["hidden"]) == list(case.truth)
    assert make_case(6).seal != case.seal


def test_all_that_can_be_hidden_is_of_the_catalogue_and_comes_up():
    for kind, test in zip(
        KINDS, ("dividing_head", "rate_table", "static_positions", "record"), strict=True
    ):
        assert all(test in CATALOGUE[name].tests for name in hidden_in(kind))
    assert [len(make_case(seed).truth) for seed in (3, 4, 5)] == [0, 1, 2]


@pytest.mark.parametrize(
    ("kind", "seed", "truth"),
    [
        ("table", 2, ("second_order_nonlinearity",)),
        ("rest", 6, ("magnetic_sensitivity",)),
        ("record", 4, ("damping_anisotropy",)),
    ],
)
def test_a_case_of_each_kind_is_found_and_leaks_nothing_before(
    kind: str, seed: int, truth: tuple[str, ...]
):
    case = make_case(seed, kind)
    assert case.truth == truth
    assert case.seal == make_case(seed, kind).seal != make_case(seed).seal
    story = story_of(case, Settings(advise=False), lambda _: None)
    assert story.told.before.gap > 1.3
    assert found_of(story) == ()
    assert following_of(story) == ()
    assert len(notes_of(story, "")) <= 2
    best = searched(story, lambda _: None).proposed
    assert best is not None
    named = named_by_program(best)
    assert is_right(truth, named)
    assert is_right(truth, named_by_operator(best, truth))


def test_every_kind_has_its_own_score_and_the_first_keeps_its_place():
    assert section_of("head") == SECTION
    assert len({section_of(kind) for kind in KINDS}) == len(KINDS)
    assert set(kind_words()) == set(KINDS)


def test_the_plain_model_is_rejected_where_something_is_hidden():
    quiet, loud = make_case(3), make_case(7)
    assert quiet.truth == ()
    assert loud.truth == ("third_order_nonlinearity",)
    settings = Settings(advise=False)
    calm = story_of(quiet, settings, lambda _: None).told.before.gap
    bent = story_of(loud, settings, lambda _: None).told
    assert calm < 1.35 < 1.8 < bent.before.gap
    named = named_by_operator(bent, ["third_order_nonlinearity"])
    assert named[0][0] == "third_order_nonlinearity"


@pytest.mark.parametrize(
    ("truth", "named", "right"),
    [
        ((), [], True),
        ((), [("outlier",)], False),
        (("outlier",), [("wrong_angle", "outlier")], True),
        (("outlier",), [("outlier",), ("hysteresis",)], False),
        (("bias_jump", "outlier"), [("outlier",), ("bias_jump", "warm_up")], True),
        (("bias_jump", "outlier"), [("outlier", "bias_jump")], False),
        (("bias_jump",), [("warm_up",)], False),
    ],
)
def test_answers_are_judged_as_sets(truth: tuple, named: list, right: bool):
    assert is_right(truth, named) is right


def test_the_score_comes_back_and_nonsense_does_not():
    score = Score().after(operator=True, program=False).after(operator=False, program=True)
    assert score == Score(2, 1, 1, 0)
    assert score_of(score.to_section()) == Score(2, 1, 1, 2)
    assert score_of({"cases": "x", "operator": -1, "program": True}) == Score()
    assert score_of({"cases": 2, "operator": 9}).operator == 2


@pytest.mark.timeout(240)
def test_a_case_is_looked_at_named_and_opened(qtbot: QtBot, tab: DiscrepancyTab):
    pages, view = tab.view.findings.pages, tab.trial_view
    assert not pages.isTabVisible(3)
    tab.trial._settings.store(SECTION, {"cases": 6, "operator": 2, "program": 5, "begun": 6})
    tab.trial._scores["head"] = score_of(tab.trial._settings.section(SECTION))
    qtbot.mouseClick(tab.view.action_bar.button("trial"), Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: pages.currentIndex() == 3, timeout=_LONG)
    qtbot.waitUntil(lambda: not tab.presenter.busy, timeout=_LONG)
    state = tab.trial.state
    assert state is not None
    assert state.title == "Case 7: accelerometer on the dividing head"
    assert make_case(7).seal == state.seal
    assert state.seal[:16] in view.seal.text()
    for key in ("find", "add", "all", "calibrate", "report"):
        assert not tab.view.action_bar.button(key).isEnabled()
    assert tab.presenter.state.following == ()
    assert tab.presenter.state.picture is not None
    assert tab.exporting.propose("pdf") == ""
    assert not view.lines.isVisible()

    place = hidden_in("head").index("third_order_nonlinearity")
    view.names.setCurrentRow(place)
    view.names.setFocus()
    qtbot.keyClick(view.names, Qt.Key.Key_Space)
    assert "Third-order nonlinearity K3" in view.answer.text()
    qtbot.keyClick(view.names, Qt.Key.Key_Space)
    assert "nothing is missing" in view.answer.text()
    qtbot.keyClick(view.names, Qt.Key.Key_Space)

    # The answer takes more room than before; the buttons below it move.
    qtbot.wait(50)
    qtbot.mouseClick(view.reveal, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: view.lines.isVisible(), timeout=_LONG)
    state = tab.trial.state
    assert state is not None
    assert state.tone is Tone.GOOD
    assert "Hidden: Third-order nonlinearity K3" in state.lines[0]
    assert "(correct)" in state.lines[1]
    assert "Step 1 of the program: Third-order" in state.lines[2]
    assert make_case(7).key in state.lines[-1]
    assert "Of 7 cases you had 3 right" in state.score
    assert tab.trial._settings.section(SECTION)["cases"] == 7
    assert tab.view.action_bar.button("find").isEnabled()
    assert not view.reveal.isEnabled()

    qtbot.wait(50)
    view.kinds.setCurrentIndex(KINDS.index("table"))
    view.kinds.activated.emit(KINDS.index("table"))
    assert tab.trial._settings.section(SECTION)["kind"] == "table"
    assert "Case 7" in view.title.text()
    qtbot.mouseClick(view.again, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: view.title.text() == "Case 1: gyro on the rate table", timeout=_LONG)
    assert "nothing is missing" in view.answer.text()
    assert not view.lines.isVisible()
    assert view.names.count() == len(hidden_in("table"))
    assert "No case was opened yet" in view.score.text()
    assert tab.trial._settings.section(SECTION)["cases"] == 7
    assert tab.trial._settings.section(section_of("table"))["begun"] == 1
