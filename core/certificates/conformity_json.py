"""A statement of conformity as JSON and back."""

from core.certificates.limits import Conformity, Judged
from core.procedures.conformity import Verdict
from core.records.json_fields import Fields, Json, number_to_json


def conformity_to_json(conformity: Conformity | None) -> Json:
    """The statement as a JSON object; null where none was made."""
    if conformity is None:
        return None
    return {
        "rule": conformity.rule,
        "verdict": conformity.verdict.value,
        "judged": [_judged_to_json(one) for one in conformity.judged],
    }


def conformity_of_json(holder: Fields) -> Conformity | None:
    """The statement in the member ``conformity`` of an object.

    Raises
    ------
    FormatError
        It is missing or is not what it should be.
    """
    if holder.data.get("conformity", 0) is None:
        return None
    found = holder.object("conformity")
    return Conformity(
        found.text("rule"),
        tuple(
            Judged(
                one.text("channel"),
                one.text("symbol"),
                one.text("unit"),
                one.number("deviation"),
                one.number("expanded"),
                one.number("limit"),
                _verdict(one),
            )
            for one in found.objects("judged")
        ),
        _verdict(found),
    )


def _judged_to_json(one: Judged) -> Json:
    return {
        "channel": one.channel,
        "symbol": one.symbol,
        "unit": one.unit,
        "deviation": number_to_json(one.deviation),
        "expanded": number_to_json(one.expanded),
        "limit": number_to_json(one.limit),
        "verdict": one.verdict.value,
    }


def _verdict(found: Fields) -> Verdict:
    word = found.text("verdict")
    try:
        return Verdict(word)
    except ValueError:
        raise found.wrong("verdict", "pass, fail or undecided", word) from None
