"""What a record shows beyond its mean level: noise terms, and faults of the data themselves.

These add no columns to a model. A noise term says how the scatter goes with frequency, a fault of
the data is a fact that is counted; `core.discrepancy` states their sizes.
"""

import numpy as np

from core.arrays import FloatArray
from core.model.catalogue.terms import RECORD
from core.model.effect import Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus


class _WithoutColumns(Effect):
    """Nothing that could be fitted to the rows."""

    tests = RECORD

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """None."""
        return ()

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """None."""
        return np.zeros((len(stimulus), 0))


class _Noise(_WithoutColumns):
    kind = Kind.NOISE
    remedy = "belongs to the sensor; state it in the noise model and average accordingly"


class Quantization(_Noise):
    """Quantisation noise Q (IEEE 952)."""

    id = "quantization"
    name = "Quantisation noise"
    plain = "the increments of angle are rounded coarsely"
    equation = "S(f) = (2 pi f)^2 Q^2 dt"
    seen_as = "slope -1 of the Allan deviation; the spectrum rises with f^2"
    confused_with = ("angle_random_walk",)


class AngleRandomWalk(_Noise):
    """Angle (velocity) random walk N (IEEE 952)."""

    id = "angle_random_walk"
    name = "Angle random walk"
    plain = "white noise of the rate"
    equation = "S(f) = N^2"
    seen_as = "slope -1/2 of the Allan deviation; a flat spectrum"
    confused_with = ("quantization",)


class BiasInstability(_Noise):
    """Bias instability B (IEEE 952)."""

    id = "bias_instability"
    name = "Bias instability"
    plain = "flicker noise: the mean never settles, however long it is taken"
    equation = "S(f) = B^2 / (2 pi f)"
    seen_as = "a floor of the Allan deviation; the spectrum rises with 1/f"
    confused_with = ("rate_random_walk", "markov")


class RateRandomWalk(_Noise):
    """Rate random walk K (IEEE 952)."""

    id = "rate_random_walk"
    name = "Rate random walk"
    plain = "the bias walks at random"
    equation = "S(f) = (K / 2 pi f)^2"
    seen_as = "slope +1/2 of the Allan deviation; the spectrum rises with 1/f^2"
    confused_with = ("bias_instability", "markov", "bias_drift")


class Markov(_Noise):
    """Exponentially correlated noise (IEEE 952)."""

    id = "markov"
    name = "Markov noise"
    plain = "the bias scatters about its mean with a memory of one length"
    equation = "S(f) = 2 s^2 tau / (1 + (2 pi f tau)^2)"
    seen_as = "a hump of the Allan deviation at 1.89 tau"
    confused_with = ("bias_instability", "rate_random_walk")


class _Fact(_WithoutColumns):
    kind = Kind.FACT


class Dropouts(_Fact):
    """Samples that never came."""

    id = "dropouts"
    name = "Drop-outs"
    plain = "samples are missing"
    equation = "gaps in the counter or the time"
    seen_as = "steps of time that are whole multiples of the sampling time"
    remedy = "look at cable, speed of the port and load of the computer; record again"


class MissingCodes(_Fact):
    """Codes that the converter never gives."""

    id = "missing_codes"
    name = "Missing codes"
    plain = "the converter never gives some of its codes"
    equation = "empty codes between full ones"
    seen_as = "a comb in the histogram of the codes"
    remedy = "look at the converter and at the scaling of its codes"


class StaleTemperature(_Fact):
    """A temperature that does not come from the thermometer of the unit any more."""

    id = "stale_temperature"
    name = "Stale temperature"
    plain = "the temperature stands still while it cannot"
    equation = "T bit for bit the same"
    seen_as = "a run of equal temperatures far longer than chance"
    remedy = "look at the thermometer; effects of temperature cannot be judged"


class VarianceBurst(_Fact):
    """Episodes of larger scatter."""

    id = "variance_burst"
    name = "Variance burst"
    plain = "the scatter was larger for a time"
    equation = "sigma larger from t1 to t2"
    seen_as = "a wide stretch of the record"
    remedy = "look for vibration, steps, machines at that time; leave the stretch out"
    confused_with = ("outlier",)


class Clipping(_Fact):
    """Samples at the end of the range."""

    id = "clipping"
    name = "Clipping"
    plain = "samples pile up at an extreme value"
    equation = "more samples at the extreme than beside it"
    seen_as = "a flat top"
    remedy = "choose a larger range; look for shocks"
    confused_with = ("saturation",)
