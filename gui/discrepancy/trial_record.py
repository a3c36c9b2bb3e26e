"""Sealed cases that are records: an hour of the simulated vibratory gyro while it warms."""

from dataclasses import replace

import numpy as np

from core.arrays import FloatArray, frozen
from core.discrepancy.problem import Problem
from core.discrepancy.record_problem import Samples, record_problem
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Effect
from core.samples.block import Channel
from core.samples.run import Conditions, Run
from drivers.virtual.bench import Bench, Manner, Place
from drivers.virtual.devices import Device, Housekeeping, make_device
from drivers.virtual.noise import NoiseLevel
from drivers.virtual.unit import Unit
from gui.discrepancy.trial_case import Case, Hidden, sealed

HIDDEN = (
    *("bias_drift", "warm_up", "bias_temperature", "temperature_rate", "thermal_lag"),
    *("bias_jump", "pickup", "quadrature_leakage", "damping_anisotropy"),
)
"""What can be hidden in a record."""

_STREAM = (0xB11D, 3)
_CHANNELS = (
    *(Channel("Rate", "V", "rate.z"), Channel("Temperature", "degC", "temp")),
    *(Channel("QuadratureAmpl", "V"), Channel("ExcitationAmpl", "V")),
)
_SECONDS, _WARMER_C, _COOLER_C = 3600, 33.0, 28.0
_COUNTS, _SHARES = (0, 1, 2), (0.2, 0.6, 0.2)
_LEAST, _MOST = 30.0, 80.0


def record_case(seed: int) -> Case:
    """Record on the simulated bench with something hidden in the output."""
    rng = np.random.default_rng([seed, *_STREAM])
    clean = _recorded(seed, rng)
    problem = record_problem(Samples.of(clean))
    hidden = _drawn(problem, rng)
    y = np.array(clean.y)
    for effect, sizes in hidden:
        curve = problem.columns(effect, 0) @ sizes
        y[:, 0] += np.interp(clean.t_s, problem.stimulus.column("t_s"), curve)
    return sealed(seed, replace(clean, y=frozen(y)), hidden, rng.bytes(8).hex())


def _recorded(seed: int, rng: np.random.Generator) -> Run:
    """An hour at one sample a second; the chamber warms, and cools again."""
    bench_rng, unit_rng = rng.spawn(2)
    bench = Bench(Place(), Manner(case_tau_s=200.0), 1.0, bench_rng, timed=True)
    unit = Unit(_wandering(make_device("cvg25", seed)), _CHANNELS, 1.0, unit_rng)
    parts: list[FloatArray] = []
    turn = int(rng.integers(1200, 2000))
    for celsius, count in ((_WARMER_C, turn), (_COOLER_C, _SECONDS - turn)):
        bench.heat(celsius)
        parts.append(unit.sends(bench.stimulus(count), count))
    sent = np.vstack(parts)
    n = len(sent)
    unknown = np.full(n, np.nan)
    return Run(
        test="record",
        sensor="gyro",
        device="Blind trial",
        channels=("Rate",),
        axes=("z",),
        unit="V",
        y=sent[:, :1],
        y_se=unknown[:, None],
        run=np.ones(n, dtype=np.int64),
        order=np.arange(n, dtype=np.int64),
        mount=("",) * n,
        head_deg=unknown,
        set_rate_dps=unknown,
        temperature_c=frozen(sent[:, 1]),
        t_s=np.arange(n, dtype=np.float64),
        conditions=Conditions(sample_rate_hz=1.0),
        extra={
            channel.name: frozen(sent[:, place])
            for place, channel in enumerate(_CHANNELS)
            if not channel.role
        },
    )


def _wandering(device: Device) -> Device:
    """The unit with channels that go their own ways, so that each can be told from the others."""
    keeping = dict(device.housekeeping)
    keeping["QuadratureAmpl"] = Housekeeping(0.071, 0.0, NoiseLevel(4e-5, 0.0, 3e-5))
    keeping["ExcitationAmpl"] = Housekeeping(1.0866, 0.0, NoiseLevel(3e-5, 0.0, 4e-5))
    return replace(device, housekeeping=keeping)


def _drawn(problem: Problem, rng: np.random.Generator) -> list[Hidden]:
    """What is hidden, each at a size that stands out of the scatter of the blocks."""
    count = int(rng.choice(_COUNTS, p=_SHARES))
    known = {effect.id: effect for effect in problem.effects}
    hidden: list[Hidden] = []
    for name in rng.choice(HIDDEN, size=count, replace=False).tolist():
        # The engine looks for slow lines in a record; the others are seen in its spectrum.
        effect: Effect = known[name] if name == "pickup" else CATALOGUE[name]
        instances = effect.instances(problem.stimulus, problem.models[0].sensor)
        effect = instances[int(rng.integers(len(instances)))]
        columns = problem.columns(effect, 0)
        direction = rng.standard_normal(columns.shape[1])
        curve = columns @ direction / problem.se
        seen = float(np.linalg.norm(curve - curve.mean()))
        wanted = float(rng.uniform(_LEAST, _MOST))
        hidden.append((effect, direction * wanted / max(seen, 1e-300)))
    return hidden
