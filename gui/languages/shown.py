"""Words of states, notes and errors in the language of the window.

Below the views everything is said in English, with its numbers in place. A view hands such a text
to `shown`, which finds the template it was made from, translates that, and fills the gaps again;
what a gap holds is translated in the same way. What no template explains stays as it is. Numbers
get the decimal mark of the language; units stay.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

from gui.languages.plural import inflected
from gui.languages.ts_file import Message

SHOWN = "Shown"
"""The context of the texts that are translated here."""

_GAP = re.compile(r"\{\w+\}")
_WIDE, _LONG = 12, 20
"""Letters outside the gaps from which these may hold joined parts, and whole sentences."""
_NARROW_GAP = r"((?:(?![,;:] | {2})[^\n]){0,60}?)"
_WIDE_GAP = r"((?:(?!\. [A-Z]| {2}).)*?)"
_LONG_GAP = r"(.*?)"
_WEAK = 4
"""With fewer letters, "{low} to {high}", gaps hold a number with its unit or one word."""
_WEAK_GAP = r"(\S*\d\S*(?: \S{1,6})?|[^\s,;:]+)"
_DEPTH = 4
_LABEL = 40
"""Longest name before a colon that a sentence is about."""
_TAILS = (", ", "; ", " ")
_JOINTS = tuple(
    re.compile(joint)
    for joint in (
        r"(\n+)",
        r"((?<=[.!?…]) +)",
        r"(   +)",
        r"(; )",
        r"( {2})",
        r"(: )",
        r"(, )",
        r"( \(|\)$)",
        r"( )(?=[+−-]?\d)",
    )
)
"""Where texts are joined, the widest first."""
_POINT = re.compile(r"(?<![\w.,/\\:#])(\d+)\.(\d+)(?![\d.]*\.\d|[/\\_]|[A-Za-df-z])")
"""A point within a number; not in a file's name, an address or a version of three parts."""


@dataclass(frozen=True, slots=True)
class _Template:
    """English words with gaps, and what they are in the language.

    Parameters
    ----------
    source, translation : as in the file of the language
    clue : the longest stretch between gaps; a text without it was not made from this template
    weight : letters outside the gaps
    """

    source: str
    translation: str
    clue: str
    weight: int


class Book:
    """What one language makes of English texts.

    Parameters
    ----------
    messages : the translations; those of the context `SHOWN` are used
    decimal : the decimal mark, "." or ","
    """

    def __init__(self, messages: Iterable[Message], decimal: str) -> None:
        self._decimal = decimal
        self._exact: dict[str, str] = {}
        self._originals: dict[str, set[str]] = {}
        self._beginnings: list[tuple[str, str]] = []
        templates: list[_Template] = []
        for message in messages:
            self._keep_original(message)
            if message.context != SHOWN or not message.translation:
                continue
            self._exact[message.source] = message.translation
            for source, words in _forms(message):
                parts = _GAP.split(source)
                weight = sum(len(part.strip()) for part in parts)
                templates.append(_Template(source, words, max(parts, key=len), weight))
        self._templates = sorted(templates, key=lambda one: -one.weight)
        # Bound here: a method cached by its class would keep every book alive.
        self.translate = lru_cache(maxsize=8192)(self._translate)
        self._pattern = lru_cache(maxsize=None)(_pattern)

    def _keep_original(self, message: Message) -> None:
        beginning, gap, _ = message.translation.partition("{")
        if not gap:
            self._originals.setdefault(message.translation, set()).add(message.source)
        elif beginning.strip():
            self._beginnings.append((beginning, message.source))

    def originals(self, words: str) -> set[str]:
        """Return the English texts of which these words are, or can be, the translation."""
        found = set(self._originals.get(words, ()))
        return found | {source for start, source in self._beginnings if words.startswith(start)}

    def number(self, text: str) -> str:
        """Return a text with the decimal mark of the language in its numbers."""
        return text if self._decimal == "." else _POINT.sub(rf"\1{self._decimal}\2", text)

    def _translate(self, text: str, depth: int = 0) -> str:
        """Return a text in the language; see `shown`."""
        core = text.strip()
        if not core or depth > _DEPTH:
            return text
        found = self._whole(core, depth)
        if found is None:
            found = self._labelled(core, depth)
        if found is None:
            found = self._in_parts(core, depth)
        if found is None:
            found = self.number(core)
        start = len(text) - len(text.lstrip())
        return text[:start] + found + text[start + len(core) :]

    def _whole(self, text: str, depth: int) -> str | None:
        """Return what one entry makes of the text, also where it was made a sentence of."""
        stopped = ((text, ""), (text[:-1], text[-1])) if text[-1] in ".:" else ((text, ""),)
        for told, stop in stopped:
            if (words := self._exact.get(told)) is not None:
                return words + stop
            if (words := self._exact.get(_small(told))) is not None:
                return _large(words) + stop
        for told, stop in stopped:
            if (words := self._filled(told, depth)) is not None:
                return words + stop
            if (words := self._filled(_small(told), depth)) is not None:
                return _large(words) + stop
        return None

    def _filled(self, text: str, depth: int) -> str | None:
        """Return the translation of the template that the text was made from."""
        for template in self._templates:
            if template.clue not in text:
                continue
            match = self._pattern(template).fullmatch(text)
            if match is not None:
                names = _GAP.findall(template.source)
                values = [self.translate(value, depth + 1) for value in match.groups()]
                told = dict(zip(names, values, strict=True))
                parts = re.split(r"(\{\w+\})", template.translation)
                return inflected("".join(told.get(part, part) for part in parts))
        return None

    def _labelled(self, text: str, depth: int) -> str | None:
        """Return a sentence behind the name of what it is about: ``"gyro_x: ..."``."""
        label, colon, rest = text.partition(": ")
        if not colon or len(label) > _LABEL:
            return None
        words = self._whole(rest, depth)
        return None if words is None else f"{self.translate(label, depth + 1)}: {words}"

    def _in_parts(self, text: str, depth: int) -> str | None:
        """Return the text with those of its parts translated that are known."""
        for joint in _JOINTS:
            parts = joint.split(text)
            if len(parts) > 1:
                told = [
                    part if place % 2 else self.translate(part, depth + 1)
                    for place, part in enumerate(parts)
                ]
                if told != parts:
                    return "".join(told)
        return None


class _Voice:
    """The book that the window reads from; None for English."""

    book: Book | None = None


def speak(book: Book | None) -> None:
    """Take another language; None for English."""
    _Voice.book = book


def shown(text: str) -> str:
    """Return an English text in the language of the window, with its decimal mark.

    A text that is in that language already comes back unchanged.
    """
    book = _Voice.book
    return text if book is None else book.translate(text)


def originals(words: str) -> set[str]:
    """Return the English texts that words of the window can be a translation of."""
    book = _Voice.book
    return set() if book is None else book.originals(words)


def shown_number(text: str) -> str:
    """Return a number as text with the decimal mark of the language."""
    book = _Voice.book
    return text if book is None else book.number(text)


def _small(text: str) -> str:
    return text[:1].lower() + text[1:]


def _large(text: str) -> str:
    return text[:1].upper() + text[1:]


def _forms(message: Message) -> Iterable[tuple[str, str]]:
    """The templates of an entry; what is put behind another text has a gap for that one."""
    if _GAP.search(message.source):
        yield message.source, message.translation
    if message.source.startswith(_TAILS):
        yield f"{{before}}{message.source}", f"{{before}}{message.translation}"


_GAPS = ((_LONG, _LONG_GAP), (_WIDE, _WIDE_GAP), (_WEAK, _NARROW_GAP), (0, _WEAK_GAP))


def _pattern(template: _Template) -> re.Pattern[str]:
    gap = next(gap for weight, gap in _GAPS if template.weight >= weight)
    parts = [re.escape(part) for part in _GAP.split(template.source)]
    return re.compile(gap.join(parts), re.DOTALL)
