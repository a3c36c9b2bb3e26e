"""The same archive in PostgreSQL: one database for several rigs."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from sqlalchemy import create_engine, text

from core.archive.nearest import nearest
from core.archive.place import Place, place_of, save_place
from core.archive.store import Archive
from core.errors import StorageError
from core.procedures.calibration import Calibration
from tests.core.archive.conftest import calibrated, measured
from tests.core.archive.test_archive_database import FILLER, ROOT, V1
from tests.postgres_server import PostgresServer


@pytest.fixture
def url(postgres: PostgresServer) -> str:
    return postgres.url()


def test_it_is_filled_searched_and_built_anew(root: Path, triad: Calibration, url: str) -> None:
    measured(root / "s")
    calibrated(triad, root / "s", when="2024-05-14T06:30:05+00:00")
    with Archive(root, url) as archive:
        assert archive.refresh().taken == 2
        assert archive.refresh().taken == 0
        hits = archive.search("ОЛЕНА pw09")
        assert [entry.kind for entry in hits.entries] == ["calibration", "session"]
        calibration = hits.entries[0]
        quantities = archive.quantities(calibration)
        fit = triad.fits[0]
        assert [q.value for q in quantities[: len(fit.values)]] == fit.values.tolist()
        assert [q.u for q in quantities[: len(fit.values)]] == fit.stderr.tolist()
        assert archive.readings("PW09", "bias", "acc_x")[0].entry == calibration
        when = calibration.when
        assert when is not None
        assert nearest(archive, "PW09", when)[0].entry == calibration
        shutil.rmtree(root / "s")
        assert archive.refresh().removed == 2
        assert archive.rebuild().taken == 0
    assert not (root / "archive.db").exists()


def test_rigs_share_it_and_do_not_meet_in_their_paths(
    tmp_path: Path, triad: Calibration, url: str
) -> None:
    here, there = tmp_path / "here", tmp_path / "there"
    for folder, device in ((here, "PW09"), (there, "PW10")):
        calibrated(triad, folder / "a", device=device)
        place = place_of(folder)
        save_place(Place(folder, place.id, folder.name, url))
    with Archive(here) as one, Archive(there) as other:
        one.refresh()
        other.refresh()
        assert {entry.serial for entry in one.search().entries} == {"PW09", "PW10"}
        theirs = one.search("PW10").entries[0]
        with pytest.raises(StorageError, match="stands at the rig there, in its folder"):
            one.path_of(theirs)
        assert other.path_of(theirs).exists()
        assert len(one.quantities(theirs)) == 12
        one.rebuild()
        assert one.search().total == 2, "the other rig's entries are not ours to forget"


def test_two_programs_at_once_neither_double_nor_lose(
    root: Path, triad: Calibration, url: str
) -> None:
    for number in range(5):
        calibrated(triad, root / f"s{number}")
    save_place(Place(root, place_of(root).id, "rig", url))
    command = [sys.executable, "-c", FILLER, str(root), "5"]
    both = [
        subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True) for _ in range(2)
    ]
    for one in both:
        one.communicate(timeout=60)
        assert one.returncode == 0
    with Archive(root) as archive:
        archive.refresh()
        assert archive.search().total == 5


def test_tables_of_the_first_version_are_brought_up_to_date(
    root: Path, triad: Calibration, url: str
) -> None:
    engine = create_engine(url.replace("postgresql:", "postgresql+psycopg:"))
    with engine.begin() as connection:
        script = V1.replace("id INTEGER NOT NULL PRIMARY KEY", "id SERIAL PRIMARY KEY")
        for statement in script.split(";"):
            if statement.strip():
                connection.execute(text(statement))
    calibrated(triad, root / "a")
    with Archive(root, url) as archive:
        archive.refresh()
        entry = archive.search().entries[0]
        assert archive.quantities(entry)[0].dof == pytest.approx(3.99, abs=0.01)
    with engine.begin() as connection:
        connection.execute(text("UPDATE archive_meta SET value = '9'"))
    with Archive(root, url) as archive:
        assert archive.read_only
        assert archive.search().total == 1
    engine.dispose()


def test_a_server_that_does_not_answer_is_told_without_the_password(
    root: Path, postgres: PostgresServer
) -> None:
    wrong = f"postgresql://someone:hidden@/nobody?host={postgres.folder}{os.sep}none"
    with pytest.raises(StorageError, match="files of the sessions are untouched") as told:
        Archive(root, wrong)
    assert "hidden" not in str(told.value)
