"""Texts of the window are found in the sources, whatever way they take to Qt."""

from pathlib import Path

from gui.languages.gui_texts import Sources, gui_texts


def texts_of(folder: Path, **modules: str) -> tuple[set[tuple[str, str]], list[str]]:
    (folder / "gui").mkdir()
    for name, source in modules.items():
        (folder / "gui" / f"{name}.py").write_text(source, encoding="utf-8")
    texts, complaints = gui_texts(Sources(folder, ("gui",)))
    return {(text.context, text.source) for text in texts}, complaints


def test_tr_has_the_context_of_its_class(tmp_path: Path):
    source = "class A:\n    def f(self):\n        self.tr('One')\n"
    assert texts_of(tmp_path, a=source) == ({("A", "One")}, [])


def test_translate_has_the_context_that_it_names(tmp_path: Path):
    source = "def f():\n    return QCoreApplication.translate('Ctx', 'Two')\n"
    assert texts_of(tmp_path, a=source) == ({("Ctx", "Two")}, [])


def test_an_alias_of_translate_is_followed(tmp_path: Path):
    source = (
        "def f():\n    translate = QCoreApplication.translate\n    return translate('C', 'Three')\n"
    )
    assert texts_of(tmp_path, a=source) == ({("C", "Three")}, [])


def test_a_helper_is_followed_also_from_another_module(tmp_path: Path):
    helper = "def say(text):\n    return QCoreApplication.translate('Help', text)\n"
    user = "from gui.a import say\n\ndef f(on):\n    return say('On' if on else 'Off')\n"
    found, complaints = texts_of(tmp_path, a=helper, b=user)
    assert found == {("Help", "On"), ("Help", "Off")}
    assert complaints == []


def test_a_table_of_words_is_followed(tmp_path: Path):
    source = (
        "WORDS = {'a': 'Apple', 'b': 'Pear'}\n"
        "class V:\n    def f(self, key):\n        return self.tr(WORDS[key])\n"
    )
    assert texts_of(tmp_path, a=source)[0] == {("V", "Apple"), ("V", "Pear")}


def test_words_of_a_loop_are_followed(tmp_path: Path):
    source = (
        "class V:\n    def f(self):\n"
        "        for key, word in (('a', 'First'), ('b', 'Second')):\n"
        "            self.tr(word)\n"
    )
    assert texts_of(tmp_path, a=source)[0] == {("V", "First"), ("V", "Second")}


def test_a_text_made_while_running_is_a_complaint(tmp_path: Path):
    source = "class V:\n    def f(self, x):\n        self.tr(f'{x} rows')\n"
    found, complaints = texts_of(tmp_path, view=source)
    assert found == set()
    assert complaints == ["gui/view.py:3: f'{x} rows' cannot be followed"]


def test_a_painter_that_moves_its_origin_says_nothing(tmp_path: Path):
    assert texts_of(tmp_path, a="def f(p):\n    p.translate(0, 5)\n") == (set(), [])
