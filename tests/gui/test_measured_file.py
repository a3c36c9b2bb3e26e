"""Files of every kind become results for a certificate."""

from pathlib import Path

import pytest

from core.errors import FormatError
from core.records.calibration_json import write_calibration
from core.samples.run import Conditions
from gui.measured_file import measured_of_file

pytestmark = pytest.mark.usefixtures("qapp")
SPECIMENS = Path(__file__).parents[1] / "data" / "legacy"


@pytest.mark.parametrize(
    ("name", "device"),
    [
        ("OpticalDividingHead_202405131405.txt", None),
        ("OpticalDividingHead_202405140930.txt", None),
        ("RotationTable_202405151000.txt", None),
        ("Accuracy_202405141110.txt", None),
    ],
)
def test_old_files_are_processed_as_in_their_tabs(name: str, device: str | None):
    measured = measured_of_file(SPECIMENS / name, Conditions(), device)
    assert measured.provenance.device
    assert measured.provenance.records[0][0] == name
    assert {str(part["kind"]) for part in measured.printed} >= {"table"}
    assert (measured.calibration is None) is name.startswith("Accuracy")


def test_a_calibration_that_was_kept_gives_the_same_parameters(tmp_path: Path):
    path = SPECIMENS / "OpticalDividingHead_202405140930.txt"
    whole = measured_of_file(path, Conditions())
    assert whole.calibration is not None
    kept = tmp_path / "kept.cal.json"
    write_calibration(whole.calibration, kept)
    again = measured_of_file(kept, Conditions())
    assert again.coverage == whole.coverage
    titles = {str(part.get("title")) for part in whole.printed}
    tables = {str(part["title"]) for part in again.printed if part["kind"] == "table"}
    assert tables <= titles


def test_what_the_laboratory_states_counts_where_the_file_is_silent():
    path = SPECIMENS / "OpticalDividingHead_202405140930.txt"
    stated = measured_of_file(path, Conditions(g_mps2=9.82, u_g_mps2=0.001))
    assert stated.conditions.g_mps2 == 9.82
    assert measured_of_file(path, Conditions()).conditions.g_mps2 == 9.8106


def test_what_is_no_result_is_refused(tmp_path: Path):
    bad = tmp_path / "notes.txt"
    bad.write_text("nothing here", encoding="utf-8")
    with pytest.raises(FormatError):
        measured_of_file(bad, Conditions())
    settings = tmp_path / "settings.json"
    settings.write_text("{}", encoding="utf-8")
    with pytest.raises(FormatError, match="is no calrig-calibration"):
        measured_of_file(settings, Conditions())
