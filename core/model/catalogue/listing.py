"""All effects by identifier."""

from core.model.catalogue.common import Bias, CrossAxis, ScaleFactor
from core.model.catalogue.faults import (
    Outlier,
    ShortAccumulation,
    StuckReading,
    WrongAngle,
    WrongStop,
)
from core.model.catalogue.gyro import AccelerationSensitiveDrift
from core.model.catalogue.gyro_static import EarthRate, GSquared, MagneticSensitivity
from core.model.catalogue.history import Hysteresis, SettlingLag
from core.model.catalogue.nonlinear import (
    BiasAsymmetry,
    CrossAxisSquare,
    CrossCoupling,
    DeadBand,
    OddQuadratic,
    Saturation,
    ScaleFactorAsymmetry,
    SecondOrder,
    ThirdOrder,
)
from core.model.catalogue.record import (
    AmplitudeError,
    DampingAnisotropy,
    PhaseError,
    QuadratureLeakage,
    ResonatorFrequency,
    Telegraph,
    TemperatureRate,
    ThermalHysteresis,
    ThermalLag,
)
from core.model.catalogue.record_facts import (
    AngleRandomWalk,
    BiasInstability,
    Clipping,
    Dropouts,
    Markov,
    MissingCodes,
    Quantization,
    RateRandomWalk,
    StaleTemperature,
    VarianceBurst,
)
from core.model.catalogue.relabelling import (
    ChannelsPermuted,
    MountReversed,
    PositionsSwapped,
    RateSignReversed,
)
from core.model.catalogue.rig import (
    HeadEccentricity,
    HeadEllipticity,
    HeadPeriodicError,
    MountingAngle,
    RemountBias,
    ShaftTilt,
)
from core.model.catalogue.table import AmplitudeScaleFactor, TableSlip, Wobble, WrongRate
from core.model.catalogue.timeline import (
    BiasDrift,
    BiasJump,
    BiasTemperature,
    Pickup,
    RunBias,
    RunScaleFactor,
    ScaleFactorTemperature,
    WarmUp,
)
from core.model.effect import Effect

CATALOGUE: dict[str, Effect] = {
    effect.id: effect
    for effect in (
        *(Bias(), ScaleFactor(), CrossAxis(), AccelerationSensitiveDrift()),
        *(SecondOrder(), ThirdOrder(), OddQuadratic(), CrossAxisSquare(), CrossCoupling()),
        *(ScaleFactorAsymmetry(), BiasAsymmetry(), DeadBand(), Saturation()),
        *(Hysteresis(), SettlingLag()),
        *(MountingAngle(), ShaftTilt(), RemountBias()),
        *(HeadEccentricity(), HeadEllipticity(), HeadPeriodicError()),
        *(BiasDrift(), BiasTemperature(), ScaleFactorTemperature(), WarmUp(), BiasJump()),
        *(RunBias(), RunScaleFactor(), Pickup()),
        *(TableSlip(), WrongRate(), Wobble(), AmplitudeScaleFactor()),
        *(GSquared(), MagneticSensitivity(), EarthRate()),
        *(Outlier(), WrongAngle(), WrongStop(), ShortAccumulation(), StuckReading()),
        *(TemperatureRate(), ThermalLag(), ThermalHysteresis(), Telegraph()),
        *(QuadratureLeakage(), PhaseError(), DampingAnisotropy()),
        *(ResonatorFrequency(), AmplitudeError()),
        *(Quantization(), AngleRandomWalk(), BiasInstability(), RateRandomWalk(), Markov()),
        *(Dropouts(), MissingCodes(), StaleTemperature(), VarianceBurst(), Clipping()),
        *(PositionsSwapped(), MountReversed(), RateSignReversed(), ChannelsPermuted()),
    )
}
"""The one catalogue: simulator, fit, finder and reports look effects up here."""
