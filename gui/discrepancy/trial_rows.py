"""Sealed cases whose rows are walked on the simulated bench: head, rate table, gyro at rest."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, frozen, frozen_int
from core.discrepancy.problem import Problem
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.gyro import AccelerationSensitiveDrift
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Effect, Kind, Sensor
from core.model.sensor_model import SensorModel
from core.samples.run import Conditions, Run
from core.units import PPM, RAD_PER_ARCSEC
from drivers.virtual.rows import Found, walk_rows
from gui.discrepancy.trial_case import Case, Hidden, sealed

_G = 9.8106
_K, _CROSS, _ZERO = 1335.0, (14.0, -57.0), -230.0
_RATE_K, _RATE_CROSS, _RATE_ZERO = -79.4, (0.6, -0.4), -438.0
_REST = (0.4, 1.2, -0.5)
"""Sensitivity of the gyro to acceleration, code/(m/s^2)."""
_HEAD_ARCSEC, _SETTING_ARCSEC = 3.0, 2.0
_TABLE_PPM, _SETTING_PPM = 60.0, 40.0
_PLANS = (("X_from", "Y_from"), ("X_from", "Y_from", "Z_from"))
_ANGLES = np.arange(0.0, 360.0, 22.5)
_REST_MOUNTS, _REST_ANGLES = ("X_from", "Y_from", "Z_from"), np.arange(0.0, 360.0, 45.0)
_RATES = np.linspace(-100.0, 100.0, 13)
_EVERY_S = 40.0
_COUNTS, _SHARES = (0, 1, 2), (0.2, 0.6, 0.2)
_LEAST, _MOST = 12.0, 40.0


@dataclass(frozen=True, slots=True)
class RowsKind:
    """One kind of test that is walked row by row.

    Parameters
    ----------
    hidden : identifiers of what can be hidden
    stream : of the chance, so that cases of the same number differ from kind to kind
    rows : makes the plan, all that is not yet an output
    plain : the unit
    white, drift : standard deviation of a mean, and of the slow part of the noise, code
    setting, repeating : relative error of each rate; rad of each angle of the head
    """

    hidden: tuple[str, ...]
    stream: tuple[int, ...]
    rows: Callable[[np.random.Generator], Run]
    plain: tuple[SensorModel, FloatArray]
    white: float
    drift: float
    setting: float
    repeating: float


def rows_case(seed: int, kind: RowsKind) -> Case:
    """Measure on the simulated bench with something hidden in it."""
    rng = np.random.default_rng([seed, *kind.stream])
    rows = kind.rows(rng)
    plain, values = kind.plain
    clean = replace(rows, y=plain.predict(Problem.of(rows).stimulus, values)[:, None])
    problem = Problem.of(clean)
    on_table = clean.test == "rate_table"
    size = np.abs(clean.set_rate_dps) if on_table else np.ones(len(clean))
    noise = np.hypot(kind.white, kind.drift) * np.ones(len(clean))
    if on_table:
        noise = np.hypot(noise, abs(_RATE_K) * size * np.hypot(kind.setting, kind.repeating))
    hidden = _drawn(problem, kind.hidden, noise, rng)
    found = Found(
        models=[_instant(plain, values, hidden)],
        white=np.array([kind.white]),
        drift=np.array([kind.drift]),
        setting=kind.setting * size,
        repeating=kind.repeating * size,
        columns=problem.stimulus.columns,
    )
    y = _afterwards(walk_rows(clean, found, seed), problem, hidden)
    return sealed(seed, replace(clean, y=frozen(y)), hidden, rng.bytes(8).hex())


def _head_rows(rng: np.random.Generator) -> Run:
    """Mixed angles, all twice, the unit warming up by some tenths of a degree."""
    mounts = _PLANS[int(rng.integers(len(_PLANS)))]
    places = _places(mounts, _ANGLES, 2, rng)
    conditions = Conditions(
        g_mps2=_G, accumulation_s=2.0, head_u_arcsec=_HEAD_ARCSEC, sample_rate_hz=25.0
    )
    run = _bare("dividing_head", "accelerometer", 2, len(places), conditions, rng)
    return replace(
        run,
        channels=("acc_z",),
        mount=tuple(mount for mount, _ in places),
        head_deg=frozen([angle for _, angle in places]),
        y_se=np.full((len(places), 1), _ACCELEROMETER.white),
    )


def _rest_rows(rng: np.random.Generator) -> Run:
    """A gyro at rest in mixed positions, all three times."""
    places = _places(_REST_MOUNTS, _REST_ANGLES, 3, rng)
    conditions = Conditions(
        g_mps2=_G, accumulation_s=10.0, head_u_arcsec=_HEAD_ARCSEC, sample_rate_hz=10.0
    )
    run = _bare("static_positions", "gyro", 3, len(places), conditions, rng)
    return replace(
        run,
        channels=("gyro_z",),
        mount=tuple(mount for mount, _ in places),
        head_deg=frozen([angle for _, angle in places]),
        y_se=np.full((len(places), 1), _REST_GYRO.white),
    )


def _table_rows(rng: np.random.Generator) -> Run:
    """Rates of both signs in mixed order, four times."""
    rates = np.concatenate([rng.permutation(_RATES) for _ in range(4)])
    conditions = Conditions(
        g_mps2=_G, accumulation_s=10.0, rate_u_ppm=_TABLE_PPM, sample_rate_hz=10.0
    )
    run = _bare("rate_table", "gyro", 4, len(rates), conditions, rng)
    return replace(
        run,
        channels=("gyro_z",),
        mount=("Z_from",) * len(rates),
        set_rate_dps=frozen(rates),
        y_se=np.full((len(rates), 1), _TABLE_GYRO.white),
    )


def _places(
    mounts: Sequence[str], angles: FloatArray, passes: int, rng: np.random.Generator
) -> list[tuple[str, float]]:
    return [
        (mount, float(angle))
        for _ in range(passes)
        for mount in mounts
        for angle in rng.permutation(angles)
    ]


def _bare(
    test: str, sensor: str, passes: int, n: int, conditions: Conditions, rng: np.random.Generator
) -> Run:
    """Rows without positions; the unit warms up by some tenths of a degree."""
    t = _EVERY_S * np.arange(n)
    warm = 24.0 + 0.9 * (1.0 - np.exp(-t / 1500.0)) + 0.1 * np.sin(t / 700.0)
    return Run(
        test=test,
        sensor=sensor,
        device="Blind trial",
        channels=("",),
        axes=("z",),
        unit="code",
        # Something that a plain model can be prepared from.
        y=rng.standard_normal((n, 1)),
        y_se=np.full((n, 1), np.nan),
        run=frozen_int([1 + place * passes // n for place in range(n)]),
        order=np.arange(n),
        mount=("",) * n,
        head_deg=np.full(n, np.nan),
        set_rate_dps=np.full(n, np.nan),
        temperature_c=frozen(warm.round(3)),
        t_s=frozen(t),
        conditions=conditions,
    )


def _drawn(
    problem: Problem, names: Sequence[str], noise: FloatArray, rng: np.random.Generator
) -> list[Hidden]:
    """What is hidden, each at a size that these rows show."""
    count = int(rng.choice(_COUNTS, p=_SHARES))
    hidden: list[Hidden] = []
    design = problem.design() / noise[:, None]
    for name in rng.choice(names, size=count, replace=False).tolist():
        effect = _instance(CATALOGUE[name], problem, rng)
        columns = problem.columns(effect, 0)
        if not columns.shape[1]:
            hidden.append((effect, np.zeros(0)))
            continue
        direction = rng.standard_normal(columns.shape[1])
        curve = columns @ direction / noise
        seen = curve - design @ np.linalg.lstsq(design, curve, rcond=None)[0]
        wanted = float(rng.uniform(_LEAST, _MOST))
        hidden.append((effect, direction * wanted / max(float(np.linalg.norm(seen)), 1e-300)))
    return hidden


def _instance(effect: Effect, problem: Problem, rng: np.random.Generator) -> Effect:
    """One place and shape that the rows could show."""
    if effect.kind is Kind.EXCHANGE:
        pairs = effect.exchanges(problem.stimulus)
        first, second = pairs[int(rng.integers(len(pairs)))].tolist()
        return effect.exchanged(first, second)
    instances = effect.instances(problem.stimulus, problem.models[0].sensor)
    return instances[int(rng.integers(len(instances)))]


def _plays(effect: Effect) -> bool:
    """Whether the bench plays it: it acts at the moment, and in no single row alone."""
    return effect.instant and effect.kind is Kind.BLOCK


def _instant(
    plain: SensorModel, values: FloatArray, hidden: Sequence[Hidden]
) -> tuple[SensorModel, FloatArray]:
    """The unit on the bench: what acts at the moment."""
    model, numbers = plain, values.tolist()
    for effect, sizes in hidden:
        if _plays(effect):
            model, numbers = model.with_effect(effect), [*numbers, *sizes.tolist()]
    return model, frozen(numbers)


def _afterwards(y: FloatArray, problem: Problem, hidden: Sequence[Hidden]) -> FloatArray:
    """What acts between rows, and rows that were exchanged."""
    for effect, sizes in hidden:
        if not _plays(effect) and len(sizes):
            y = y + (problem.columns(effect, 0) @ sizes)[:, None]
    for effect, sizes in hidden:
        if not len(sizes):
            y = effect.relabel(problem.stimulus, y)[1]
    return y


_ACCELEROMETER = RowsKind(
    hidden=(
        *("second_order_nonlinearity", "third_order_nonlinearity", "cross_coupling"),
        *("scale_factor_asymmetry", "bias_asymmetry", "hysteresis", "head_eccentricity"),
        *("head_ellipticity", "bias_drift", "warm_up", "bias_jump", "bias_temperature"),
        *("scale_factor_temperature", "outlier", "wrong_angle", "positions_swapped"),
    ),
    stream=(0xB11D,),
    rows=_head_rows,
    plain=(
        SensorModel(
            Sensor("accelerometer", "z", "code", (*_CROSS, _K)),
            (CATALOGUE["bias"], CATALOGUE["scale_factor"], CrossAxis("xy")),
        ),
        frozen([_ZERO, _K, *_CROSS]),
    ),
    white=0.5,
    drift=0.3,
    setting=_SETTING_ARCSEC * RAD_PER_ARCSEC,
    repeating=_HEAD_ARCSEC * RAD_PER_ARCSEC,
)
_TABLE_GYRO = RowsKind(
    hidden=(
        *("second_order_nonlinearity", "third_order_nonlinearity", "scale_factor_asymmetry"),
        *("dead_band", "saturation", "hysteresis", "settling_lag", "table_slip", "wrong_rate"),
        *("bias_drift", "warm_up", "bias_jump", "bias_temperature", "scale_factor_temperature"),
        *("run_bias", "run_scale_factor", "outlier", "positions_swapped"),
    ),
    stream=(0xB11D, 1),
    rows=_table_rows,
    plain=(
        SensorModel(
            Sensor("gyro", "z", "code", (*_RATE_CROSS, _RATE_K)),
            (CATALOGUE["bias"], CATALOGUE["scale_factor"], CrossAxis("xy")),
        ),
        frozen([_RATE_ZERO, _RATE_K, *_RATE_CROSS]),
    ),
    white=0.9,
    drift=0.5,
    setting=_SETTING_PPM * PPM,
    repeating=_TABLE_PPM * PPM,
)
_REST_GYRO = RowsKind(
    hidden=(
        *("g_squared_sensitivity", "magnetic_sensitivity", "hysteresis", "remount_bias"),
        *("bias_drift", "warm_up", "bias_jump", "bias_temperature", "outlier"),
    ),
    stream=(0xB11D, 2),
    rows=_rest_rows,
    plain=(
        SensorModel(
            Sensor("gyro", "z", "code"), (CATALOGUE["bias"], AccelerationSensitiveDrift("xyz"))
        ),
        frozen([_RATE_ZERO, *_REST]),
    ),
    white=0.9,
    drift=0.4,
    setting=_SETTING_ARCSEC * RAD_PER_ARCSEC,
    repeating=_HEAD_ARCSEC * RAD_PER_ARCSEC,
)
ROWS: dict[str, RowsKind] = {
    "head": _ACCELEROMETER,
    "table": _TABLE_GYRO,
    "rest": _REST_GYRO,
}
"""By the key of the kind."""
