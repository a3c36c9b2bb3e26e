"""From measurements of gyros to their results with a page; runs in a worker thread."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core.errors import FitError, Note, Severity, StorageError
from core.fit.estimate import Estimate
from core.procedures.added import NOTHING, Added
from core.procedures.calibration import Calibration
from core.procedures.g_sensitivity import GSensitivity, fit_g_sensitivity
from core.procedures.rate_and_head import fit_rate_and_head
from core.procedures.rate_calibration import calibration_of
from core.procedures.rate_table import RateTable, calibrate_rate_table
from core.procedures.two_files import Pair, Table37, calibrated_by_3_10, compare_runs
from core.records.calibration_json import write_calibration
from core.samples.run import Conditions, Run
from core.units import DPH_PER_DPS
from gui.measuring.added_table import added_names, added_table
from gui.measuring.loading import Choice, load
from gui.measuring.nominal import FILE
from gui.measuring.page import Part, ResultsPage
from gui.rate_table.guide import ON_HEAD, ON_TABLE
from gui.rate_table.settings import RateSettings
from gui.rate_table.tables import (
    error_plot,
    g_table,
    joint_table,
    measured_table,
    parameter_table,
    positions_table,
    straightness_table,
    summary_table,
    table_3_7,
    table_3_7_plot,
)

_NEGATIVE = "negative_scale_factor"
_ALONE = Note(
    Severity.INFO,
    "apart",
    "table and head run are not fitted together while effects are added: they were found in one of"
    " them alone",
)


@dataclass(frozen=True, slots=True, eq=False)
class Measured:
    """A run and where it came from.

    Parameters
    ----------
    run : on the table, or of static positions
    source : session or file
    """

    run: Run
    source: str


@dataclass(frozen=True, slots=True, eq=False)
class RateResult:
    """What processing gives.

    Parameters
    ----------
    page : what is shown
    table, head : the runs that it was made of, None where there is none
    latest : the run that came last
    calibration : what the exports take
    refused : why the two runs are not used together; empty if they are, or one is missing
    dph_per_unit : deg/h of one unit of output, by the role of the channel
    """

    page: ResultsPage
    table: Measured | None
    head: Measured | None
    latest: Measured
    calibration: Calibration
    refused: str
    dph_per_unit: Mapping[str, float]


@dataclass(frozen=True, slots=True, eq=False)
class Work:
    """What is to be processed.

    Parameters
    ----------
    latest : the run that came last
    table, head : runs that are there from before
    settings : of the operator
    same_unit : the operator's word that table and head run are of one unit
    added : effects beyond the plain model of the run that came last
    """

    latest: Measured
    table: Measured | None
    head: Measured | None
    settings: RateSettings
    same_unit: bool = False
    added: Added = NOTHING

    def result(self) -> RateResult:
        """Fit what is there; raises `FitError`."""
        on_table = self.latest.run.test == ON_TABLE
        table, head = (self.latest, self.head) if on_table else (self.table, self.latest)
        return _Fitted(self, table, head).result()


def of_session(folder: Path, work: Work) -> RateResult:
    """Process a session; its calibration is kept in its folder."""
    result = work.result()
    try:
        write_calibration(result.calibration, folder / FILE)
    except StorageError as error:
        note = Note(Severity.WARNING, "not_kept", f"the calibration was not kept: {error}")
        result = replace(result, page=replace(result.page, parts=(note, *result.page.parts)))
    return result


def of_file(
    path: Path,
    device: str | None,
    mounts: Sequence[str] | None,
    table: Measured | None,
    head: Measured | None,
    settings: RateSettings,
) -> RateResult | Choice:
    """Process what a file holds.

    Raises
    ------
    FormatError, FitError
        The file is refused, or holds something else.
    """
    run = load(path, device, mounts, "gyro")
    if isinstance(run, Choice):
        return run
    if run.sensor != "gyro" or run.test not in (ON_TABLE, ON_HEAD):
        raise FitError(
            f"{path.name} holds a {run.sensor} in the test {run.test!r}; here are gyros on the"
            " rate table, or at rest on the dividing head"
        )
    return Work(Measured(run, path.name), table, head, settings).result()


class _Fitted:
    """The fits of one work, and the page of them."""

    def __init__(self, work: Work, table: Measured | None, head: Measured | None) -> None:
        self._work = work
        self._table, self._head = table, head
        settings = work.settings
        self._rates: RateTable | None = None
        self._at_rest: GSensitivity | None = None
        self._pairs: dict[str, Pair] = {}
        if table is not None:
            self._rates = calibrate_rate_table(
                table.run,
                _stated(table.run.conditions, settings.conditions()),
                full_scale_dps=settings.full_scale_dps or None,
            )
        if head is not None:
            self._at_rest = self._fit_head(head.run, self._slopes())
        self._compare()
        self.refused = (
            ""
            if work.same_unit
            else " ".join(
                dict.fromkeys(
                    note.text
                    for pair in self._pairs.values()
                    for note in pair.notes
                    if note.severity is Severity.ERROR
                )
            )
        )
        if self.refused and head is not None:
            # Scale factors of another unit say nothing of this one.
            self._at_rest = self._fit_head(head.run, {})
        self._joint = self._fit_both()

    def result(self) -> RateResult:
        latest = self._work.latest
        title = f"{latest.run.device}, {len(latest.run)} " + (
            "rates" if latest.run.test == ON_TABLE else "positions"
        )
        if self._joint is not None:
            calibration = self._joint.calibration()
        elif latest.run.test == ON_TABLE and self._rates is not None:
            calibration = calibration_of(self._rates, latest.run, self._work.added)
        elif self._at_rest is not None:
            calibration = self._at_rest.calibration()
        else:
            raise FitError("there is nothing to process")
        parts = self._parts()
        bent = added_table(calibration)
        if bent is not None:
            parts.insert(0, bent)
        return RateResult(
            page=ResultsPage(title, latest.source, tuple(parts), effects=added_names(calibration)),
            table=self._table,
            head=self._head,
            latest=latest,
            calibration=_with_source(calibration, latest.run),
            refused=self.refused,
            dph_per_unit=self._dph_per_unit(),
        )

    def _slopes(self) -> dict[str, Estimate]:
        return {} if self._rates is None else {s.channel: s.line.slope for s in self._rates.sensors}

    def _fit_head(self, run: Run, slopes: Mapping[str, Estimate]) -> GSensitivity:
        settings = self._work.settings
        conditions = _stated(run.conditions, settings.conditions())
        added = self._work.added if run is self._work.latest.run else NOTHING
        return fit_g_sensitivity(run, conditions, settings.site(), slopes, added)

    def _compare(self) -> None:
        if self._rates is None or self._at_rest is None:
            return
        if self._table is None or self._head is None:
            return
        on_head = {sensor.channel: sensor for sensor in self._at_rest.sensors}
        for sensor in self._rates.sensors:
            other = on_head.get(sensor.channel)
            if other is not None and self._table.run.unit == self._head.run.unit:
                self._pairs[sensor.channel] = compare_runs(
                    self._table.run, sensor, self._head.run, other
                )

    def _fit_both(self) -> GSensitivity | None:
        """(3.3) of both runs, where they are of one unit."""
        if self._table is None or self._head is None or not self._pairs or self.refused:
            return None
        if self._work.added:
            return None
        settings = self._work.settings
        return fit_rate_and_head(
            self._table.run,
            self._head.run,
            _stated(self._table.run.conditions, settings.conditions()),
            settings.site(),
            same_unit=self._work.same_unit,
        )

    def _tables_3_7(self) -> dict[str, Table37]:
        if self._joint is None or self._rates is None or self._at_rest is None:
            return {}
        if self._table is None or self._head is None:
            return {}
        return {
            channel: calibrated_by_3_10(
                self._table.run,
                self._rates.sensor(channel),
                self._head.run,
                self._at_rest.sensor(channel),
                same_unit=self._work.same_unit,
            )
            for channel in self._pairs
        }

    def _parts(self) -> list[Part]:
        parts: list[Part] = []
        of_table = self._of_table()
        of_head = self._of_head()
        latest_on_table = self._work.latest.run.test == ON_TABLE
        parts += [*of_table, *of_head] if latest_on_table else [*of_head, *of_table]
        if self._joint is not None:
            joint = [joint_table(self._joint), *self._joint.notes]
            joint += [note for sensor in self._joint.sensors for note in sensor.notes]
            tables = self._tables_3_7()
            parts = [*joint, *parts, table_3_7(tables), table_3_7_plot(tables)]
        else:
            pair_notes = [note for pair in self._pairs.values() for note in pair.notes]
            if self._work.added and self._pairs:
                pair_notes.append(_ALONE)
            parts = [*pair_notes, *parts]
        return _without_repeats(parts)

    def _of_table(self) -> list[Part]:
        rates, table = self._rates, self._table
        if rates is None or table is None:
            return []
        of_sensors = [note for sensor in rates.sensors for note in sensor.notes]
        notes = [*rates.notes, *_gathered(of_sensors)]
        return [
            summary_table(rates),
            *notes,
            error_plot(rates),
            straightness_table(rates),
            parameter_table(calibration_of(rates, table.run, self._added_to(table))),
            measured_table(rates, table.run),
        ]

    def _added_to(self, one: Measured) -> Added:
        return self._work.added if one is self._work.latest else NOTHING

    def _of_head(self) -> list[Part]:
        found, head = self._at_rest, self._head
        if found is None or head is None:
            return []
        notes = [*found.notes, *(note for sensor in found.sensors for note in sensor.notes)]
        return [g_table(found), *notes, positions_table(found, head.run)]

    def _dph_per_unit(self) -> Mapping[str, float]:
        return {
            _role_of(channel): DPH_PER_DPS / abs(slope.value)
            for channel, slope in self._slopes().items()
            if slope.value
        }


def _stated(of_run: Conditions, of_screen: Conditions) -> Conditions:
    """What the operator states; what a run states where the screen says nothing."""
    names = ("g_mps2", "u_g_mps2", "latitude_deg", "accumulation_s", "sample_rate_hz")
    said = {name: getattr(of_screen, name) for name in names}
    return replace(
        of_screen,
        **{
            name: getattr(of_run, name)
            for name, value in said.items()
            if not np.isfinite(value) or name in ("accumulation_s", "sample_rate_hz")
        },
    )


def _with_source(calibration: Calibration, run: Run) -> Calibration:
    source_file, sha256 = run.meta.get("source"), run.meta.get("source_sha256")
    if calibration.provenance.records or not source_file or not sha256:
        return calibration
    records = ((str(source_file), str(sha256)),)
    return replace(calibration, provenance=replace(calibration.provenance, records=records))


def _without_repeats(parts: Sequence[Part]) -> list[Part]:
    """The parts with every doubt said once."""
    seen: set[str] = set()
    kept: list[Part] = []
    for part in parts:
        if isinstance(part, Note):
            if part.text in seen:
                continue
            seen.add(part.text)
        kept.append(part)
    return kept


def _gathered(notes: Sequence[Note]) -> list[Note]:
    """What is legal and the same in many sensors is said in one line."""
    negative = [note for note in notes if note.subject == _NEGATIVE]
    if len(negative) < 2:
        return list(notes)
    names = ", ".join(note.text.partition(":")[0] for note in negative)
    one = Note(
        Severity.INFO,
        _NEGATIVE,
        f"{names}: the scale factors are negative, which is legal; the outputs fall when the unit"
        " turns counter-clockwise seen from above",
    )
    return [*(note for note in notes if note.subject != _NEGATIVE), one]


def _role_of(channel: str) -> str:
    """``gyro_x`` -> ``rate.x``; an assembly's ``gyro_3`` -> ``adc.3``."""
    which = channel.rpartition("_")[2]
    return f"adc.{which}" if which.isdecimal() else f"rate.{which}"
