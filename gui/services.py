"""What every tab is given."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from core.archive.nearest import Usable
from core.certificates.measured import Measured
from core.errors import FormatError
from core.plans.plan import Plan
from core.procedures.added import Added
from core.samples.run import Run
from drivers.profile import Profile
from gui.devices.connection import Connection
from gui.jobs import Jobs
from gui.messages import Messages
from gui.settings import Settings

Nearest = Callable[[str, datetime, float, str], tuple[Usable, ...]]
"""Device, moment, temperature and sensor -> calibrations of the archive, the nearest first."""


@dataclass(frozen=True, slots=True, eq=False)
class Addition:
    """A run whose model is to have further effects.

    Parameters
    ----------
    run : the rows
    paths : session's folder or files that they came from
    added : the effects; none for the plain model again
    """

    run: Run
    paths: tuple[Path, ...]
    added: Added


def _nothing_near(_: str, __: datetime, ___: float, ____: str) -> tuple[Usable, ...]:
    """There is no archive."""
    return ()


def _nobody(_: Addition, __: bool) -> bool:
    """No tab calibrates."""
    return False


def _no_grades(_: Plan, __: int) -> None:
    """Nobody grades plans."""


def _no_tab(_: Plan) -> bool:
    """No tab takes plans."""
    return False


def _no_loader(_: str, __: Path) -> bool:
    """No tab takes files."""
    return False


def _no_certificates(_: Measured) -> None:
    """Nobody makes certificates."""


def _never_busy() -> str:
    """Nothing is being measured."""
    return ""


def _no_reader(path: Path) -> Measured:
    """Nobody reads results."""
    raise FormatError(path, "no certificate can be made of files here")


@dataclass(frozen=True, slots=True)
class Services:
    """What all tabs share.

    Parameters
    ----------
    connection : the devices
    jobs : worker threads
    messages : banner and log
    settings : what is remembered
    profiles : returns the device files by id
    root : returns the folder of all sessions
    play : the loudspeaker: ``"start"``, ``"done"`` or ``"error"``
    open_plan : hands a plan to the tab that measures it and shows that tab; returns whether one
        took it
    open_file : hands a file, or a session's folder, to the tab of a title and shows that tab;
        returns whether there is such a tab
    certify : hands results to the tab that makes certificates, and shows that tab
    read_measured : returns what a file holds, processed; raises `LabError`
    why_busy : returns why the ports cannot be let go of now; empty if they can
    calibrate_with : hands a run with added effects to the tab that calibrates such runs; if told
        so it shows that tab, else only a page that shows this run is renewed; returns whether a
        tab took it
    nearest : returns the calibrations of a device nearest to a moment and a temperature (NaN: any),
        of a sensor (empty: either); for a worker, raises `LabError`
    grade_plan : tells what a plan, walked so often, can show; shows the tab that does
    """

    connection: Connection
    jobs: Jobs
    messages: Messages
    settings: Settings
    profiles: Callable[[], Mapping[str, Profile]]
    root: Callable[[], Path]
    play: Callable[[str], None]
    open_plan: Callable[[Plan], bool] = _no_tab
    open_file: Callable[[str, Path], bool] = _no_loader
    certify: Callable[[Measured], None] = _no_certificates
    read_measured: Callable[[Path], Measured] = _no_reader
    why_busy: Callable[[], str] = _never_busy
    calibrate_with: Callable[[Addition, bool], bool] = _nobody
    grade_plan: Callable[[Plan, int], None] = _no_grades
    nearest: Nearest = _nothing_near
