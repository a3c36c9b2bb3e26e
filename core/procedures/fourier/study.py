"""Everything that a tumble's run tells: every mount, and the split or the flip that follows."""

from dataclasses import dataclass

import numpy as np

from core.errors import FitError
from core.procedures.fourier.flip import Flip, separate
from core.procedures.fourier.pairs import TurnPair, turn_pairs
from core.procedures.fourier.split import Split, split
from core.procedures.fourier.tumble import TumbleResult, calibrate_tumble
from core.samples.run import Conditions, Run

_BOTH_MOUNTS = 2


@dataclass(frozen=True, slots=True)
class TumbleRequest:
    """What the operator decides.

    Parameters
    ----------
    channel : which output; None for the first that a turn of this run determines
    harmonics : 2 or 3
    remove_drift : fit a steady drift along with the series
    gravity_projection : signs of k_x and k_y as in the source
    """

    channel: int | None = 0
    harmonics: int = 2
    remove_drift: bool = False
    gravity_projection: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class TumbleStudy:
    """What was found.

    Parameters
    ----------
    mounts, tumbles : one a mount, in the order of measuring
    channel : place of the output
    rows : rows of the run that each tumble used
    split : (18), of a single mount whose fit has an uncertainty
    flip : fixture and sensor apart, where the run holds two mounts
    pairs : test turns; empty where no axis stood up as well as down
    """

    mounts: tuple[str, ...]
    tumbles: tuple[TumbleResult, ...]
    channel: int
    rows: tuple[tuple[int, ...], ...]
    split: Split | None
    flip: Flip | None
    pairs: tuple[TurnPair, ...]


def study_tumble(run: Run, conditions: Conditions, request: TumbleRequest) -> TumbleStudy:
    """Fit every mount of a run; of two, separate fixture and sensor.

    Raises
    ------
    FitError
        A mount cannot be fitted, see `calibrate_tumble`; or two were not turned over.
    """
    mounts = tuple(dict.fromkeys(run.mount))
    rows = tuple(tuple(i for i, own in enumerate(run.mount) if own == mount) for mount in mounts)
    channel = request.channel
    if channel is None:
        channel = _first_that_turns(run.rows(rows[0]), conditions)
    tumbles = tuple(
        calibrate_tumble(
            run.rows(chosen),
            conditions,
            channel=channel,
            harmonics=request.harmonics,
            remove_drift=request.remove_drift,
        )
        for chosen in rows
    )
    flip = separate(tumbles[0], tumbles[1]) if len(tumbles) == _BOTH_MOUNTS else None
    known = bool(np.all(np.isfinite(tumbles[0].fit.covariance)))
    parts = (
        split(tumbles[0], gravity_projection=request.gravity_projection)
        if flip is None and known
        else None
    )
    return TumbleStudy(
        mounts, tumbles, channel, rows, parts, flip, _pairs(run, conditions, channel)
    )


def _first_that_turns(run: Run, conditions: Conditions) -> int:
    """The first output whose axis does not lie along the shaft; 0 if all refuse."""
    for channel in range(len(run.channels)):
        try:
            calibrate_tumble(run, conditions, channel=channel)
        except FitError:
            # Another output may lie in the plane; if none does, the first one tells why.
            continue
        return channel
    return 0


def _pairs(run: Run, conditions: Conditions, channel: int) -> tuple[TurnPair, ...]:
    try:
        return turn_pairs(run, conditions, channel=channel)
    except FitError:
        # A tumble need not pass through the vertical; then there is no test turn to show.
        return ()
