"""Calibrations from any file, and the one that was measured nearest to a check."""

from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from core.errors import FormatError
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import write_calibration
from core.records.legacy.reader import read_legacy
from core.records.open_calibration import nearest_calibration, open_calibration
from core.samples.run import Conditions

LEGACY = Path(__file__).parents[2] / "data" / "legacy"
G = Conditions(g_mps2=9.8106)


@pytest.fixture
def positions() -> Path:
    return next(
        path
        for path in sorted(LEGACY.rglob("OpticalDividingHead_*.txt"))
        if read_legacy(path).layout.id == "pointer"
    )


def kept(root: Path, folder: str, device: str, measured: str, path: Path) -> Path:
    made = calibrate(read_legacy(path).to_run(), G)
    provenance = replace(made.provenance, device=device, measured_utc=measured)
    where = root / folder / "calibration.cal.json"
    where.parent.mkdir()
    write_calibration(replace(made, provenance=provenance), where)
    return where


def test_positions_give_the_same_as_their_calibration_file(tmp_path, positions):
    path = kept(tmp_path, "a", "PW09", "2024-05-14T08:00:00+00:00", positions)
    made = open_calibration(positions, lambda _: G)
    read = open_calibration(path, lambda _: Conditions())
    for one, other in zip(made.fits, read.fits, strict=True):
        assert np.array_equal(one.values, other.values)


def test_what_is_no_calibration(tmp_path):
    (tmp_path / "x.json").write_text("{}", encoding="utf-8")
    with pytest.raises(FormatError):
        open_calibration(tmp_path / "x.json", lambda c: c)


def test_the_nearest_of_the_same_device(tmp_path, positions):
    first = kept(tmp_path, "1", "PW09", "2024-05-14T08:00:00+00:00", positions)
    last = kept(tmp_path, "2", "PW09", "2024-06-14T08:00:00+00:00", positions)
    kept(tmp_path, "3", "PW10", "2024-07-01T08:00:00+00:00", positions)
    (tmp_path / "4").mkdir()
    (tmp_path / "4" / "calibration.cal.json").write_text("damaged", encoding="utf-8")
    assert nearest_calibration(tmp_path, "PW09", datetime(2024, 5, 20, tzinfo=UTC)) == first
    assert nearest_calibration(tmp_path, "PW09", datetime(2024, 6, 10, tzinfo=UTC)) == last
    assert nearest_calibration(tmp_path, "PW09", None) == last
    assert nearest_calibration(tmp_path, "PW11", None) is None
