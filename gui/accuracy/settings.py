"""What the operator sets for an accuracy check."""

from dataclasses import dataclass, replace

from core.procedures.accuracy import Limit
from core.procedures.conformity import RULES
from core.records.session.start import Scalars, SessionStart
from core.samples.run import Conditions
from gui.accuracy.checking import NEAREST
from gui.measuring.settings import MeasuringSettings, common_of, common_of_start, stated_or
from gui.settings import Section, number_of, text_of


@dataclass(frozen=True, slots=True)
class AccuracySettings(MeasuringSettings):
    """Settings of the test.

    Parameters
    ----------
    head_u_arcsec : standard uncertainty of one setting of the dividing head
    limit_deg : largest allowed error; 0 for no verdict
    rule : key of `RULES`
    calibration : that the raw codes are judged by: ``"nearest"``, ``"none"``, or a file
    """

    plan_id: str = "pitch_accuracy"
    head_u_arcsec: float = 10.0
    limit_deg: float = 0.1
    rule: str = "guarded"
    calibration: str = NEAREST

    @property
    def limit(self) -> Limit | None:
        """The limit with its rule; None where no verdict is wanted."""
        return Limit(self.limit_deg, RULES[self.rule]) if self.limit_deg > 0 else None

    def conditions(self) -> Conditions:
        """What the laboratory states."""
        common = MeasuringSettings.conditions(self)
        return replace(common, head_u_arcsec=self.head_u_arcsec)

    def extra(self) -> Scalars:
        """What a session keeps beside the conditions."""
        common = MeasuringSettings.extra(self)
        return {**common, "limit_deg": self.limit_deg, "rule": self.rule}


def settings_of(section: Section) -> AccuracySettings:
    """The settings in a section; what is not there or impossible takes its default."""
    standard = AccuracySettings()
    rule = text_of(section, "rule", standard.rule)
    return AccuracySettings(
        **common_of(section, standard),
        head_u_arcsec=number_of(section, "head_u_arcsec", standard.head_u_arcsec, 0, 3600),
        limit_deg=number_of(section, "limit_deg", standard.limit_deg, 0, 90),
        rule=rule if rule in RULES else standard.rule,
        calibration=text_of(section, "calibration", standard.calibration),
    )


def settings_of_session(start: SessionStart, screen: AccuracySettings) -> AccuracySettings:
    """The settings that a session was begun with; what it does not state stays as it is."""
    rule = text_of(start.settings, "rule", screen.rule)
    return AccuracySettings(
        **common_of_start(start, screen),
        head_u_arcsec=stated_or(start.conditions.head_u_arcsec, screen.head_u_arcsec),
        limit_deg=number_of(start.settings, "limit_deg", screen.limit_deg, 0, 90),
        rule=rule if rule in RULES else screen.rule,
        calibration=screen.calibration,
    )
