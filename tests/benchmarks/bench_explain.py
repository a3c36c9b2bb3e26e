"""Model vs data on sealed cases: which hidden effect is named, how often the innocent is accused.

    python tests/benchmarks/bench_explain.py --full        all cases (hours on two cores)
    python tests/benchmarks/bench_explain.py --quick 100   about 100 cases of each group
    python tests/benchmarks/bench_explain.py --quick 100 --group clean --rows rows.json
    python tests/benchmarks/bench_explain.py --quick 100 --lot 7     cases that nobody has seen yet

The cases come from tests/blind, which shares no code with the program. Their keys are sealed: the
hash of all is printed before the first answer. Forward stepwise regression (p < 0.05) answers the
same cases. Every share comes with its 95 % Wilson interval.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # each process has a core of its own

import argparse
import json
import sys
import time
from pathlib import Path
from typing import Any

from core.discrepancy.ladder import explain
from core.discrepancy.result import Explanation
from core.discrepancy.to_json import explanation_to_json
from core.records.run_file import read_run
from tests.blind import grid, report, runner

QUICK = 60
"""Cases of each group when all benchmarks are run; `--full` for the published table."""


def sweeps_of(explanation: Explanation) -> list[dict[str, Any]]:
    """The best next measurement as sweeps of one mount each, in the order of its steps."""
    sweeps: list[dict[str, Any]] = []
    for proposed in explanation.next_measurements[:1]:
        on_table = proposed.plan.test == "rate_table"
        for step in proposed.plan.steps:
            if not sweeps or sweeps[-1]["key"] != (step.group, step.mount):
                key = (step.group, step.mount)
                sweeps.append({"key": key, "mount": step.mount, "settings": []})
            sweeps[-1]["settings"].append(step.rate_dps if on_table else step.head_deg)
    return sweeps


def calrig(path: Path) -> dict[str, Any]:
    """What `calrig explain FILE --json` gives, and the next measurement as sweeps."""
    explanation = explain(read_run(path))
    return {**explanation_to_json(explanation), "advice": sweeps_of(explanation)}


def main(arguments: list[str]) -> int:
    """Print the table; the exit code is the number of missed targets."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    amount = parser.add_mutually_exclusive_group()
    amount.add_argument("--quick", type=int, default=QUICK, metavar="N", help="cases of each group")
    amount.add_argument("--full", action="store_true", help="all cases")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--group", action="append", help="only this group of cases; repeatable")
    parser.add_argument("--plan", action="append", help="only this plan; repeatable")
    parser.add_argument(
        "--lot", type=int, default=0, help="another draw of all cases; 0 is the usual"
    )
    parser.add_argument("--rows", type=Path, help="write the score of every case to this file")
    parser.add_argument("--no-peer", action="store_true", help="without stepwise regression")
    chosen = parser.parse_args(arguments)
    plans = tuple(chosen.plan or ())
    groups = grid.specs(lot=chosen.lot)
    if not chosen.full:
        groups = grid.quick(chosen.quick, chosen.lot, plans)
    groups = {
        name: [spec for spec in some if not plans or spec.plan in plans]
        for name, some in groups.items()
        if not chosen.group or name in chosen.group
    }
    start = time.monotonic()
    here = "tests.benchmarks.bench_explain:calrig"
    rows = runner.run(groups, here, chosen.processes, print)
    peer: list[dict[str, Any]] = []
    if not chosen.no_peer:
        told = {name: some for name, some in groups.items() if name != "long"}
        peer = runner.run(told, "tests.blind.peers:stepwise", chosen.processes)
    if chosen.rows:
        chosen.rows.write_text(json.dumps(rows, indent=1, default=str), encoding="utf-8")
    lines = report.table(rows, peer)
    print("\n".join(lines))
    print(f"{len(rows)} cases in {time.monotonic() - start:.0f} s")
    return sum(line.endswith("MISSED") for line in lines)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
