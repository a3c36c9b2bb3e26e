"""Pictures of the documentation: each is made by one part of the demonstration, none by hand."""

import ast
import re
from collections import Counter
from importlib.util import find_spec
from pathlib import Path

import pytest

from gui.demonstration.scenes import SCENES, with_what_they_need

ROOT = Path(__file__).resolve().parents[3]
PICTURES = ROOT / "docs" / "pictures"


def names_in(module: str) -> list[re.Pattern[str]]:
    """Every text of a module; the gaps of an f-string stand for anything."""
    spec = find_spec(module)
    assert spec is not None
    assert spec.origin is not None
    found: list[str] = []
    for node in ast.walk(ast.parse(Path(spec.origin).read_text("utf-8"))):
        if isinstance(node, ast.JoinedStr):
            parts = [
                re.escape(v.value) if isinstance(v, ast.Constant) else ".+" for v in node.values
            ]
            found.append("".join(parts))
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            found.append(re.escape(node.value))
    return [re.compile(text) for text in found if text.strip(".+")]


def test_every_picture_is_made_by_exactly_one_part():
    made = Counter(file for scene in SCENES.values() for file in scene.files)
    assert [file for file, parts in made.items() if parts > 1] == []
    kept = {path.name for path in PICTURES.iterdir()}
    assert sorted(kept - set(made)) == [], "no part of the demonstration makes these"
    assert sorted(set(made) - kept) == [], "renew them: calrig demo --pictures docs/pictures"


@pytest.mark.parametrize("key", SCENES)
def test_a_part_takes_the_pictures_it_is_registered_for(key: str):
    scene = SCENES[key]
    said = names_in(scene.module)
    asked = (*scene.pictures, *scene.drawings)
    assert [name for name in asked if not any(text.fullmatch(name) for text in said)] == []


def test_every_demo_of_a_tab_is_registered():
    demos = {
        path.relative_to(ROOT).with_suffix("").as_posix().replace("/", ".")
        for path in (ROOT / "gui").glob("*/*demo.py")
        if path.parent.name != "commands"
    }
    assert demos - {scene.module for scene in SCENES.values()} == set()


def test_a_part_brings_those_whose_files_it_works_with():
    assert with_what_they_need(["comparison", "head"]) == ("head", "live", "allan", "comparison")
    assert with_what_they_need(SCENES) == tuple(SCENES)
