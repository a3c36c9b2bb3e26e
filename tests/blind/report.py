"""The benchmark's table: measured share, Wilson interval, target, met or MISSED."""

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from tests.blind.shares import wilson

Row = dict[str, Any]
SMALL_ROWS = 400
"""Rows of a position or rate run that must be explained within a second."""


def lam(row: Row) -> float:
    return row["spec"]["lam"]


def of(rows: list[Row], *groups: str) -> list[Row]:
    return [row for row in rows if row["group"] in groups]


def share(
    name: str, rows: Iterable[Any], test: Callable[[Any], Any], target: float, peer: list[Row]
) -> str:
    """A line; a positive target is a lower limit, a negative one an upper limit, 0 is none."""
    hits = [bool(test(row)) for row in rows]
    low, high = wilson(sum(hits), len(hits))
    value = sum(hits) / len(hits) if hits else math.nan
    theirs = [bool(test(row)) for row in peer]
    other = f"{100 * sum(theirs) / len(theirs):5.1f} %" if theirs else "-"
    span = f"{100 * low:5.1f} to {100 * high:5.1f} %  n {len(hits)}"
    return line(name, f"{100 * value:5.1f} %", span, other, value, target)


def line(name: str, ours: str, span: str, peer: str, value: float, target: float) -> str:
    asked, verdict = "", ""
    if target:
        asked = f"{'>=' if target > 0 else '<='} {100 * abs(target):g} %"
        met = value >= target if target > 0 else value <= -target
        verdict = "-" if math.isnan(value) else "ok" if met else "MISSED"
    return f"{name:58s} {ours:>8s} | {span:28s} | {peer:>8s} | {asked:>9s} | {verdict}"


def clean(rows: list[Row], peer: list[Row]) -> list[str]:
    out = []
    for title, groups in (("clean", ("clean",)), ("clean, coloured noise", ("coloured",))):
        mine, theirs = of(rows, *groups), of(peer, *groups)
        out.append(share(f"{title}: any alarm", mine, lambda r: r["alarm"], -0.03, theirs))
        out.append(share(f"{title}: a name", mine, lambda r: r["named"], 0.0, theirs))
        wrong = share(
            f"{title}: confident wrong name", mine, lambda r: r["sure_wrong"], -0.01, theirs
        )
        out.append(wrong)
        out.append(share(f"{title}: abstains", mine, lambda r: r["abstained"], 0.0, theirs))
    for plan in sorted({r["spec"]["plan"] for r in of(rows, "clean", "coloured")}):
        mine = [r for r in of(rows, "clean", "coloured") if r["spec"]["plan"] == plan]
        out.append(share(f"  alarm on plan {plan}", mine, lambda r: r["alarm"], 0.0, []))
    return out


def singles(rows: list[Row], peer: list[Row]) -> list[str]:
    mine, theirs = of(rows, "single"), of(peer, "single")
    out = [
        share(
            "single, lambda >= 8: exact or in the set", mine, lambda r: r["covered"], 0.99, theirs
        )
    ]
    for size, target in ((8.0, 0.0), (12.0, 0.96), (20.0, 0.98)):
        here = [r for r in mine if lam(r) == size]
        known = [r for r in here if r["identifiable"]]
        other = [r for r in theirs if lam(r) == size and r["identifiable"]]
        title = f"single, lambda {size:g}"
        out += [
            share(f"{title}: detected", here, lambda r: r["detected"], 0.0, []),
            share(f"{title}: exact name, all", here, lambda r: r["first"], 0.0, []),
            share(f"{title}: exact name, identifiable", known, lambda r: r["first"], target, other),
            share(f"{title}: ... and no other in the set", known, lambda r: r["unique"], 0.0, []),
            share(f"{title}: name or its equal", here, lambda r: r["class"], 0.0, []),
            share(f"{title}: in the set", here, lambda r: r["covered"], 0.0, []),
            share(f"{title}: confident wrong", here, lambda r: r["sure_wrong"], 0.0, []),
        ]
        sizes = [r["set_size"] for r in known if r["detected"]]
        if sizes:
            out.append(f"{title + ': mean set, identifiable':58s} {np.mean(sizes):8.2f}")
    faults = of(rows, "fault")
    out.append(
        share("faults at natural size: exact", faults, lambda r: r["first"], 0.0, of(peer, "fault"))
    )
    out.append(share("faults at natural size: in the set", faults, lambda r: r["covered"], 0.0, []))
    return out


def by_name(rows: list[Row]) -> list[str]:
    """The names that are missed most often where they could have been told."""
    clear = [r for r in of(rows, "single") if r["identifiable"] and lam(r) >= 12.0]
    found: dict[str, list[bool]] = {}
    for row in clear:
        found.setdefault(row["spec"]["effect"], []).append(row["first"])
    worst = sorted(found, key=lambda name: sum(found[name]) / len(found[name]))[:8]
    return [
        share(f"  exact, lambda >= 12, {name}", found[name], bool, 0.0, [])
        for name in worst
        if not all(found[name])
    ]


def several(rows: list[Row], peer: list[Row]) -> list[str]:
    out = []
    for groups in (("double",), ("triple",), ("double", "triple")):
        mine, theirs = of(rows, *groups), of(peer, *groups)
        title = " and ".join(groups)
        target = 0.9 if len(groups) == 2 else 0.0
        settled = [r for r in mine if "equivalent" in r]
        out += [
            share(f"{title}: each named or in a set", mine, lambda r: r["covered"], target, theirs),
            share(f"{title}: all exact", mine, lambda r: r["first"], 0.0, []),
            share(f"{title}: equivalent", settled, lambda r: r["equivalent"], 0.0, []),
        ]
    return out


def gap(rows: list[Row]) -> list[str]:
    here = [r for r in of(rows, "single", "double", "triple") if lam(r) >= 12.0]
    values = np.array([r["closure"] for r in here if "closure" in r], float)
    values = values[np.isfinite(values)]
    if len(values) == 0:
        return []
    note = f"n {len(values)}"
    middle, low = float(np.median(values)), float(np.quantile(values, 0.1))
    return [
        line("gap closed, lambda >= 12: median", f"{middle:8.3f}", note, "", middle, 0.99),
        line("gap closed, lambda >= 12: 10th percentile", f"{low:8.3f}", note, "", low, 0.95),
    ]


def numbers(rows: list[Row]) -> list[str]:
    z = np.array([r["z"] for r in of(rows, "single") if math.isfinite(r.get("z", math.nan))])
    if len(z) == 0:
        return []
    inside = float(np.mean(np.abs(z) < 1.96))
    low, high = wilson(int(np.sum(np.abs(z) < 1.96)), len(z))
    span = f"{100 * low:5.1f} to {100 * high:5.1f} %  n {len(z)}"
    verdict = "ok" if 0.92 <= inside <= 0.98 else "MISSED"
    name = "95 % interval of the added parameter covers"
    rms = f"{'rms z of the added parameter':58s} {np.sqrt(np.mean(z**2)):8.2f}"
    return [
        f"{name:58s} {100 * inside:6.1f} % | {span:28s} | {'':>8s} | {'92..98 %':>9s} | {verdict}",
        rms,
    ]


def foreign(rows: list[Row], peer: list[Row]) -> list[str]:
    mine, theirs = of(rows, "outside"), of(peer, "outside")

    def honest(row: Row) -> bool:
        return row["said_unknown"] and not row["sure_wrong"]

    out = [share("outside the catalogue, lambda >= 12: says so", mine, honest, 0.9, theirs)]
    noticed = [r for r in mine if r["alarm"]]
    out.append(share("outside: detected", mine, lambda r: r["alarm"], 0.0, []))
    out.append(share("outside: says so if detected", noticed, honest, 0.0, []))
    out.append(share("outside: confident false name", mine, lambda r: r["sure_wrong"], 0.0, theirs))
    for test in sorted({r["test"] for r in mine}):
        here = [r for r in mine if r["test"] == test]
        out.append(share(f"  says so, {test}", here, honest, 0.0, []))
    return out


def advice(rows: list[Row]) -> list[str]:
    tied = [r for r in of(rows, "advice") if "unique_advice" in r]
    return [
        share("advice: unique and right afterwards", tied, lambda r: r["unique_advice"], 0.92, []),
        share("  the same after a sweep by lot", tied, lambda r: r["unique_lot"], 0.0, []),
    ]


def times(rows: list[Row]) -> list[str]:
    out = []
    for name, limit, here in (
        ("time, runs of up to 400 rows", 1.0, [r for r in rows if 0 < r["rows"] <= SMALL_ROWS]),
        ("time, 1 h x 1 Hz", 5.0, [r for r in rows if r["spec"]["plan"] == "D1h"]),
        ("time, 1 h x 100 Hz x 7", 5.0, [r for r in rows if r["spec"]["plan"] == "D1h100"]),
    ):
        seconds = [r["seconds"] for r in here]
        if seconds:
            worst, usual = float(np.quantile(seconds, 0.95)), float(np.median(seconds))
            verdict = "ok" if worst <= limit else "MISSED"
            span = f"median {usual:.2f} s  n {len(seconds)}"
            asked = f"<= {limit:g} s"
            out.append(
                f"{name + ', 95th percentile':58s} {worst:6.2f} s | {span:28s} | {'':>8s}"
                f" | {asked:>9s} | {verdict}"
            )
    return out


def crashes(rows: list[Row]) -> list[str]:
    found = sorted({r["verdict"] for r in rows if r["verdict"].startswith("crash")})
    count = sum(r["verdict"].startswith("crash") for r in rows)
    return [f"{count} cases broke off: {found[:5]}  MISSED"] if count else []


def table(rows: list[Row], peer: list[Row]) -> list[str]:
    """All lines; `peer` is the same set of cases answered by forward stepwise regression."""
    head = (
        f"{'':58s} {'measured':>8s} | {'95 % interval':28s} | {'stepwise':>8s} | {'target':>9s} |"
    )
    lines = [
        head,
        *clean(rows, peer),
        *singles(rows, peer),
        *by_name(rows),
        *several(rows, peer),
        *gap(rows),
        *numbers(rows),
        *foreign(rows, peer),
        *advice(rows),
        *times(rows),
        *crashes(rows),
    ]
    return [text for text in lines if "nan %" not in text]
