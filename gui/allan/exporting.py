"""What can be exported: the plot as a picture, the results as files for other programs."""

from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from core.errors import FitError
from core.records.atomic import make_folder
from core.records.names import safe_name, stamp
from core.records.noise_exports import NOISE_EXPORTS, export_noise
from core.records.noise_study import NoiseStudy
from gui.exporting import ExportFormat, pictures

Studies = tuple[NoiseStudy, ...]
"""Of the records that are shown; none while there is only a live curve, which is drawn alone."""


def formats(draw: Callable[[Path], None]) -> tuple[ExportFormat, ...]:
    """The formats; `draw` writes the plot."""
    plot = QCoreApplication.translate("Allan", "Plot, {suffix}")
    return (
        *pictures(plot, _stem, lambda _, path: draw(path)),
        *(_file(key) for key in NOISE_EXPORTS),
    )


def _file(key: str) -> ExportFormat:
    def write(studies: Studies, path: Path) -> None:
        if not studies:
            raise FitError("no analysed record is shown; analyse a record first")
        make_folder(path.parent)
        export_noise(studies, key, path)

    kind = NOISE_EXPORTS[key]
    stem = _imu if key == "kalibr" else _stem
    return ExportFormat(key, kind.title, lambda studies: f"{stem(studies)}{kind.suffix}", write)


def _stem(studies: Studies) -> str:
    return f"Allan_{_devices(studies)}_{stamp(datetime.now())}"


def _imu(studies: Studies) -> str:
    return f"imu_{_devices(studies)}"


def _devices(studies: Studies) -> str:
    names = dict.fromkeys(study.device for study in studies)
    return "_".join(safe_name(name) for name in names) if 0 < len(names) < 4 else "devices"
