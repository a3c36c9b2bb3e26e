"""The tab Certificates with real jobs, and results on the disk."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from core.certificates.laboratory import FILE, Laboratory, Standard, write_laboratory
from core.certificates.measured import Measured
from core.samples.run import Conditions
from gui.certificate.tab import CertificateTab
from gui.measured_file import measured_of_file
from gui.services import Services

SPECIMENS = Path(__file__).parents[2] / "data" / "legacy"
TRIAD = SPECIMENS / "OpticalDividingHead_202405140930.txt"
CHECK = SPECIMENS / "Accuracy_202405141110.txt"


@pytest.fixture(scope="session")
def triad() -> Measured:
    """A calibrated triad."""
    return measured_of_file(TRIAD, Conditions())


@pytest.fixture(scope="session")
def check() -> Measured:
    """An accuracy check with its verdict."""
    return measured_of_file(CHECK, Conditions())


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A folder of sessions with a laboratory."""
    folder = tmp_path / "root"
    folder.mkdir()
    laboratory = Laboratory(
        name="Laboratory",
        address="Kyiv",
        authorised_by="O. Petrenko",
        standards=(Standard("dividing head", "114", "UA-24/118", "2099-03-01", "institute"),),
    )
    write_laboratory(laboratory, folder / FILE)
    return folder


@pytest.fixture
def services(services: Services, root: Path) -> Services:
    """What tabs share, with the folder of the laboratory."""
    return replace(services, root=lambda: root)


@pytest.fixture
def tab(qtbot: QtBot, services: Services) -> Iterator[CertificateTab]:
    """The tab on the screen."""
    reading = replace(services, read_measured=lambda path: measured_of_file(path, Conditions()))
    one = CertificateTab(reading)
    qtbot.addWidget(one.widget)
    one.widget.resize(1200, 700)
    one.widget.show()
    qtbot.waitUntil(lambda: not one.presenter.state.busy)
    yield one
    one.close()
