"""The files of all languages are complete and of today's sources; `gui.languages.update` mends."""

import re
from pathlib import Path

import pytest

from gui.languages import update
from gui.languages.gui_texts import Sources
from gui.languages.plain_texts import all_texts
from gui.languages.ts_file import Message, read_ts, ts_text

GAPS = re.compile(r"\{\w+\}")


@pytest.fixture(scope="module")
def found():
    return all_texts(update.Sources(update.ROOT, update.FOLDERS))


@pytest.fixture(params=[path.name for path in update.ts_files()])
def path(request) -> Path:
    return update.FOLDER / request.param


def test_every_text_of_the_sources_can_be_followed(found):
    assert found[1] == []


def test_extracting_again_changes_nothing(found, path: Path):
    messages = update.merged(found[0], read_ts(path))
    assert [m.source for m in messages if not m.translation] == []
    assert ts_text(update.language_of(path), messages) == path.read_text(encoding="utf-8")


def test_translations_keep_the_gaps_of_their_sources(path: Path):
    wrong = [
        (m.source, m.translation)
        for m in read_ts(path)
        if sorted(GAPS.findall(m.source)) != sorted(GAPS.findall(m.translation))
    ]
    assert wrong == []


def test_translations_keep_names_of_keys_and_filters_of_files(path: Path):
    for pattern in (r"Ctrl\+\w+", r"\*\.\w+", r"\bF\d+\b"):
        keys = re.compile(pattern)
        for m in read_ts(path):
            # Ctrl+wheel: what stands for a thing and not for a key may be translated.
            known = [key for key in keys.findall(m.source) if key != "Ctrl+wheel"]
            assert all(key in m.translation for key in known), m


def test_translations_keep_tags_and_have_letters_of_their_own_language(path: Path):
    strange = {"calrig_uk.ts": "[ЫыЭэЪъЁё]", "calrig_ru.ts": "[ІіЇїЄєҐґ]"}[path.name]
    for m in read_ts(path):
        assert re.findall(r"</?\w+[^>]*>", m.source) == re.findall(
            r"</?\w+[^>]*>", m.translation
        ), m
        assert m.source.count("&") == m.translation.count("&"), m
        assert m.source.count("\n") == m.translation.count("\n"), m
        assert not re.search(strange, m.translation), m


def test_what_the_program_loads_is_made_of_the_file(path: Path, tmp_path: Path):
    update.release(path, tmp_path / "fresh.qm")
    assert (tmp_path / "fresh.qm").read_bytes() == path.with_suffix(".qm").read_bytes()


def test_a_text_that_moves_keeps_its_words():
    known = [Message("Old", "Rate", "gui/a.py", "Швидкість")]
    moved = update.merged([update.Text("New", "Rate", "gui/b.py")], known)
    assert moved == [Message("New", "Rate", "gui/b.py", "Швидкість")]


def test_the_context_decides_where_one_word_has_two_meanings():
    known = [Message("A", "Rate", "", "Швидкість"), Message("B", "Rate", "", "Частота")]
    texts = [update.Text("B", "Rate", ""), update.Text("A", "Rate", "")]
    assert [m.translation for m in update.merged(texts, known)] == ["Частота", "Швидкість"]


def test_check_tells_what_is_missing_and_writes_nothing(tmp_path: Path, monkeypatch, capsys):
    file = tmp_path / "calrig_uk.ts"
    file.write_text(ts_text("uk", []), encoding="utf-8")
    monkeypatch.setattr(update, "FOLDER", tmp_path)
    monkeypatch.setattr(update, "FOLDERS", ("gui/archive",))
    assert update.main(["--check"]) == 1
    told = capsys.readouterr().out
    assert "uk: gui/archive/" in told
    assert "Refresh" in told
    assert re.search(r"uk: (\d+) of \1 texts lack a translation", told)
    assert read_ts(file) == []
    assert update.main([]) == 0
    assert "Refresh" in {m.source for m in read_ts(file)}
    assert file.with_suffix(".qm").exists()


def test_a_project_of_other_folders_is_read(tmp_path: Path):
    (tmp_path / "gui").mkdir()
    (tmp_path / "gui" / "view.py").write_text("def f(self): self.tr('Yes')\n", encoding="utf-8")
    texts, _ = all_texts(Sources(tmp_path, ("gui",)))
    assert "Yes" in {text.source for text in texts}
