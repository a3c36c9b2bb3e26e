"""English sentences are found as templates."""

import ast

import pytest

from gui.languages.plain_texts import is_window, is_wording, template_of


def template(source: str) -> str:
    node = ast.parse(source, mode="eval").body
    assert isinstance(node, ast.JoinedStr)
    return template_of(node)


def test_a_gap_has_the_name_of_what_fills_it():
    assert template("f'{path}: {self._count} rows'") == "{path}: {count} rows"


def test_two_gaps_of_one_name_are_told_apart():
    assert template("f'{a.rate} and {b.rate}'") == "{rate} and {rate2}"


def test_formats_do_not_matter():
    assert template("f'{1e3 * sigma:.3g} mg'") == "{sigma} mg"


@pytest.mark.parametrize("text", ["the file holds no rows", "{count} rows left out", "Not stored"])
def test_words_are_wording(text: str):
    assert is_wording(text, gui=False)


@pytest.mark.parametrize(
    "text",
    ["scale_factor", "%H:%M", "<b>{x}</b> {{y}}", "SELECT a FROM b", "g = {value}", "{a} {b}"],
)
def test_code_is_no_wording(text: str):
    assert not is_wording(text, gui=False)


def test_a_name_with_a_capital_is_wording_on_a_screen_only():
    assert is_wording("Sensor", gui=True)
    assert not is_wording("Sensor", gui=False)


@pytest.mark.parametrize(
    ("path", "window"),
    [
        ("gui/live/view.py", True),
        ("gui/live/charts_view.py", True),
        ("gui/widgets/stage.py", True),
        ("gui/live/presenter.py", False),
        ("gui/widgets/states.py", False),
        ("core/errors.py", False),
    ],
)
def test_views_translate_at_once_and_states_where_they_are_shown(path: str, window: bool):
    assert is_window(path) is window
