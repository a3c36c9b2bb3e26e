"""English sentences with numbers in them, as templates: what states, notes and errors say.

Core and drivers know no Qt, and presenters say the same in every language: their words are
translated where they are shown (`gui.languages.shown`). A template has a named gap for every
expression of an f-string: ``"{path}: the file has {rows} rows"``.
"""

import ast
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path, PurePath

from gui.languages.gui_texts import Sources, Text, gui_texts

CONTEXT = "Shown"
"""The one context of all that is translated where it is shown."""

_NOT_SHOWN = (
    "gui/certificate",
    "gui/commands",
    "gui/languages",
    "gui/demonstration",
    "gui/widgets/style_sheet.py",
    "gui/widgets/override_guard.py",
    "core/records/export_c.py",
    "core/records/export_c_effects.py",
    "core/records/export_mat.py",
    "core/procedures/thermal/export.py",
    "core/procedures/drift/export.py",
    "core/archive/tables.py",
    "drivers/teach/written.py",
    "drivers/virtual/pty_process.py",
    "drivers/virtual/pty_rig.py",
)
"""Words for programmers, consoles and files; and pages that are translated when they are made."""
_WORDS = (
    "angle", "angles", "code", "column", "done", "heading", "headings", "line", "now", "position",
    "positions", "problem", "rate", "rates", "row", "rows", "turn-on", "turn-ons",
    "session", "calibration", "legacy", "record", "means", "noise", "finished", "open", "good",
    "doubt", "bad", "damaged", "bias", "differs", "cross axis x", "cross axis y", "cross axis z",
    "Saturation", "Warm-up", "Outlier", "Drop-outs", "Clipping", "Hysteresis",
    "{n} files", "{n} headings", "{n} positions", "{n} rates", "{n} rows", "{n} samples",
)  # fmt: skip
"""What sentences are put together from while the program runs."""
_PLANS = "resources/plans"
_OWN_ERRORS = {"TypeError", "AssertionError", "RuntimeError", "NotImplementedError", "KeyError"}
"""Faults of the program; they are told as they are."""
_SILENT = {
    *_OWN_ERRORS, "setObjectName", "setStyleSheet", "setProperty", "translate", "tr", "compile",
    "import_module", "getattr", "TypeVar", "NewType", "cast", "strftime", "strptime", "execute",
    "start", "QKeySequence",
}  # fmt: skip
_WORD = re.compile(r"[A-Za-z]{2,}")
_CODE = re.compile(
    r"^\[\[\w+\]\]\n"
    r"|[<>{}\\]{2}|^[#/%*]|^\W*$|^[a-z]+(_[a-z0-9]+)+$|^\.|^--|=\"|\bSELECT\b|^[\w.]+$|^[\w.{}]+ = "
)
_GAP = re.compile(r"\{\w+\}")


def is_window(path: str) -> bool:
    """Whether a module draws by itself, so that Qt translates its words at once."""
    place = PurePath(path)
    if path.startswith(("gui/widgets/states", "gui/widgets/table_picture")):
        return False
    return (
        path.startswith(("gui/widgets/", "gui/certificate/"))
        or place.name in ("main_window.py", "view.py")
        or place.name.endswith("_view.py")
    )


def all_texts(sources: Sources) -> tuple[list[Text], list[str]]:
    """Return every text that can be on a screen, and complaints about what cannot be followed."""
    called, complaints = gui_texts(sources)
    # What is said below the views is found again as a template, wherever it came from.
    complaints = [one for one in complaints if is_window(one.partition(":")[0])]
    texts: dict[tuple[str, str], Text] = {}
    for text in called:
        context = text.context if is_window(text.place) else CONTEXT
        one = Text(context, text.source, text.place)
        texts.setdefault((context, text.source), one)
    for module in sources.modules.values():
        place = module.path.as_posix()
        if place.startswith(_NOT_SHOWN):
            continue
        for template in _templates(module.tree, gui=place.startswith("gui/")):
            texts.setdefault((CONTEXT, template), Text(CONTEXT, template, place))
    for word in _WORDS:
        texts.setdefault((CONTEXT, word), Text(CONTEXT, word, "gui/languages/plain_texts.py"))
    for path in sorted((sources.root / _PLANS).glob("*.toml")):
        for title in _titles(path):
            texts.setdefault((CONTEXT, title), Text(CONTEXT, title, f"{_PLANS}/{path.name}"))
    return list(texts.values()), complaints


def _titles(path: Path) -> Iterator[str]:
    """Titles of a plan and of its groups."""
    plan = tomllib.loads(path.read_text(encoding="utf-8"))
    yield plan["plan"]["title"]
    for group in plan["group"]:
        yield group["title"]


def _templates(tree: ast.Module, *, gui: bool) -> Iterator[str]:
    """Everything of a module that reads like words for the operator."""
    silent = _silent(tree)
    for node in ast.walk(tree):
        if id(node) in silent:
            continue
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            template = node.value
        elif isinstance(node, ast.JoinedStr):
            template = template_of(node)
        else:
            continue
        # A text in front stays outside: what is put behind another one keeps its separator.
        template = template.strip() if template[:2] not in (", ", "; ") else template.rstrip()
        if is_wording(template, gui=gui):
            yield template


def is_wording(template: str, *, gui: bool) -> bool:
    """Whether a literal is meant to be read: words with blanks, or a name with a capital."""
    bare = _GAP.sub("", template)
    if not _WORD.search(bare):
        return False
    if gui and re.fullmatch(r"[A-Z][a-z]{2,}\.?", template):
        return True
    return " " in template and _CODE.search(template) is None


def template_of(node: ast.JoinedStr) -> str:
    """Return an f-string with a named gap for each of its expressions; a name occurs once."""
    seen: dict[str, int] = {}
    parts: list[str] = []
    for value in node.values:
        if isinstance(value, ast.Constant):
            parts.append(str(value.value).replace("{", "").replace("}", ""))
            continue
        name = _name_of(value)
        seen[name] = seen.get(name, 0) + 1
        parts.append("{" + (name if seen[name] == 1 else f"{name}{seen[name]}") + "}")
    return "".join(parts)


def _name_of(node: ast.AST) -> str:
    """A short name for an expression: the last name in it."""
    names = [
        inner.attr if isinstance(inner, ast.Attribute) else inner.id
        for inner in ast.walk(node)
        if isinstance(inner, ast.Name | ast.Attribute)
    ]
    found = next((name.strip("_").lower() for name in names if len(name) > 1), "")
    return found or "x"


def _silent(tree: ast.Module) -> set[int]:
    """Nodes that are no words for the operator: docstrings, parts of templates, own faults."""
    silent: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            silent.add(id(node.value))
        elif isinstance(node, ast.JoinedStr):
            silent.update(id(inner) for inner in ast.walk(node) if inner is not node)
        elif isinstance(node, ast.Call) and _called(node.func) in _SILENT:
            silent.update(id(inner) for inner in ast.walk(node))
        elif isinstance(node, ast.arg | ast.AnnAssign) and node.annotation is not None:
            silent.update(id(inner) for inner in ast.walk(node.annotation))
        elif isinstance(node, ast.FunctionDef) and node.returns is not None:
            silent.update(id(inner) for inner in ast.walk(node.returns))
        elif isinstance(node, ast.Subscript | ast.MatchValue):
            inside = node.slice if isinstance(node, ast.Subscript) else node.value
            if isinstance(inside, ast.Constant):
                silent.add(id(inside))
    return silent


def _called(function: ast.expr) -> str:
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""
