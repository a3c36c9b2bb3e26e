"""Everything that the page Gyrocompass shows."""

import math
from dataclasses import dataclass

from core.arrays import FloatArray
from core.procedures.gyrocompass import Gyrocompass
from core.procedures.north_seeking import AveragingAdvice
from core.samples.run import Run
from gui.widgets.analysis_page import AnalysisState

Noise = tuple[float, float, float]
"""N, B, K in deg/sqrt(s), deg/s, deg/s/sqrt(s); N of 0 where the noise is not known."""


@dataclass(frozen=True, slots=True)
class CompassChoices:
    """What the operator decides.

    Parameters
    ----------
    channel : name of the output; empty for the first
    latitude_deg : negative in the south; NaN where it is not stated
    scale_factor : output for 1 deg/s; 0 where the output is a rate
    u_tilt_arcmin : standard uncertainty of one reading of the tilt
    ramp : estimate a steady change of the drift along
    headings : of the readings to plan for, evenly spaced; a run brings its own
    average_s, pause_s : averaging time at each heading, time to turn and settle
    target_deg : standard uncertainty wanted; 0 for none
    noise, noise_source : of the gyro, and where it was taken from
    """

    channel: str = ""
    latitude_deg: float = 50.45
    scale_factor: float = 0.0
    u_tilt_arcmin: float = 0.0
    ramp: bool = False
    headings: int = 4
    average_s: float = 10.0
    pause_s: float = 5.0
    target_deg: float = 0.1
    noise: Noise = (0.0, 0.0, 0.0)
    noise_source: str = ""

    @property
    def rows(self) -> tuple[float, ...]:
        """Headings to plan for, deg."""
        return tuple(360.0 * place / self.headings for place in range(self.headings))


@dataclass(frozen=True, slots=True, eq=False)
class Advice:
    """How long to average.

    Parameters
    ----------
    headings_deg : readings of the base that it is for
    now_deg : u of the heading at the averaging time that was chosen
    curve : against the averaging time
    hours, kept_deg : how long the heading is kept afterwards, and its u then
    """

    headings_deg: tuple[float, ...]
    now_deg: float
    curve: AveragingAdvice
    hours: tuple[float, ...]
    kept_deg: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """What a job brings.

    Parameters
    ----------
    choices : for which it was computed
    run, name : the readings and their file; None while none was loaded
    compass : heading and drift; None without a run, or where `why` tells why not
    advice : None where the noise is not known, or where `why_no_advice` tells why not
    """

    choices: CompassChoices
    run: Run | None = None
    name: str = ""
    compass: Gyrocompass | None = None
    why: str = ""
    advice: Advice | None = None
    why_no_advice: str = ""


@dataclass(frozen=True, slots=True)
class RoseState:
    """The compass.

    Parameters
    ----------
    heading_deg, low_deg, high_deg : of the input axis at reading 0, with its 95 % interval; NaN
        while nothing was measured
    readings_deg : azimuths of the input axis at each reading, or readings of a plan
    """

    heading_deg: float = math.nan
    low_deg: float = math.nan
    high_deg: float = math.nan
    readings_deg: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class CompassState:
    """The page.

    Parameters
    ----------
    choices : what is decided
    channels : names that can be chosen; empty while there is no run
    frame : hint, findings, actions
    rose : the compass
    advice : the curve below; None while there is none
    """

    choices: CompassChoices
    channels: tuple[str, ...]
    frame: AnalysisState
    rose: RoseState
    advice: Advice | None
