"""Words behind numbers, which Ukrainian and Russian say in three ways.

A translation holds the three in brackets, ``{rows} [рядок|рядки|рядків]``: for 1 and 21, for 2 to
4 and 22 and for fractions, for 5 to 20 and 0.
"""

import re

FORMS = re.compile(r"\[([^\[\]|]+)\|([^\[\]|]+)\|([^\[\]|]+)\]")
_NUMBER = re.compile(r"\d[\d\N{NARROW NO-BREAK SPACE}\N{NO-BREAK SPACE} ]*(?:[.,]\d+)?")


def inflected(text: str) -> str:
    """Return a text whose bracketed words follow the number before them."""
    if "|" not in text:
        return text

    def chosen(match: re.Match[str]) -> str:
        numbers = _NUMBER.findall(text, 0, match.start())
        return match.group(_form(numbers[-1]) if numbers else 3)

    return FORMS.sub(chosen, text)


def _form(number: str) -> int:
    """1, 2 or 3, by the rule of Unicode's CLDR for both languages."""
    digits = re.sub(r"\s", "", number)
    if not digits.isdecimal():
        return 2
    last, tens = int(digits[-1]), int(digits[-2:])
    if last == 1 and tens != 11:
        return 1
    return 2 if last in (2, 3, 4) and tens not in (12, 13, 14) else 3
