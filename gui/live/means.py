"""Means of records or intervals: a table, and a run file of them for the rate table or the head."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, Signal

from core.errors import FormatError, LabError, Severity
from core.records.cvgcom_name import CvgcomName
from core.records.means import RecordMean, means_run, number_of, position_of
from core.records.names import safe_name, stamp
from core.records.run_file import write_run
from core.samples.run import Run
from gui.messages import Messages
from gui.widgets.number_text import value_and_uncertainty
from gui.widgets.states import BannerState

SOURCE = "means"
RATES, POSITIONS = "rates", "positions"
SUFFIX = ".run.csv"


def _say(text: str) -> str:
    return QCoreApplication.translate("LiveMeans", text)


@dataclass(frozen=True, slots=True)
class MeansState:
    """The page.

    Parameters
    ----------
    header : titles of the columns; the second is what the operator enters
    rows : texts, one row a mean
    kind : `RATES` or `POSITIONS`: what is entered
    file : proposed run file; empty while there are no means
    """

    header: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()
    kind: str = RATES
    file: str = ""


class Means(QObject):
    """What was averaged last.

    Parameters
    ----------
    messages : where it is told what became of the file
    """

    changed = Signal(object)
    """A new `MeansState`."""

    def __init__(self, messages: Messages, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._messages = messages
        self._means: Sequence[RecordMean] = ()
        self._given: list[str] = []
        self._folder = Path()
        self._device = ""
        self.state = MeansState()

    def take(self, means: Sequence[RecordMean], folder: Path, device: str) -> None:
        """Show other means, whose files stand in a folder."""
        names = (CvgcomName.parse(one.record) for one in means)
        self._device = next((name.device for name in names if name is not None), device)
        self._means, self._folder = means, folder
        self._given = [""] * len(means)
        self._tell(self.state.kind)

    def set_kind(self, kind: str) -> None:
        """Enter rates of the table, or positions of the head."""
        if kind != self.state.kind:
            self._given = [""] * len(self._means)
            self._tell(kind)

    def give(self, row: int, texts: Sequence[str]) -> None:
        """Enter what was set for records, from a row on."""
        for place, text in enumerate(texts, row):
            if place < len(self._given):
                self._given[place] = text.strip()
        self._tell(self.state.kind)

    def hand_over(self, name: str) -> None:
        """Write the run file that the fits load."""
        path = self._folder / Path(name.strip()).expanduser()
        try:
            if path.exists():
                raise FormatError(path, "exists already; nothing measured is overwritten")
            write_run(self._run(), path)
        except LabError as error:
            self._messages.tell_error(SOURCE, _say("The means are not handed over"), error)
            return
        tab = _say("Rate table") if self.state.kind == RATES else _say("Dividing head")
        self._messages.show(
            SOURCE,
            BannerState(
                Severity.INFO,
                _say("Run file written"),
                str(path),
                _say("Load Data of the tab {tab} takes it.").format(tab=tab),
            ),
        )
        self._tell(self.state.kind)

    def _run(self) -> Run:
        what = _say("set rate") if self.state.kind == RATES else _say("position")
        for one, text in zip(self._means, self._given, strict=True):
            if not text:
                raise FormatError(one.record, _say("has no {what} yet").format(what=what))
        if self.state.kind == RATES:
            return means_run(
                self._means, self._device, rates_dps=[number_of(text) for text in self._given]
            )
        return means_run(
            self._means, self._device, positions=[position_of(text) for text in self._given]
        )

    def _tell(self, kind: str) -> None:
        channels = max((one.channels for one in self._means), key=len, default=())
        asked = _say("Set rate, °/s") if kind == RATES else _say("Mount:angle")
        header = (
            _say("Record"),
            asked,
            "n",
            *(f"{c.name}, {c.unit}".rstrip(", ") for c in channels),
        )
        rows = tuple(
            (one.record, given, str(one.n), *_values(one), *[""] * (len(channels) - len(one.mean)))
            for one, given in zip(self._means, self._given, strict=True)
        )
        self.state = replace(
            self.state, header=header, rows=rows, kind=kind, file=self._file() if rows else ""
        )
        self.changed.emit(self.state)

    def _file(self) -> str:
        stem = f"{safe_name(self._device or 'gyro')}_means_{stamp(datetime.now())}"
        return str(_free(lambda end: self._folder / f"{stem}{end}{SUFFIX}"))


def _values(one: RecordMean) -> list[str]:
    return [
        " ± ".join(value_and_uncertainty(float(mean), float(se)))
        for mean, se in zip(one.mean, one.se, strict=True)
    ]


def _free(named: Callable[[str], Path]) -> Path:
    """The first name that no file has."""
    number = 1
    path = named("")
    while path.exists():
        number += 1
        path = named(f"_{number}")
    return path
