"""Inputs from outputs by a calibration whose model has more than straight lines.

The linear part is turned round by Q (2.5) or by the scale factor; what the added effects of the
sensor do at that input is taken off the output, and the input is found anew until it stands.
"""

from dataclasses import replace

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError
from core.model.catalogue.listing import CATALOGUE
from core.model.catalogue.nonlinear import CrossAxisSquare, CrossCoupling
from core.model.effect import AXES, Effect, Sensor
from core.model.stimulus import Stimulus
from core.procedures.added import AddedEffect, bare_name, response_of
from core.procedures.calibration import Calibration

_ROUNDS = 60
_STANDS = 1e-13
_BY_TEMPERATURE = frozenset(("bias_temperature", "scale_factor_temperature"))


def has_effects(calibration: Calibration) -> bool:
    """Whether there is more to take out than the linear part."""
    return any(one.in_use for of_channel in calibration.effects for one in of_channel)


def needs_temperature(calibration: Calibration) -> bool:
    """Whether what is to be taken out depends on the temperature."""
    return any(one.effect in _BY_TEMPERATURE for own in calibration.effects for one in own)


def linear_map(calibration: Calibration) -> tuple[FloatArray, FloatArray]:
    """Outputs (c,) at zero input and inputs per unit of output (c, c), in the order of channels.

    Three sensors with all cross axes give a = Q (U - U0) (2.5); others (U - U0) / k each.
    """
    zero = np.array([fit.value("bias") for fit in calibration.fits])
    if not calibration.is_triad:
        return zero, np.diag([1.0 / fit.value("scale_factor") for fit in calibration.fits])
    order = [calibration.axes.index(axis) for axis in AXES]
    inverse = np.zeros((3, 3))
    # Q takes outputs in the order x, y, z and gives the axes in it.
    inverse[np.ix_(order, order)] = calibration.triad().q
    return zero, inverse


def compensated(
    calibration: Calibration, outputs: FloatArray, temperature_c: FloatArray | None = None
) -> FloatArray:
    """Return the inputs (n, c), each along its sensor's axis.

    Parameters
    ----------
    calibration : three sensors with all cross axes are solved as one, others each by itself
    outputs : (n, c) in the order of its channels
    temperature_c : (n,) of the case; only effects of temperature need it

    Raises
    ------
    FitError
        A temperature is needed, or the inputs do not converge: an effect is as large as the linear
        part.
    """
    zero, inverse = linear_map(calibration)
    found = (outputs - zero) @ inverse.T
    if not has_effects(calibration):
        return frozen(found)
    before = found
    for _ in range(_ROUNDS):
        before = found
        extra = added_output(calibration, found, temperature_c)
        found = (outputs - zero - extra) @ inverse.T
        if np.all(np.abs(found - before) <= _STANDS * (1.0 + np.abs(found))):
            return frozen(found)
    if not np.all(np.abs(found - before) <= 1e-6 * (1.0 + np.abs(found))):
        raise FitError(
            "the effects of this calibration are as large as its scale factor at these outputs;"
            " they cannot be taken out"
        )
    return frozen(found)


def added_output(
    calibration: Calibration, inputs: FloatArray, temperature_c: FloatArray | None = None
) -> FloatArray:
    """What the added effects of the sensors add to their outputs (n, c) at inputs (n, c)."""
    if needs_temperature(calibration) and temperature_c is None:
        raise FitError("this calibration has effects of temperature: state the temperature")
    total = np.zeros_like(inputs)
    for channel, own in enumerate(calibration.effects):
        stimulus = _acting(calibration, channel, inputs, temperature_c)
        fit, axis = calibration.fits[channel], calibration.axes[channel] or "z"
        sensor = Sensor(calibration.sensor, axis, calibration.unit)
        sensor = replace(sensor, response=response_of(sensor, fit))
        for one in own:
            if one.in_use:
                names = [fit.names[place] for place in one.places]
                values = fit.values[list(one.places)]
                total[:, channel] += _effect(one, names).columns(stimulus, sensor) @ values
    return total


def _acting(
    calibration: Calibration,
    channel: int,
    inputs: FloatArray,
    temperature_c: FloatArray | None,
) -> Stimulus:
    """What acts on one sensor: of a triad all three axes, else its own alone."""
    n = len(inputs)
    on_axes = np.zeros((n, 3))
    seen = range(len(calibration.fits)) if calibration.is_triad else (channel,)
    for other in seen:
        on_axes[:, AXES.index(calibration.axes[other] or "z")] = inputs[:, other]
    nothing = np.zeros((n, 3))
    still = calibration.sensor == "accelerometer"
    columns: dict[str, FloatArray] = {}
    if temperature_c is not None:
        columns["temperature_c"] = temperature_c
        columns["reference_c"] = np.full(n, calibration.temperature_c)
    return Stimulus(
        a=on_axes if still else nothing,
        w=nothing if still else on_axes,
        da_dhead=nothing,
        dw_drate=nothing,
        columns=columns,
    )


def _effect(one: AddedEffect, names: list[str]) -> Effect:
    """The effect of the catalogue; which axes it takes stands in the names of its parameters."""
    if one.effect == "cross_axis_nonlinearity":
        return CrossAxisSquare(bare_name(names[0])[-1] if len(names) == 1 else "")
    if one.effect == "cross_coupling":
        return CrossCoupling(bare_name(names[0])[-2:] if len(names) == 1 else "")
    return CATALOGUE[one.effect].shaped(*(value for _, value, _ in one.shape))
