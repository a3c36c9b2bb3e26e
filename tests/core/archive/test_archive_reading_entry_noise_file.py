"""What each reader makes of its files."""

from collections.abc import Callable
from pathlib import Path

import pytest

from core.archive.entry import BAD, DAMAGED, DOUBT, GOOD, Entry, Found, judged, mean_of
from core.archive.noise_file import HEADER, is_noise_file, parse_noise
from core.archive.reading import moment, read_file
from core.errors import FormatError, Note, Severity
from core.procedures.calibration import Calibration
from core.records.legacy.reader import read_legacy
from core.records.noise_exports import coefficients_csv
from core.records.noise_study import StudyRequest, study
from core.records.run_file import write_run
from core.records.series_text import parse_text_series
from tests.core.archive.conftest import SPECIMENS, calibrated, measured
from tests.core.records.noise_records import gyro_noise

INFO, WARNING, ERROR = (
    Note(severity, "s", severity.value)
    for severity in (Severity.INFO, Severity.WARNING, Severity.ERROR)
)


def only(path: Path) -> Found:
    (found,) = read_file(path, {})
    return found


def test_the_worst_note_is_the_verdict() -> None:
    assert judged([INFO]) == (GOOD, "")
    assert judged([INFO, WARNING, INFO]) == (DOUBT, "warning")
    assert judged([WARNING, ERROR, WARNING]) == (BAD, "error")
    assert judged([], "finished") == ("finished", "")


def test_a_mean_passes_over_what_was_not_measured() -> None:
    assert mean_of([1.0, float("nan"), 3.0]) == 2.0
    assert str(mean_of([])) == "nan"


def test_a_moment_is_told_in_utc() -> None:
    assert moment("2024-05-14T09:30:05.7+03:00") == "2024-05-14T06:30:05+00:00"
    assert moment("2024-05-14T09:30:05") == ""
    assert moment("") == ""


def test_a_calibration_in_its_session_knows_who_measured(
    tmp_path: Path, triad: Calibration
) -> None:
    folder = measured(tmp_path / "s", operator="Олена")
    found = only(calibrated(triad, folder))
    assert (found.entry.kind, found.entry.operator, found.entry.count) == (
        "calibration",
        "Олена",
        3,
    )
    names = [(quantity.channel, quantity.name) for quantity in found.quantities[:2]]
    assert names == [("acc_x", "bias"), ("acc_x", "scale_factor")]
    assert only(folder).entry.kind == "session"


def test_every_old_file_of_the_practicum_is_known(
    tmp_path: Path, specimens: Callable[[Path], list[Path]]
) -> None:
    found = {path.name: only(path).entry for path in specimens(tmp_path)}
    assert {entry.what for entry in found.values()} == {
        "clbacc",
        "pointer",
        "clbdus_head",
        "rotation_table",
        "accuracy",
        "accuracy_15",
    }
    clbacc = found["OpticalDividingHead_202405131405.txt"]
    assert (clbacc.serial, clbacc.count, clbacc.temperature_c) == ("Colibrys", 4, 27.0)
    assert clbacc.measured.startswith("2024-05-13T")


def test_a_file_of_two_devices_gives_two_entries(tmp_path: Path) -> None:
    lines = (SPECIMENS / "OpticalDividingHead_202405131405.txt").read_text("utf-8")
    path = tmp_path / "OpticalDividingHead_202405131405.txt"
    path.write_text(lines + lines.replace("Colibrys", "Colibrys2"), "utf-8")
    parts = [found.entry.part for found in read_file(path, {})]
    assert parts == ["Colibrys", "Colibrys2"]


def test_a_run_file_is_known_by_its_head(tmp_path: Path) -> None:
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    write_run(run, tmp_path / "a.run.csv")
    write_run(run, tmp_path / "renamed.csv")
    one, other = only(tmp_path / "a.run.csv"), only(tmp_path / "renamed.csv")
    assert one.entry.kind == other.entry.kind == "run"
    assert (one.entry.serial, one.entry.count) == ("PW09", 8)


def test_records_of_cvgcom_are_known_by_name_and_not_read(tmp_path: Path) -> None:
    path = tmp_path / "25-143.exp(007)_s_pr1.txt"
    path.write_bytes(b"FileVersion 1\nwhatever follows, for hours\n")
    found = only(path).entry
    assert (found.kind, found.serial, found.what) == ("record", "25-143", "static")


def test_means_name_their_devices(tmp_path: Path) -> None:
    path = tmp_path / "means.dat"
    lines = [
        "25-143.exp(001)_s_pr1.txt\t1.0 2.0",
        "25-143.exp(002)_s_pr1.txt\t1.0 2.0",
        "7\t1 2",
    ]
    path.write_text("\n".join(lines), "utf-8")
    found = [(one.entry.serial, one.entry.count) for one in read_file(path, {})]
    assert found == [("25-143", 2), ("7", 1)]


def noise() -> str:
    values = gyro_noise(20_000, 20.0, (0.02, 0.0125, 3e-4), 1)
    text = "t,GyroOut\n" + "".join(f"{i / 20.0:.3f},{v:.9f}\n" for i, v in enumerate(values))
    series = parse_text_series(text, "25-143.csv")
    return coefficients_csv([study(series, StudyRequest(unit="deg/s"))])


def test_coefficients_of_an_allan_analysis_become_quantities(tmp_path: Path) -> None:
    table = noise()
    path = tmp_path / "noise.csv"
    path.write_text(table, "utf-8")
    found = only(path)
    assert (found.entry.kind, found.entry.sensor) == ("noise", "gyro")
    by_name = {quantity.name: quantity for quantity in found.quantities}
    n = by_name["random_walk"]
    assert n.value == pytest.approx(0.02, rel=0.1)
    assert n.unit == "deg/sqrt(s)"
    assert n.u > 0.0
    assert is_noise_file(table)
    with pytest.raises(FormatError, match="line 2"):
        parse_noise(table.replace(f"{n.value!r}", "many", 1), "x")


def test_what_is_not_ours_is_passed_over_and_what_is_ours_is_told(tmp_path: Path) -> None:
    for name in ("readme.txt", "picture.png", "settings.json", "big.csv"):
        (tmp_path / name).write_text("hello\n", "utf-8")
        assert read_file(tmp_path / name, {}) == ()
    broken = tmp_path / "RotationTable_202405151000.txt"
    broken.write_text("hello\n", "utf-8")
    assert only(broken).entry.verdict == DAMAGED
    (tmp_path / "s").mkdir()
    (tmp_path / "s" / "session.json").write_text("{", "utf-8")
    assert only(tmp_path / "s").entry.verdict == DAMAGED


def test_further_suffixes_are_read_by_whom_it_may_concern(tmp_path: Path) -> None:
    path = tmp_path / "x.calrec"
    path.write_bytes(b"")
    found = read_file(path, {".calrec": lambda one: (Found(Entry("record", "", one.stem)),)})
    assert found[0].entry.serial == "x"
    assert found[0].entry.measured


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ('G1,y,random_walk,N,likelihood,N,deg/s,1.0,0.1,0.9,1.1,"a\rb', "no line of coefficients"),
        ("G1,y,random_walk,N,likelihood,N,deg/s,1.0,0.1,0.9,1.1,\rb", "is no table"),
        ("G1,y,random_walk,N,likelihood,N,deg/s,1.0,0.1,0.9,1.1", "no line of coefficients"),
    ],
)
def test_a_torn_table_of_noise_is_told(line: str, why: str) -> None:
    with pytest.raises(FormatError, match=why):
        parse_noise(f"{HEADER}file\n{line}\n", "noise.csv")
