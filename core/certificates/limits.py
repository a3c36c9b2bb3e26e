"""Parameters of a calibration against limits: the statement of conformity (7.8.6)."""

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


def judge_calibration(
    calibration: Calibration, limits: tuple[ParameterLimit, ...], rule: str
) -> Conformity | None:
    """Judge a calibration; None where no limit concerns it.

    Parameters
    ----------
    limits : nominal values and limits
    rule : key of `core.procedures.conformity.RULES`
    """
    judged: list[Judged] = []
    for channel, fit in zip(calibration.channels, calibration.fits, strict=True):
        expanded = fit.expanded(_LEVEL)
        for limit in limits:
            if limit.channel not in ("", channel) or limit.parameter not in fit.names:
                continue
            place = fit.index(limit.parameter)
            deviation = float(fit.values[place]) - limit.nominal
            half = float(expanded[place])
            judged.append(
                Judged(
                    channel,
                    fit.parameters[place].symbol,
                    fit.parameters[place].unit,
                    deviation,
                    half,
                    limit.limit,
                    judge(deviation, half, limit.limit, RULES[rule]),
                )
            )
    if not judged:
        return None
    return Conformity(RULES[rule].text, tuple(judged), worst(tuple(one.verdict for one in judged)))
