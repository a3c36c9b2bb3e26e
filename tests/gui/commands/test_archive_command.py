"""``calrig archive`` on a folder of sessions."""

import json
from pathlib import Path

import pytest

from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.legacy.reader import read_legacy
from gui.commands.table import REFUSED, run_command
from tests.core.archive.conftest import SPECIMENS, STATED, calibrated, measured


@pytest.fixture(scope="module")
def triad() -> Calibration:
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    return calibrate(run, STATED)


@pytest.fixture
def root(tmp_path: Path, triad: Calibration) -> Path:
    folder = tmp_path / "CalRig"
    for year, bias in ((2023, 0.0), (2025, 30.0)):
        when = f"{year}-03-01T10:00:00+00:00"
        session = measured(folder / f"{year}_PW09", started=when)
        calibrated(triad, session, when=when, bias=bias, temperature_c=25.0 + year - 2023)
    return folder


class Console:
    """Runs a subcommand and keeps what it says."""

    def __init__(self, root: Path, capsys: pytest.CaptureFixture[str]) -> None:
        self._root, self._capsys = root, capsys

    def __call__(self, *arguments: str) -> tuple[int, str, str]:
        code = run_command("archive", [*arguments, "--root", str(self._root)])
        said = self._capsys.readouterr()
        return code, said.out, said.err

    def data(self, *arguments: str):
        return json.loads(self(*arguments, "--json", "-")[1])


@pytest.fixture
def archive(root: Path, capsys: pytest.CaptureFixture[str]) -> Console:
    return Console(root, capsys)


def calibrations(archive: Console) -> list[int]:
    return [one["id"] for one in archive.data("list", "--kind", "calibration")["entries"]]


def test_the_list_is_narrowed_by_words_and_kind(archive: Console) -> None:
    code, out, _ = archive("list", "pw09", "2025")
    assert code == 0
    assert len(out.splitlines()) == 3
    assert "calibration" in out
    assert archive("list", "nobody")[1] == "nothing found\n"
    assert "1 of 4" in archive("list", "--limit", "1")[1]


def test_a_calibration_is_shown_with_its_verdicts(archive: Console, root: Path) -> None:
    (root / "limits.toml").write_text(
        '[[limit]]\nparameter = "bias"\nunit = "code"\nhigh = -360\nchannel = "acc_x"\n', "utf-8"
    )
    latest, first = calibrations(archive)
    assert archive("show", str(first))[1].count("pass") == 1
    out = archive("show", str(latest))[1]
    assert "fail" in out
    assert "acc_x    bias" in out


def test_a_history_tells_scatter_and_wants_the_channel(archive: Console) -> None:
    told = archive.data("history", "PW09", "bias", "--channel", "acc_x")
    assert told["n"] == 2
    assert told["repeatability"] == pytest.approx(30.0 / 2**0.5)
    code, _, err = archive("history", "PW09", "bias")
    assert code == REFUSED
    assert "acc_x, acc_y, acc_z: choose one by --channel" in err
    assert archive("history", "PW09", "smell")[0] == REFUSED
    assert archive("history", "PW09")[0] == REFUSED
    warm = archive.data("history", "PW09", "bias", "--channel=acc_x", "--temperature", "35")
    assert warm["n"] == 0


def test_a_comparison_ends_with_1_where_something_differs(archive: Console) -> None:
    latest, first = map(str, calibrations(archive))
    code, out, _ = archive("compare", latest, first)
    assert code == 1
    assert "1 of 12 differ by more than 2 u" in out
    assert out.splitlines()[2].split()[:3] == ["acc_x", "bias", "differs"]
    assert archive("compare", first, first)[0] == 0
    code, _, err = archive("compare", first)
    assert code == REFUSED
    assert "numbers of 2 entries" in err


def test_the_nearest_calibration_is_named(archive: Console) -> None:
    found = archive.data("nearest", "PW09", "--date", "2023-03-05", "--temperature", "25")
    assert found[0]["entry"]["measured"].startswith("2023")
    assert archive("nearest", "PW99")[0] == 1


def test_folders_are_imported_and_the_index_made_anew(archive: Console, root: Path) -> None:
    code, out, _ = archive("import", str(SPECIMENS))
    assert code == 0
    assert out.splitlines()[-1] == "6 taken, 1 not known"
    assert "6 already there" in archive("import", str(SPECIMENS))[1]
    (root / "2023_PW09" / "calibration.cal.json").write_text("{", "utf-8")
    out = archive("rebuild")[1]
    assert "10 entries" in out
    assert "damaged: 2023_PW09/calibration.cal.json" in out


def test_a_simulated_session_is_decoded_again_to_the_same_means(
    archive: Console, root: Path
) -> None:
    arguments = ["pointer", str(root / "simulated"), "--accumulation", "1"]
    assert run_command("simulate", arguments) == 0
    archive("list")  # takes what the simulation has printed
    hits = archive.data("list", "simulated", "--kind", "session")
    number = str(hits["entries"][0]["id"])
    code, out, _ = archive("reprocess", number)
    assert code == 0
    assert out.splitlines()[-1] == "8 of 8 the same"
    assert archive("reprocess", number, "--profiles")[0] == 0
    record = archive.data("list", "--kind", "record")
    assert record["total"] == 0, "a log in its session's folder is part of the session"
    calibration = str(calibrations(archive)[0])
    assert "only sessions have raw bytes" in archive("reprocess", calibration)[2]


def test_a_folder_that_is_not_there_is_told(tmp_path: Path) -> None:
    assert run_command("archive", ["list", "--root", str(tmp_path / "none")]) == REFUSED
