"""What the operator sets for a test on the dividing head."""

from dataclasses import dataclass, field, replace

from core.records.session.start import Scalars, SessionStart
from core.samples.run import Conditions
from gui.measuring.settings import MeasuringSettings, common_of, common_of_start, stated_or
from gui.settings import Section, number_of, text_of

TILTERS = ("None", "Auto", "Manual")


@dataclass(frozen=True, slots=True)
class Tilter:
    """The motorised tilting fixture.

    Parameters
    ----------
    mode : one of `TILTERS`
    number, position : Auto: which fixture, which of its positions
    psi_deg, theta_deg, gamma_deg : Manual: its angles
    """

    mode: str = "None"
    number: int = 1
    position: int = 1
    psi_deg: float = 0.0
    theta_deg: float = 0.0
    gamma_deg: float = 0.0

    @property
    def angles_deg(self) -> tuple[float, float, float]:
        """Angles between plate and case that the program knows."""
        if self.mode != "Manual":
            return 0.0, 0.0, 0.0
        return self.psi_deg, self.theta_deg, self.gamma_deg


@dataclass(frozen=True, slots=True)
class HeadSettings(MeasuringSettings):
    """Settings of the test.

    Parameters
    ----------
    head_u_arcsec : standard uncertainty of one setting of the dividing head
    tilter : the tilting fixture
    """

    plan_id: str = "pointer_8"
    head_u_arcsec: float = 10.0
    tilter: Tilter = field(default_factory=Tilter)

    def conditions(self) -> Conditions:
        """What the laboratory states."""
        common = MeasuringSettings.conditions(self)
        return replace(common, head_u_arcsec=self.head_u_arcsec)

    def tilter_scalars(self) -> Scalars:
        """What a session keeps of the tilting fixture."""
        tilter = self.tilter
        return {
            "mode": tilter.mode,
            "number": float(tilter.number),
            "position": float(tilter.position),
            "psi_deg": tilter.psi_deg,
            "theta_deg": tilter.theta_deg,
            "gamma_deg": tilter.gamma_deg,
        }


def settings_of(section: Section) -> HeadSettings:
    """The settings in a section; what is not there or impossible takes its default."""
    standard = HeadSettings()
    return HeadSettings(
        **common_of(section, standard),
        head_u_arcsec=number_of(section, "head_u_arcsec", standard.head_u_arcsec, 0, 3600),
    )


def settings_of_session(start: SessionStart, screen: HeadSettings) -> HeadSettings:
    """The settings that a session was begun with; what it does not state stays as it is."""
    return HeadSettings(
        **common_of_start(start, screen),
        head_u_arcsec=stated_or(start.conditions.head_u_arcsec, screen.head_u_arcsec),
        tilter=tilter_of(start.tilter),
    )


def tilter_of(section: Section, prefix: str = "") -> Tilter:
    """The tilter that a session states; what is not there or impossible takes its default."""
    mode = text_of(section, f"{prefix}mode", "None")
    psi, theta, gamma = (
        number_of(section, f"{prefix}{name}_deg", 0, -360, 360)
        for name in ("psi", "theta", "gamma")
    )
    return Tilter(
        mode if mode in TILTERS else "None",
        round(number_of(section, f"{prefix}number", 1, 1, 99)),
        round(number_of(section, f"{prefix}position", 1, 1, 99)),
        psi,
        theta,
        gamma,
    )
