"""Two engines for comparison: one that was told, and the usual forward stepwise regression."""

import json
import tomllib
from pathlib import Path
from typing import Any

import numpy as np

from tests.blind import geometry

P_ENTER = 0.05


def oracle(path: Path) -> dict[str, Any]:
    """Look into the key: what a perfect engine would answer."""
    case, _, more = path.name.removesuffix(".run.csv").partition("-")
    key = json.loads(path.with_name(f"{case}.key.json").read_text("utf-8"))
    foreign = key["spec"]["kind"] == "outside"
    steps = [
        {
            "effect": "unexplained_structure" if foreign else name,
            "probability": 1.0,
            "indistinguishable_from": [] if foreign or more else effect["equals"],
            "parameters": [],
        }
        for name, effect in key["effects"].items()
    ]
    verdict = "unexplained_structure" if foreign else "explained" if steps else "adequate"
    return {
        "verdict": verdict,
        "steps": steps,
        "advice": [{"mount": "Z_from@45", "settings": [30.0 * i for i in range(12)]}],
        "before": {"rms": key.get("before_rms", 1.0)},
        "after": {"rms": key.get("oracle_rms", 1.0)},
    }


def table_of(path: Path) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    lines = path.read_text("utf-8").splitlines()
    head = [line[1:] for line in lines if line.startswith("#")]
    names, *rows = [line.split(",") for line in lines if not line.startswith("#")]
    columns = {n: np.array(v) for n, v in zip(names, zip(*rows, strict=True), strict=True)}
    text = {n: v if n == "mount" else v.astype(float) for n, v in columns.items()}
    return tomllib.loads("\n".join(head)), text


def regressors(
    items: dict[str, Any], table: dict[str, np.ndarray]
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Columns of the plain model and the candidates of the first output."""
    n = len(table["t_s"])
    one, t = np.ones(n), table["t_s"]
    names: dict[str, np.ndarray] = {"bias_drift": t, "warm_up": np.exp(-t / 400.0)}
    if "temperature_c" in table:
        names["bias_temperature"] = table["temperature_c"] - table["temperature_c"].mean()
    if items["test"] == "record":
        for effect, column in (
            ("quadrature_leakage", "QuadratureAmpl"),
            ("resonator_frequency", "AntiNodePeriod"),
            ("amplitude_error", "AntiNodeAmplitude"),
            ("damping_anisotropy", "ExcitationAmpl"),
        ):
            names[effect] = table[column] - table[column].mean()
        return one[:, None], names
    if items["test"] == "rate_table":
        s = table["set_rate_dps"] / 100.0
        plain = np.stack([one, s], axis=1)
    else:
        dial = np.radians(table["head_deg"])
        room = geometry.attitude(list(table["mount"]), dial, 0.0, np.zeros(n))
        force = geometry.seen_from_case(geometry.UP, room)
        own = "xyz".index(items["axis"][0])
        s, x, y = (force[:, (own + i) % 3] for i in range(3))
        plain = np.column_stack([one, force])
        names |= {"cross_coupling": s * y, "cross_axis_nonlinearity": x**2}
        names |= {"head_ellipticity": np.sin(2 * dial) * x, "head_eccentricity": np.cos(dial) * y}
    names |= {
        "second_order_nonlinearity": s**2,
        "third_order_nonlinearity": s**3,
        "scale_factor_asymmetry": np.abs(s),
        "bias_asymmetry": np.sign(np.round(s, 6)),
        "settling_lag": np.diff(s, prepend=s[0]),
        "hysteresis": np.sign(np.diff(s, prepend=s[0])),
    }
    return plain, names


def stepwise(path: Path) -> dict[str, Any]:
    """Ordinary least squares; the best further regressor enters while p < 0.05."""
    from scipy.special import stdtr

    items, table = table_of(path)
    plain, names = regressors(items, table)
    y = table["y" if "y" in table else "y_x"]
    chosen: list[dict[str, Any]] = []
    columns = severity_basis(plain)
    before = residual = y - columns @ (columns.T @ y)
    while len(chosen) < 4 and len(y) > columns.shape[1] + 2:
        best = (1.0, "", columns[:, 0])
        for name, values in names.items():
            rest = values - columns @ (columns.T @ values)
            length = np.linalg.norm(rest)
            if length < 1e-6 * max(np.linalg.norm(values), 1e-12):
                continue
            part = float(rest @ residual) / length
            dof = len(y) - columns.shape[1] - 1
            noise = np.sqrt(max(float(residual @ residual) - part**2, 1e-300) / dof)
            p = 2.0 * float(stdtr(dof, -abs(part) / noise))
            best = min(best, (p, name, rest / length), key=lambda entry: entry[0])
        if best[0] > P_ENTER or not best[1]:
            break
        chosen.append({"effect": best[1], "probability": 1.0 - best[0], "p_value": best[0]})
        names.pop(best[1])
        columns = np.column_stack([columns, best[2]])
        residual = y - columns @ (columns.T @ y)
    return {
        "verdict": "explained" if chosen else "adequate",
        "steps": chosen,
        "before": {"rms": float(np.sqrt(np.mean(before**2)))},
        "after": {"rms": float(np.sqrt(np.mean(residual**2)))},
    }


def severity_basis(columns: np.ndarray) -> np.ndarray:
    """Orthonormal columns without those that are only rounding."""
    u, s, _ = np.linalg.svd(columns, full_matrices=False)
    return u[:, s > 1e-9 * s[0]]
