"""Keeps a Python error in a method that Qt calls from ending the program.

PySide6 (6.8.3 to 6.11.3 tried) on CPython below 3.12 dies of a segmentation fault where an
overridden method of Qt raises what the interpreter itself raised, such as 1/0 or ``float("x")``
in a ``paintEvent``: it takes the error before it has been made an object. Caught and raised again
it is one, and goes to ``sys.excepthook`` as it should.
"""

import functools
import sys
from collections.abc import Callable
from types import FunctionType
from typing import Any

from PySide6.QtCore import QObject


def guard_overrides() -> None:
    """Guard the overrides of every class of Qt that is defined from now on.

    Does nothing where the interpreter makes errors into objects at once (CPython 3.12 and later).
    """
    if sys.version_info < (3, 12):
        # The stubs do not know that classes of Qt take new attributes.
        vars_of_qt: Any = QObject
        vars_of_qt.__init_subclass__ = classmethod(_guard_class)


def _guard_class(cls: type, **_: object) -> None:
    for name, method in list(vars(cls).items()):
        if isinstance(method, FunctionType) and _is_of_qt(cls, name):
            setattr(cls, name, _guarded(method))


def _is_of_qt(cls: type, name: str) -> bool:
    """Whether a base that is not written in Python has this method."""
    return any(
        name in vars(base) and not isinstance(vars(base)[name], FunctionType)
        for base in cls.__mro__[1:]
    )


def _guarded(method: Callable[..., object]) -> Callable[..., object]:
    @functools.wraps(method)
    def call(*args: object, **kwargs: object) -> object:
        try:
            return method(*args, **kwargs)
        except BaseException:
            # Being caught is what makes it an object.
            raise

    return call
