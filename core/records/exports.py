"""Calibrations for other programs: one table of formats.

export_c
    C header for firmware.
export_mat
    MATLAB file.
export_csv
    Tables for spreadsheets, in both locales.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from core.procedures.calibration import Calibration
from core.records.atomic import write_bytes_atomic
from core.records.calibration_json import calibration_text
from core.records.export_c import header_text
from core.records.export_csv import csv_text, excel_text
from core.records.export_mat import mat_bytes
from core.records.names import safe_name


@dataclass(frozen=True, slots=True)
class Export:
    """One format.

    Parameters
    ----------
    title : for menus
    suffix : end of the file's name
    content : calibration -> bytes of the file
    """

    title: str
    suffix: str
    content: Callable[[Calibration], bytes]


EXPORTS: Mapping[str, Export] = {
    "json": Export(
        "JSON with covariance and provenance",
        ".cal.json",
        lambda calibration: calibration_text(calibration).encode(),
    ),
    "c": Export("C header", ".h", lambda calibration: header_text(calibration).encode()),
    "mat": Export("MATLAB file", ".mat", mat_bytes),
    "csv": Export("CSV", ".csv", lambda calibration: csv_text(calibration).encode()),
    "excel": Export(
        "CSV with decimal comma, for Excel",
        ".excel.csv",
        lambda calibration: excel_text(calibration).encode("utf-8-sig"),
    ),
}
"""Every format, by identifier."""


def export(calibration: Calibration, kind: str, path: Path) -> None:
    """Write a calibration in the format `kind`, replacing `path`.

    Raises
    ------
    KeyError
        There is no such format.
    StorageError
        The file cannot be written.
    """
    write_bytes_atomic(path, EXPORTS[kind].content(calibration))


def proposed_name(calibration: Calibration, kind: str) -> str:
    """File name to propose: device, sensor and the format's suffix."""
    device = safe_name(calibration.provenance.device)
    return f"{device}_{calibration.sensor}{EXPORTS[kind].suffix}"
