"""A folder of sessions, and the two databases that an archive can stand in."""

import os
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from datetime import datetime, timedelta
from pathlib import Path

import numpy as np
import pytest

from core.archive.store import Archive
from core.arrays import frozen
from core.plans.plan import load_plans
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import write_calibration
from core.records.legacy.reader import read_legacy
from core.records.session.start import SessionStart
from core.records.session.store import Session
from core.samples.accumulate import accumulation_of
from core.samples.block import Channel
from core.samples.run import Conditions
from tests.postgres_server import PostgresServer

SPECIMENS = Path(__file__).parents[2] / "data" / "legacy"
STATED = Conditions(g_mps2=9.8106, u_g_mps2=1e-4, head_u_arcsec=5.0)
CHANNELS = (
    Channel("N", "", "counter"),
    Channel("AX", "code", "acc.x"),
    Channel("AY", "code", "acc.y"),
    Channel("AZ", "code", "acc.z"),
    Channel("T", "degC", "temp"),
)

# Debian's server is what is tested; on Windows the archive is tested with SQLite alone.
collect_ignore = ["test_archive_postgres.py"] if sys.platform == "win32" else []


@pytest.fixture(scope="session")
def triad() -> Calibration:
    """Table 2.2: three accelerometers in eight positions."""
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    return calibrate(run, STATED)


@pytest.fixture(scope="session")
def postgres() -> Iterator[PostgresServer]:
    """A server for the whole run."""
    server = PostgresServer()
    yield server
    server.stop()


@pytest.fixture
def root(tmp_path: Path) -> Path:
    folder = tmp_path / "CalRig"
    folder.mkdir()
    return folder


@pytest.fixture
def archive(root: Path) -> Iterator[Archive]:
    with Archive(root) as opened:
        yield opened


def calibrated(
    triad: Calibration,
    folder: Path,
    *,
    when: str = "2025-03-01T10:00:00+00:00",
    bias: float = 0.0,
    temperature_c: float = 25.0,
    device: str = "PW09",
) -> Path:
    """Write a calibration as of another day: the first bias is moved by `bias`."""
    fit = triad.fits[0]
    values = np.array(fit.values)
    values[fit.names.index("bias")] += bias
    moved = replace(
        triad,
        fits=(replace(fit, values=frozen(values)), *triad.fits[1:]),
        temperature_c=temperature_c,
        provenance=replace(triad.provenance, device=device, measured_utc=when),
    )
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "calibration.cal.json"
    write_calibration(moved, path)
    return path


def measured(
    folder: Path,
    *,
    device: str = "PW09",
    operator: str = "Олена",
    started: str = "2024-05-14T09:30:05+03:00",
    finish: bool = True,
    positions: int = 2,
) -> Path:
    """Write a session with so many positions."""
    plan = load_plans()["pointer_8"]
    start = SessionStart(
        device=device,
        sensor="accelerometer",
        channels=CHANNELS,
        rate=100.0,
        plan=plan,
        started=started,
        profile="pw09_raw",
        operator=operator,
    )
    moment = datetime.fromisoformat(started)

    def clock() -> datetime:
        nonlocal moment
        moment += timedelta(seconds=10)
        return moment

    session = Session.create(folder, start, now=clock)
    rng = np.random.default_rng(3)
    for step in plan.steps[:positions]:
        data = rng.normal(0.0, 0.5, (200, len(CHANNELS)))
        data += [0.0, 100.0, -10.0, 12866.0, 26.0]
        mean = accumulation_of(CHANNELS, np.arange(200) / 100.0, data)
        session.accept(step, mean, temperature_c=26.0)
    if finish:
        session.finish()
    session.close()
    return folder


def old(root: Path) -> None:
    """Let everything lie still since last year."""
    last_year = time.time() - 4e7
    for path in [root, *root.rglob("*")]:
        os.utime(path, (last_year, last_year))


@pytest.fixture
def specimens() -> Callable[[Path], list[Path]]:
    """Copies the practicum's old files into a folder."""

    def copy(folder: Path) -> list[Path]:
        folder.mkdir(parents=True, exist_ok=True)
        sources = sorted(SPECIMENS.glob("*.txt"))
        return [Path(shutil.copy2(path, folder / path.name)) for path in sources]

    return copy
