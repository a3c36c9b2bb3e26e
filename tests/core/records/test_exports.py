from dataclasses import replace

import pytest

from core.errors import StorageError
from core.records.calibration_json import read_calibration
from core.records.exports import EXPORTS, export, proposed_name


@pytest.mark.parametrize("kind", EXPORTS)
@pytest.mark.parametrize("name", ["triad", "single"])
def test_every_format_is_written_whole(kind, name, request, tmp_path):
    path = tmp_path / "a"
    path.write_text("old")
    export(request.getfixturevalue(name), kind, path)
    assert path.stat().st_size > 200
    assert list(tmp_path.iterdir()) == [path]
    nowhere = tmp_path / "none" / "a"
    with pytest.raises(StorageError, match="choose another folder"):
        export(request.getfixturevalue(name), kind, nowhere)


def test_the_json_export_is_a_calibration(triad, tmp_path):
    export(triad, "json", tmp_path / "a")
    assert read_calibration(tmp_path / "a").channels == triad.channels


def test_names_are_proposed(triad):
    assert proposed_name(triad, "c") == "PW09_accelerometer.h"
    wild = replace(triad, provenance=replace(triad.provenance, device="../PW 09"))
    assert proposed_name(wild, "json") == "PW_09_accelerometer.cal.json"
    assert len({proposed_name(triad, kind) for kind in EXPORTS}) == len(EXPORTS)
