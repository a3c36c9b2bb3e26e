"""Where an axis of dates has its ticks, and what stands there; no Qt."""

from datetime import datetime, timedelta

_DAY = 86400.0
_MONTHS = (1, 3, 6, 12, 24, 60, 120, 240, 600)
_SECONDS = (60, 300, 900, 3600, 10800, 21600, 43200, 86400, 2 * 86400, 7 * 86400)


def date_ticks(low: float, high: float, most: int = 7) -> list[tuple[float, str]]:
    """Return moments between two, in seconds since the epoch, and their words in local time.

    Parameters
    ----------
    low, high : ends of the axis, seconds since the epoch
    most : no more ticks than these
    """
    if not high > low:
        return []
    for step in _SECONDS:
        if (high - low) / step <= most:
            return _by_seconds(low, high, step)
    for months in _MONTHS:
        if (high - low) / (months * 30.5 * _DAY) <= most:
            return _by_months(low, high, months)
    return _by_months(low, high, 12 * round((high - low) / (365.25 * _DAY) / most + 1))


def _by_seconds(low: float, high: float, step: int) -> list[tuple[float, str]]:
    words = "%Y-%m-%d" if step >= _DAY else "%m-%d %H:%M"
    start = datetime.fromtimestamp(low).astimezone()
    at = start.replace(hour=0, minute=0, second=0, microsecond=0)
    found: list[tuple[float, str]] = []
    while at.timestamp() <= high:
        if at.timestamp() >= low:
            found.append((at.timestamp(), at.strftime(words)))
        at = (at + timedelta(seconds=step)).astimezone()
    return found


def _by_months(low: float, high: float, step: int) -> list[tuple[float, str]]:
    words = "%Y" if step % 12 == 0 else "%Y-%m"
    start = datetime.fromtimestamp(low)
    month = (start.year * 12 + start.month - 1) // step * step
    found: list[tuple[float, str]] = []
    while True:
        at = datetime(month // 12, month % 12 + 1, 1)
        month += step
        if at.timestamp() > high:
            return found
        if at.timestamp() >= low:
            found.append((at.timestamp(), at.strftime(words)))
