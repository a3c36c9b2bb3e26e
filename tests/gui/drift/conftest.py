"""The tab without the rest of the window, and turn-ons as files."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from core.procedures.drift.simulated import turn_on
from core.records.run_file import write_run
from core.samples.run import Run
from gui.drift.tab import DriftTab
from gui.services import Services

RATE = 20.0


def turn_on_run(path: Path, ambient: float, count: int, rows: int = 2400) -> Path:
    """One run file of `count` turn-ons at one temperature of the chamber."""
    rng = np.random.default_rng(round(ambient) + 100)
    made = [turn_on(rng, ambient, 0, rate=RATE) for _ in range(count)]
    y = np.concatenate([one[:rows] for one, _ in made])
    chip = np.concatenate([warm[:rows] for _, warm in made])
    n = len(y)
    unknown = np.full(n, np.nan)
    write_run(
        Run(
            "record",
            "gyro",
            "GIB-7",
            ("x",),
            ("x",),
            "deg/s",
            y[:, None],
            np.full((n, 1), np.nan),
            np.repeat(np.arange(1, count + 1), rows),
            np.arange(n),
            ("",) * n,
            unknown,
            unknown,
            chip,
            np.tile((np.arange(rows) + 0.5) / RATE, count),
            extra={"ambient_c": np.full(n, ambient)},
        ),
        path,
    )
    return path


def columns(path: Path, ambient: float, seed: int, rows: int = 2400) -> Path:
    """One turn-on as columns of numbers."""
    y, chip = turn_on(np.random.default_rng(seed), ambient, 0, rate=RATE)
    t = np.arange(len(y)) / RATE
    lines = [f"{a:.3f},{b:.9f},{c:.3f}" for a, b, c in zip(t, y, chip, strict=True)][:rows]
    path.write_text("t_s,rate_z_dps,temp_degC\n" + "\n".join(lines) + "\n", encoding="utf-8")
    return path


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Three temperatures, four turn-ons each."""
    made = tmp_path / "records"
    made.mkdir()
    for ambient in (-20.0, 10.0, 40.0):
        turn_on_run(made / f"at_{ambient:+.0f}.run.csv", ambient, 4)
    (made / "notes.md").write_text("not a record", encoding="utf-8")
    return made


@pytest.fixture
def tab(services: Services, show_tab: Callable[[DriftTab], None]) -> DriftTab:
    """The tab with its plots, on the screen."""
    made = DriftTab(services)
    made.messages = services.messages
    show_tab(made)
    return made
