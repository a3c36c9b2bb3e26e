"""Everything that the page Fourier tumble shows."""

from dataclasses import dataclass

from core.arrays import FloatArray
from gui.widgets.analysis_page import AnalysisState


@dataclass(frozen=True, slots=True)
class TumbleChoices:
    """What the operator decides.

    Parameters
    ----------
    channel : name of the output; empty for the first that the turn determines
    harmonics : 2 or 3
    remove_drift : fit a steady drift along
    gravity_projection : signs of k_x and k_y as in the source
    g_mps2, u_g_mps2 : local gravity and its standard uncertainty
    head_u_arcsec : standard uncertainty of one setting of the head
    """

    channel: str = ""
    harmonics: int = 2
    remove_drift: bool = False
    gravity_projection: bool = False
    g_mps2: float = 9.8106
    u_g_mps2: float = 0.0005
    head_u_arcsec: float = 10.0


@dataclass(frozen=True, slots=True, eq=False)
class PolarSeries:
    """Residuals of one realisation.

    Parameters
    ----------
    name : in the legend
    alpha_deg, residual, u95 : (n,) elevation, residual, half width of its interval; `u95` is NaN
        where it is not known
    """

    name: str
    alpha_deg: FloatArray
    residual: FloatArray
    u95: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class PolarState:
    """Residuals round the turn.

    Parameters
    ----------
    series : one a realisation
    unit : of the residuals
    """

    series: tuple[PolarSeries, ...]
    unit: str


@dataclass(frozen=True, slots=True)
class HarmonicBar:
    """One coefficient.

    Parameters
    ----------
    label : ``"sin 2α"``
    value : of the coefficient
    threshold : size that noise alone exceeds in 1 % of cases; NaN where it is not known
    """

    label: str
    value: float
    threshold: float

    @property
    def seen(self) -> bool:
        """Whether it is more than noise."""
        return not abs(self.value) <= self.threshold


@dataclass(frozen=True, slots=True)
class BarsState:
    """The coefficients of (14), without the constant.

    Parameters
    ----------
    bars : in their order
    unit : of the values
    """

    bars: tuple[HarmonicBar, ...]
    unit: str


@dataclass(frozen=True, slots=True, eq=False)
class TumbleState:
    """The page.

    Parameters
    ----------
    choices : what is decided
    channels : names that can be chosen; empty while there is no run
    source : what was read, in words
    frame : hint, findings, actions
    polar, bars : the pictures; None while there is no result
    """

    choices: TumbleChoices
    channels: tuple[str, ...]
    source: str
    frame: AnalysisState
    polar: PolarState | None
    bars: BarsState | None
