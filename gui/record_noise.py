"""The noise of a sensor from a record of it at rest, for pages that predict."""

from dataclasses import dataclass
from pathlib import Path

from core.allan.model import NoiseModel
from core.errors import FitError
from core.records.noise_study import StudyRequest, study
from drivers.series import read_series

_IN_INPUT_UNITS = {
    "gyro": {"deg/s": 1.0, "deg/h": 1.0 / 3600.0, "rad/s": 57.29577951308232},
    "accelerometer": {"m/s^2": 1.0, "g": 9.80665, "mg": 9.80665e-3},
}
"""deg/s, or m/s^2, in one unit of a record."""


@dataclass(frozen=True, slots=True)
class RecordNoise:
    """What a record tells.

    Parameters
    ----------
    source : file and channel, in words
    model : coefficients in deg/s or m/s^2; terms that were not detected are 0
    """

    source: str
    model: NoiseModel


def noise_of_record(path: Path, kind: str, scale_factor: float = 0.0) -> RecordNoise:
    """Analyse a record; takes seconds.

    Parameters
    ----------
    path : any record
    kind : ``"accelerometer"`` or ``"gyro"``
    scale_factor : output for 1 deg/s (1 m/s^2); 0 for the one that the file states

    Raises
    ------
    FormatError
        It cannot be read.
    FitError
        It cannot be analysed, or is in no unit of this kind of sensor.
    """
    unit = {"gyro": "deg/s", "accelerometer": "m/s^2"}[kind] if scale_factor else ""
    found = study(read_series(path), StudyRequest(scale_factor=scale_factor, unit=unit))
    factor = _IN_INPUT_UNITS[kind].get(found.unit)
    if factor is None:
        raise FitError(
            f"{path.name}: the record is in {found.unit}, no unit of a {kind}; state the scale"
            " factor, or type N, B and K as the Allan tab tells them"
        )
    model = found.published.model
    return RecordNoise(
        f"{path.name}, {found.channel}",
        NoiseModel(
            random_walk=model.random_walk * factor,
            bias_instability=model.bias_instability * factor,
            rate_random_walk=model.rate_random_walk * factor,
        ),
    )
