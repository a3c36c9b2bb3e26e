"""All effects by identifier."""

from core.model.catalogue.common import Bias, CrossAxis, ScaleFactor
from core.model.catalogue.gyro import AccelerationSensitiveDrift
from core.model.effect import Effect

CATALOGUE: dict[str, Effect] = {
    effect.id: effect
    for effect in (Bias(), ScaleFactor(), CrossAxis(), AccelerationSensitiveDrift())
}
"""The one catalogue: simulator, fit, finder and reports look effects up here."""
