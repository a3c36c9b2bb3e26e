"""The part of the tab Certificates in the demonstration: measure, state, issue."""

from dataclasses import replace
from pathlib import Path

from core.certificates.certificate import Surroundings
from core.certificates.laboratory import Laboratory, Standard
from gui.certificate.tab import CertificateTab
from gui.measuring.demonstrating import Stage, Told, process, walk
from gui.measuring.tab import MeasuringTab

TITLE = "Certificates"
_HEAD = "Dividing head"
_ACCUMULATION_S = 5.0
_LABORATORY = Laboratory(
    name="Laboratory of inertial sensors",
    address="1 Example Street, Kyiv, Ukraine",
    authorised_by="O. Petrenko",
    position="head of the laboratory",
    number="LIS-{year}-{n:04d}",
    statement="Demonstration on the simulated rig; not a certificate of a real unit.",
    standards=(
        Standard("optical dividing head", "114", "UA/24/0118", "2099-03-01", "national institute"),
        Standard("frame level 200-0.02", "7731", "UA/24/0550", "2099-02-01", "national institute"),
        Standard("thermometer TL-4", "88", "UA/24/0032", "2099-01-01", "national institute"),
    ),
)


def play(stage: Stage) -> Told:
    """Calibrate a triad, and issue its certificate with a statement of conformity."""
    stage.connect("pointer")
    head = stage.show(_HEAD)
    if not isinstance(head, MeasuringTab):
        raise TypeError(f"{_HEAD} is a {type(head).__name__}")
    stage.until(lambda: head.sitting.walk.status is not None, "the rig did not answer")
    head.presenter.set_settings(replace(head.sitting.settings, accumulation_s=_ACCUMULATION_S))
    session = walk(stage, head)
    process(stage, head, "", ())
    head.view.results.certificate.click()
    tab = stage.show(TITLE)
    if not isinstance(tab, CertificateTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    _state(tab)
    stage.picture("certificates-draft")
    tab.view.pages.setCurrentIndex(1)
    stage.picture("certificates-limits")
    presenter = tab.presenter
    presenter.act("issue")
    stage.until(lambda: presenter.state.issued and not presenter.state.busy, "nothing was issued")
    tab.view.pages.setCurrentIndex(3)
    stage.picture("certificates-issued")
    for path in sorted(presenter.folder.iterdir()):
        stage.keep(path)
    _draw_pages(stage, tab)
    return Told(TITLE, (), Path(session))


def _state(tab: CertificateTab) -> None:
    """Fill the form in."""
    presenter = tab.presenter
    presenter.set_laboratory(_LABORATORY)
    presenter.set_order(
        replace(
            presenter.state.order,
            customer="Instrument plant, Kharkiv",
            contact="O. Ivanenko",
            item="triad of accelerometers",
            model="PW09",
            condition="without visible damage",
            before="No adjustment was made.",
        )
    )
    presenter.set_surroundings(Surroundings(22.5, 41.0, 1003.0, 12.0))
    presenter.set_limit("bias", "", "600")


def _draw_pages(stage: Stage, tab: CertificateTab) -> None:
    """Keep every page as a picture."""
    paper, preview = tab.presenter.paper, tab.view.preview
    if paper is None:
        raise RuntimeError("there are no pages")
    for number in range(len(paper.pages)):
        preview.go(number)
        stage.drawing(f"certificate-page-{number + 1}", preview.sheet.grab().save)
