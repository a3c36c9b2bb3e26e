"""A legacy text file as it stands on disk, and as a run."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import PurePath

import numpy as np

from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.errors import FormatError, Note, Severity
from core.records.legacy.layout import LegacyLayout
from core.records.legacy.mounts import mounts_by_number, mounts_by_passes
from core.records.names import stamp_of
from core.records.replicates import replicates
from core.samples.run import Run


@dataclass(frozen=True, slots=True, eq=False)
class LegacyFile:
    """All rows and all columns of a legacy file.

    Parameters
    ----------
    path : where it was read
    layout : what its columns are
    devices : (n,) device name of each row
    values : (n, layout.width - 1) columns 2, 3, ...
    lines : (n,) line of each row in the file, 1-based
    sha256 : of the file's bytes; empty if it was not read from one
    unit : unit of the outputs
    """

    path: str
    layout: LegacyLayout
    devices: tuple[str, ...]
    values: FloatArray
    lines: IntArray
    sha256: str = ""
    unit: str = "code"

    def __len__(self) -> int:
        return len(self.devices)

    def column(self, name: str) -> FloatArray:
        """Numbers (n,) of the column of this name."""
        return self.values[:, self.layout.index(name)]

    def of_device(self, device: str | None) -> "LegacyFile":
        """The rows of one device.

        Raises
        ------
        FormatError
            The file holds rows of several devices and none was named, or not of this one.
        """
        names = list(dict.fromkeys(self.devices))
        if device is None:
            if len(names) > 1:
                raise FormatError(
                    self.path,
                    f"holds rows of {len(names)} devices ({', '.join(names)}): say which one",
                )
            return self
        chosen = [i for i, name in enumerate(self.devices) if name == device]
        if not chosen:
            raise FormatError(self.path, f"holds no rows of {device!r}, only of {', '.join(names)}")
        return replace(
            self,
            devices=(device,) * len(chosen),
            values=frozen(self.values[chosen]),
            lines=frozen_int(self.lines[chosen]),
        )

    def to_run(
        self,
        *,
        sensor: str | None = None,
        device: str | None = None,
        mounts: Sequence[str] | None = None,
    ) -> Run:
        """Return the rows of one device as a run.

        Outputs that are zero in every row (unused places of an assembly) are left out; the writer
        puts the zeros back. All other columns go to `extra`: the temperatures in codes, the other
        sensors' outputs, the angles that an attitude unit computed, ``step`` (position or rate
        number as operators count it, from 1).

        Parameters
        ----------
        sensor : ``"accelerometer"`` or ``"gyro"``; None for the one that the file was made for
        device : which device, needed if the file holds several
        mounts : ClbAcc files: how the unit stood, see `mounts_by_passes`

        Raises
        ------
        FormatError
            The file holds no such sensor or device, nothing was measured, or the mounts stay
            unknown.
        """
        file = self.of_device(device)
        layout = file.layout
        sensor = sensor or layout.sensor
        if sensor not in layout.outputs:
            raise FormatError(file.path, f"{layout.title} holds no {sensor}")
        if mounts is not None and not layout.has("head angle"):
            raise FormatError(
                file.path, f"mounts are given, but the numbers of {layout.title} already tell them"
            )
        used = [
            (name, axis)
            for name, axis in zip(layout.outputs[sensor], layout.axes[sensor], strict=True)
            if np.any(file.column(name))
        ]
        if not used and not _tells_angles(file):
            raise FormatError(file.path, f"every {sensor} output is zero: nothing was measured")
        by_row, angles, notes = _positions(file, mounts)
        temperatures, rates = _set_values(file, "set temperature"), _set_values(file, "set rate")
        n = len(file)
        y = frozen(np.array([file.column(name) for name, _ in used]).reshape(len(used), n).T)
        start = stamp_of(file.path)
        return Run(
            test=layout.test[sensor],
            sensor=sensor,
            device=file.devices[0],
            channels=tuple(name for name, _ in used),
            axes=tuple(axis for _, axis in used),
            unit=file.unit,
            y=y,
            y_se=frozen(np.full_like(y, np.nan)),
            run=_passes(file, list(zip(by_row, angles, temperatures, rates, strict=True))),
            order=frozen_int(np.arange(n)),
            mount=tuple(by_row),
            head_deg=frozen(angles),
            set_rate_dps=frozen(rates),
            temperature_c=frozen(temperatures),
            t_s=frozen(np.full(n, np.nan)),
            extra=_extra(file, {name for name, _ in used}),
            meta={
                "legacy_layout": layout.id,
                "source": PurePath(file.path).name,
                "source_sha256": file.sha256,
                **({"start_local": start.isoformat(timespec="minutes")} if start else {}),
            },
            notes=notes,
        )


def _tells_angles(file: LegacyFile) -> bool:
    """Whether there are the unit's own angles to judge, as of one that sends no raw codes."""
    return any(
        column.name.startswith("unit_") and np.any(file.column(column.name))
        for column in file.layout.columns
    )


def _positions(
    file: LegacyFile, mounts: Sequence[str] | None
) -> tuple[list[str], FloatArray, tuple[Note, ...]]:
    layout = file.layout
    if layout.has("head angle"):
        by_row, notes = mounts_by_passes(
            file.path,
            file.column("set temperature"),
            file.column("head angle"),
            file.lines,
            mounts,
        )
        return by_row, file.column("head angle"), notes
    if not layout.plan:
        return [""] * len(file), np.full(len(file), np.nan), ()
    numbers = file.column("position number")
    by_row, angles = mounts_by_number(numbers, layout.plan)
    inferred = sorted({mount for mount in by_row if mount.endswith("_to")})
    notes = (
        (
            Note(
                Severity.INFO,
                "mount_inferred",
                f"{file.path}: positions 5 to 12 of Pointer are not described in the practicum;"
                f" they are taken as {' and '.join(inferred)}",
            ),
        )
        if inferred
        else ()
    )
    return by_row, np.array(angles), notes


def _passes(file: LegacyFile, keys: list[tuple[str, float, float, float]]) -> IntArray:
    """Replicates of the same position; an accuracy check tells none."""
    return frozen_int([1] * len(file)) if file.layout.has("row number") else replicates(keys)


def _set_values(file: LegacyFile, name: str) -> FloatArray:
    if file.layout.has(name):
        return file.column(name)
    return np.full(len(file), np.nan)


_STRUCTURE = ("set temperature", "head angle", "set rate")
_NUMBERS = ("position number", "rate number", "row number")


def _extra(file: LegacyFile, used: set[str]) -> dict[str, FloatArray]:
    """The columns that are neither outputs looked at, nor structure, nor unused."""
    layout = file.layout
    extra: dict[str, FloatArray] = {}
    for column in layout.columns:
        name = column.name
        if name in _NUMBERS and not layout.has("head angle"):
            extra["step"] = frozen(file.column(name) + 1.0)
        elif name not in used and name not in _STRUCTURE and name not in _NUMBERS:
            values = file.column(name)
            if np.any(values):
                extra[name] = frozen(values)
    return extra
