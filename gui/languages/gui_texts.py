"""The words of the window as the sources say them, found without running anything.

Qt's own extractor sees literal ``self.tr("...")`` and ``QCoreApplication.translate("Context",
"...")`` alone and skips every other way silently. Here helpers that hand their argument on to
``translate`` are followed as well, and a text that cannot be found is an error.
"""

import ast
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True, slots=True)
class Text:
    """One text to translate.

    Parameters
    ----------
    context : the class or the name by which it is looked up
    source : the English words
    place : file of the sources, as a path below the project
    """

    context: str
    source: str
    place: str


@dataclass(frozen=True, slots=True)
class Helper:
    """A function whose argument is translated.

    Parameters
    ----------
    context : by which it looks up
    place : position of the argument that is translated
    """

    context: str
    place: int


@dataclass(slots=True)
class Module:
    """What one module of the sources tells.

    Parameters
    ----------
    path : below the project
    tree : its syntax
    helpers : functions defined here that translate their argument
    constants : values of names at module level and in classes, with the texts they can have
    imports : names brought from other modules: module and name there
    """

    path: Path
    tree: ast.Module
    helpers: dict[str, Helper] = field(default_factory=dict)
    constants: dict[str, ast.expr] = field(default_factory=dict)
    imports: dict[str, tuple[str, str]] = field(default_factory=dict)


class Sources:
    """All modules of some folders.

    Parameters
    ----------
    root : the project
    folders : below it, that are read
    """

    def __init__(self, root: Path, folders: Iterable[str]) -> None:
        self.root = root
        self.modules: dict[str, Module] = {}
        for folder in folders:
            for path in sorted((root / folder).rglob("*.py")):
                relative = path.relative_to(root)
                name = ".".join(relative.with_suffix("").parts).removesuffix(".__init__")
                tree = ast.parse(path.read_text(encoding="utf-8"), str(path))
                self.modules[name] = _module(relative, tree)

    def helper(self, module: Module, name: str) -> Helper | None:
        """The helper that a name of a module means."""
        if name in module.helpers:
            return module.helpers[name]
        origin = module.imports.get(name)
        if origin is None or origin[0] not in self.modules:
            return None
        return self.modules[origin[0]].helpers.get(origin[1])

    def constant(self, module: Module, name: str) -> ast.expr | None:
        """The value of a name at module level, wherever it was brought from."""
        if name in module.constants:
            return module.constants[name]
        origin = module.imports.get(name)
        if origin is None or origin[0] not in self.modules:
            return None
        return self.constant(self.modules[origin[0]], origin[1])


def gui_texts(sources: Sources) -> tuple[list[Text], list[str]]:
    """Texts of the window, and the places where a text could not be followed.

    Parameters
    ----------
    sources : gui, and core for the names that gui shows

    Returns
    -------
    tuple
        Texts in the order of the sources; complaints as ``file:line: what``.
    """
    texts: dict[tuple[str, str], Text] = {}
    complaints: list[str] = []
    for name, module in sources.modules.items():
        if not name.startswith("gui"):
            continue
        walker = _Walker(sources, module)
        walker.visit(module.tree)
        for text in walker.texts:
            texts.setdefault((text.context, text.source), text)
        complaints += walker.complaints
    return list(texts.values()), complaints


class _Walker(ast.NodeVisitor):
    """Finds the calls that translate, knowing class and function around them."""

    def __init__(self, sources: Sources, module: Module) -> None:
        self.texts: list[Text] = []
        self.complaints: list[str] = []
        self._sources = sources
        self._module = module
        self._classes: list[str] = []
        self._functions: list[Function] = []

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        self._classes.append(node.name)
        self.generic_visit(node)
        self._classes.pop()

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        self._functions.append(node)
        self.generic_visit(node)
        self._functions.pop()

    def visit_Call(self, node: ast.Call) -> None:
        self.generic_visit(node)
        function = node.func
        if isinstance(function, ast.Attribute) and function.attr == "tr":
            self._take(node, self._classes[-1] if self._classes else "", 0)
        elif _is_translate(function):
            self._take_translate(node)
        elif isinstance(function, ast.Name):
            helper = self._sources.helper(self._module, function.id)
            if helper is not None:
                self._take(node, helper.context, helper.place)

    def _take_translate(self, node: ast.Call) -> None:
        if len(node.args) < 2:
            return
        context = _literal(node.args[0])
        if self._functions and self._functions[-1].name in self._module.helpers:
            return
        if context is None:
            self._complain(node, "the context is no literal")
            return
        self._take(node, context, 1)

    def _take(self, node: ast.Call, context: str, place: int) -> None:
        if len(node.args) <= place:
            return
        found = list(self._strings(node.args[place], 0))
        if not found:
            self._complain(node, f"{ast.unparse(node.args[place])} cannot be followed")
        where = self._module.path.as_posix()
        self.texts += [Text(context, text, where) for text in found if text]

    def _complain(self, node: ast.AST, what: str) -> None:
        line = getattr(node, "lineno", 0)
        self.complaints.append(f"{self._module.path.as_posix()}:{line}: {what}")

    def _strings(self, node: ast.expr, depth: int) -> Iterator[str]:
        """All texts that an expression can be."""
        if depth > 6:
            return
        text = _literal(node)
        if text is not None:
            yield text
        elif isinstance(node, ast.Name):
            yield from self._named(node.id, depth)
        else:
            for part in _parts(node):
                yield from self._strings(part, depth + 1)

    def _named(self, name: str, depth: int) -> Iterator[str]:
        """Texts of a name: a local one, that of a loop, or a constant of a module."""
        found = False
        for function in reversed(self._functions):
            for value in _values_of(function, name):
                found = True
                yield from self._strings(value, depth + 1)
        if not found:
            constant = self._sources.constant(self._module, name)
            if constant is not None:
                yield from self._strings(constant, depth + 1)


def _parts(node: ast.expr) -> list[ast.expr]:
    """What the value of an expression is one of."""
    if isinstance(node, ast.IfExp):
        return [node.body, node.orelse]
    if isinstance(node, ast.Dict):
        return node.values
    if isinstance(node, ast.Tuple | ast.List):
        return node.elts
    if isinstance(node, ast.Subscript | ast.Starred):
        return [node.value]
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        return [node.func.value] if node.func.attr in ("get", "items", "values") else []
    return []


def _values_of(function: Function, name: str) -> Iterator[ast.expr]:
    """What is assigned to a local name, in a statement, a loop or a comprehension."""
    for node in ast.walk(function):
        if isinstance(node, ast.Assign):
            for target in node.targets:
                yield from _bound(target, node.value, name)
        elif isinstance(node, ast.AnnAssign) and node.value is not None:
            yield from _bound(node.target, node.value, name)
        elif isinstance(node, ast.For | ast.comprehension):
            for one in _elements(node.iter):
                yield from _bound(node.target, one, name)


def _elements(node: ast.expr) -> Iterator[ast.expr]:
    """What a loop goes through."""
    if isinstance(node, ast.Tuple | ast.List):
        yield from node.elts
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        if node.func.attr == "items" and isinstance(node.func.value, ast.Dict):
            keys, values = node.func.value.keys, node.func.value.values
            for key, value in zip(keys, values, strict=True):
                if key is not None:
                    yield ast.Tuple([key, value], ast.Load())
        else:
            yield node.func.value
    elif isinstance(node, ast.Name):
        yield node


def _bound(target: ast.expr, value: ast.expr, name: str) -> Iterator[ast.expr]:
    if isinstance(target, ast.Name):
        if target.id == name:
            yield value
    elif isinstance(target, ast.Tuple):
        if isinstance(value, ast.Tuple) and len(value.elts) == len(target.elts):
            for inner, one in zip(target.elts, value.elts, strict=True):
                yield from _bound(inner, one, name)
        elif any(isinstance(inner, ast.Name) and inner.id == name for inner in target.elts):
            yield value


def _literal(node: ast.expr) -> str | None:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    return None


def _is_translate(function: ast.expr) -> bool:
    if isinstance(function, ast.Name):
        return function.id == "translate"
    # Painters have a method of that name too, which moves the origin.
    return (
        isinstance(function, ast.Attribute)
        and function.attr == "translate"
        and isinstance(function.value, ast.Name)
        and function.value.id == "QCoreApplication"
    )


def _module(path: Path, tree: ast.Module) -> Module:
    module = Module(path, tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module:
            for alias in node.names:
                module.imports[alias.asname or alias.name] = (node.module, alias.name)
        elif isinstance(node, ast.FunctionDef):
            helper = _helper_of(node)
            if helper is not None:
                module.helpers[node.name] = helper
    for statement in tree.body:
        if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
            module.constants[statement.targets[0].id] = statement.value
        elif (
            isinstance(statement, ast.AnnAssign)
            and isinstance(statement.target, ast.Name)
            and statement.value is not None
        ):
            module.constants[statement.target.id] = statement.value
    return module


def _helper_of(function: ast.FunctionDef) -> Helper | None:
    """A function that returns the translation of one of its arguments as it came."""
    names = [argument.arg for argument in function.args.args]
    for node in ast.walk(function):
        if isinstance(node, ast.Call) and _is_translate(node.func) and len(node.args) >= 2:
            context, text = _literal(node.args[0]), node.args[1]
            if context is not None and isinstance(text, ast.Name) and text.id in names:
                return Helper(context, names.index(text.id))
    return None
