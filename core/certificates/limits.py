"""Parameters of a calibration against limits: the statement of conformity (7.8.6)."""

from collections.abc import Sequence
from dataclasses import dataclass

from core.procedures.calibration import Calibration
from core.procedures.conformity import RULES, Verdict, judge, worst

_LEVEL = 0.95


@dataclass(frozen=True, slots=True)
class ParameterLimit:
    """How far a parameter may lie from its nominal value.

    Parameters
    ----------
    parameter : name, e.g. ``"scale_factor"``
    channel : name of the sensor; empty for all that have the parameter
    nominal, limit : value and largest allowed deviation, in the unit of the parameter
    """

    parameter: str
    channel: str
    nominal: float
    limit: float


@dataclass(frozen=True, slots=True)
class Stated:
    """One number of the results that a limit can be set for.

    Parameters
    ----------
    channel : name of the sensor
    parameter, symbol, unit : which number
    value, expanded : with its expanded uncertainty (95 %)
    """

    channel: str
    parameter: str
    symbol: str
    unit: str
    value: float
    expanded: float


@dataclass(frozen=True, slots=True)
class Judged:
    """One parameter against its limit.

    Parameters
    ----------
    channel, symbol, unit : which parameter
    deviation, expanded : from the nominal value, with its expanded uncertainty (95 %)
    limit : largest allowed deviation
    verdict : by the rule
    """

    channel: str
    symbol: str
    unit: str
    deviation: float
    expanded: float
    limit: float
    verdict: Verdict


@dataclass(frozen=True, slots=True)
class Conformity:
    """The statement of conformity.

    Parameters
    ----------
    rule : text of the decision rule
    judged : parameter by parameter
    verdict : of all
    """

    rule: str
    judged: tuple[Judged, ...]
    verdict: Verdict


def stated_of(calibration: Calibration) -> tuple[Stated, ...]:
    """The parameters of a calibration, sensor by sensor."""
    return tuple(
        Stated(channel, parameter.name, parameter.symbol, parameter.unit, float(value), float(half))
        for channel, fit in zip(calibration.channels, calibration.fits, strict=True)
        for parameter, value, half in zip(
            fit.parameters, fit.values, fit.expanded(_LEVEL), strict=True
        )
    )


def judge_stated(
    stated: Sequence[Stated], limits: Sequence[ParameterLimit], rule: str
) -> Conformity | None:
    """Judge results; None where no limit concerns them.

    Parameters
    ----------
    stated : the numbers
    limits : nominal values and limits
    rule : key of `core.procedures.conformity.RULES`
    """
    judged = tuple(
        _judged(one, limit, rule)
        for channel in dict.fromkeys(one.channel for one in stated)
        for limit in limits
        if limit.channel in ("", channel)
        for one in stated
        if (one.channel, one.parameter) == (channel, limit.parameter)
    )
    if not judged:
        return None
    return Conformity(RULES[rule].text, judged, worst(tuple(one.verdict for one in judged)))


def _judged(one: Stated, limit: ParameterLimit, rule: str) -> Judged:
    deviation = one.value - limit.nominal
    return Judged(
        one.channel,
        one.symbol,
        one.unit,
        deviation,
        one.expanded,
        limit.limit,
        judge(deviation, one.expanded, limit.limit, RULES[rule]),
    )
