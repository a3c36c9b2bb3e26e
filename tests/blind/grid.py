"""Which cases make the benchmark."""

import hashlib

import numpy as np

from tests.blind.cases import Spec
from tests.blind.effects import HIDDEN
from tests.blind.long_record import FAULTS, NATURAL, SLOW
from tests.blind.outside import OUTSIDE
from tests.blind.plans import STATIC

PLANS = {
    "dividing_head": ("A24", "A8x3", "A48x1", "A104", "A192", "A80"),
    "rate_table": ("B11x1", "B11x3", "B84", "B84r"),
    "static_positions": tuple(STATIC),
    "record": ("D1h",),
}
RICH = ("A80", "A104", "A192", "B84", "B84r", "D1h")
SPARSE = ("A8", "A48s")
"""Plans whose answers are tied: what to measure next is asked here."""
LASTING = (
    "second_order_nonlinearity",
    "third_order_nonlinearity",
    "odd_quadratic_nonlinearity",
    "cross_axis_nonlinearity",
    "cross_coupling",
    "scale_factor_asymmetry",
    "saturation",
    "head_eccentricity",
    "head_ellipticity",
    "settling_lag",
    "hysteresis",
)
LAMBDAS = (8.0, 12.0, 20.0)
FULL = {"clean": 200, "coloured": 80, "single": 4, "several": 50, "outside": 12, "fault": 8,
        "advice": 6, "long": 6}  # fmt: skip


def seeds(plan: str, kind: str, effect: str = "", lam: float = 0.0, lot: int = 0) -> int:
    """A seed of its own for each cell, the same on every machine.

    Another lot holds cases that nobody has seen yet; what guided a change no longer judges it.
    """
    text = f"{plan}/{kind}/{effect}/{lam:g}" + (f"/lot {lot}" if lot else "")
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:7], "big")


def cell(
    plan: str, kind: str, count: int, effect: str = "", lam: float = 12.0, lot: int = 0
) -> list[Spec]:
    first = seeds(plan, kind, effect, lam, lot)
    return [Spec(plan, kind, lam, first + i, effect) for i in range(count)]


def is_natural(test: str, name: str) -> bool:
    return name in NATURAL if test == "record" else HIDDEN[test][name].natural


def names_of(test: str) -> list[str]:
    return [*SLOW, "pickup", *NATURAL] if test == "record" else list(HIDDEN[test])


def plan_cells(test: str, plan: str, counts: dict[str, int], lot: int) -> dict[str, list[Spec]]:
    """Groups of cases of one plan."""
    groups: dict[str, list[Spec]] = {
        "clean": cell(plan, "none", counts["clean"], lot=lot),
        "coloured": cell(plan, "coloured", counts["coloured"], lot=lot),
        "single": [],
        "fault": [],
        "outside": [],
    }
    for name in names_of(test):
        if is_natural(test, name):
            groups["fault"] += cell(plan, "fault", counts["fault"], name, lot=lot)
        else:
            for lam in LAMBDAS:
                groups["single"] += cell(plan, "single", counts["single"], name, lam, lot)
    for name in OUTSIDE[test]:
        for lam in (12.0, 20.0):
            groups["outside"] += cell(plan, "outside", counts["outside"], name, lam, lot)
    for kind in ("double", "triple") if plan in RICH else ():
        groups[kind] = [
            spec
            for lam in (12.0, 20.0)
            for spec in cell(plan, kind, counts["several"], "", lam, lot)
        ]
    return groups


def specs(counts: dict[str, int] | None = None, lot: int = 0) -> dict[str, list[Spec]]:
    """All cases of a lot by group."""
    counts = counts or FULL
    groups: dict[str, list[Spec]] = {"advice": []}
    for test, plans in PLANS.items():
        for plan in plans:
            for group, some in plan_cells(test, plan, counts, lot).items():
                groups.setdefault(group, []).extend(some)
    for plan in SPARSE:
        for name in LASTING:
            groups["advice"] += cell(plan, "single", counts["advice"], name, lot=lot)
    groups["clean"] += cell("A400", "none", counts["long"], lot=lot)
    groups["clean"] += cell("D1h100", "none", counts["long"], lot=lot)
    for name in ("thermal_lag", "quadrature_leakage", *FAULTS):
        groups["long"] = groups.get("long", []) + cell("D1h100", "single", 1, name, 20.0, lot)
    return groups


def quick(number: int, lot: int = 0, plans: tuple[str, ...] = ()) -> dict[str, list[Spec]]:
    """At most `number` cases of each group (of these plans), chosen at random, always the same."""
    rng = np.random.default_rng(20)
    chosen = {}
    for group, some in specs(lot=lot).items():
        cheap = [spec for spec in some if spec.plan != "D1h100" or group == "long"]
        cheap = [spec for spec in cheap if not plans or spec.plan in plans]
        picks = sorted(rng.permutation(len(cheap))[: 2 if group == "long" else number])
        chosen[group] = [cheap[i] for i in picks]
    return chosen
