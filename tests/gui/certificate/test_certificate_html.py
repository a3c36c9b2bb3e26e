"""What ISO/IEC 17025, 7.8 asks for stands in the text, and paper cuts nothing."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtGui import QColor, QImage, QPainter

from core.certificates.certificate import Certificate, Order, Surroundings
from core.certificates.laboratory import Laboratory, Standard
from core.certificates.limits import ParameterLimit, judge_stated, stated_of
from core.certificates.measured import measured_of
from core.errors import Note, Severity, StorageError
from core.fit.quantiles import student_t
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.open import read_any
from gui.certificate.html import (
    certificate_sections,
    certificate_title,
    results_html,
    whole_html,
)
from gui.certificate.parts import part_html, symbols
from gui.certificate.pdf import Paper
from gui.dividing_head.tables import matrices, parameter_table
from gui.measuring.page import CurveState, Part
from gui.measuring.printed import printed_of
from gui.widgets.states import ResidualSeries, ResidualState, TableState

pytestmark = pytest.mark.usefixtures("qapp")
RUN = """# calrig-run = 1
# test = "dividing_head"
# sensor = "accelerometer"
# axis = "z"
# device = "MS9002 <3>"
# output_unit = "V"
# g_mps2 = 9.8106
run,order,mount,head_deg,y
"""


@pytest.fixture
def calibration(tmp_path: Path) -> Calibration:
    rng = np.random.default_rng(8)
    rows = [
        f"{n // 4},{n},X_from,{90 * (n % 4)},"
        f"{2.5 + np.cos(np.pi / 2 * (n % 4)) + 1e-4 * rng.normal():.6f}\n"
        for n in range(12)
    ]
    path = tmp_path / "twelve.run.csv"
    path.write_text(RUN + "".join(rows), encoding="utf-8")
    run = read_any(path)
    return calibrate(run, run.conditions)


def parts_of(calibration: Calibration) -> tuple[Part, ...]:
    residuals = ResidualState(
        tuple(str(n) for n in range(12)),
        (ResidualSeries("U", tuple(calibration.fits[0].residuals.tolist())),),
        "V",
    )
    doubt = Note(Severity.WARNING, "worn", "the head is worn & old")
    return (parameter_table(calibration), *matrices(calibration), residuals, doubt)


def sections(certificate: Certificate, folder: Path) -> tuple[str, ...]:
    return certificate_sections(certificate, results_html(certificate.measured.printed), folder)


@pytest.fixture
def certificate(calibration: Calibration) -> Certificate:
    limits = (ParameterLimit("bias", "", 2.5, 0.01),)
    return Certificate(
        number="2026-0042",
        laboratory=Laboratory(
            name="Laboratory & Sons",
            address="Kyiv",
            authorised_by="O. Petrenko",
            standards=(Standard("dividing head", "114", "UA-24/118", "2027-03-01", "institute"),),
        ),
        order=Order(customer="Plant", serial="MS9002 <3>", calibrated="2026-11-20"),
        measured=measured_of(calibration, printed_of(parts_of(calibration))),
        surroundings=Surroundings(22.5, 41.0),
        conformity=judge_stated(stated_of(calibration), limits, "guarded"),
    )


def test_everything_that_is_asked_for_stands_in_it(certificate: Certificate, tmp_path: Path):
    text = whole_html(sections(certificate, tmp_path), "t")
    for words in (
        "CALIBRATION CERTIFICATE",
        "2026-0042",
        "Laboratory &amp; Sons",
        "MS9002 &lt;3&gt;",
        "2026-11-20",
        "UA-24/118",
        "9.810600 m/s²",
        "22.5 °C",
        "41 %",
        "twelve.run.csv (SHA-256 ",
        "PASS",
        "guard band",
        "the head is worn &amp; old",
        "The results relate only to the item calibrated.",
        "O. Petrenko",
        "End of the certificate",
    ):
        assert words in text, words
    assert "Air pressure" not in text  # nothing was stated
    calibration = certificate.measured.calibration
    assert calibration is not None
    dofs = calibration.fits[0].t_dof
    assert f"k\u00a0=\u00a0{student_t(0.95, float(dofs[0])):.2f}" in text


def test_without_freedom_no_uncertainty_is_claimed(certificate: Certificate, tmp_path: Path):
    calibration = certificate.measured.calibration
    assert calibration is not None
    fit = replace(calibration.fits[0], t_dof=np.zeros(3))
    measured = measured_of(replace(calibration, fits=(fit,)), certificate.measured.printed)
    bare = replace(certificate, measured=measured)
    text = "".join(sections(bare, tmp_path))
    assert "no uncertainty can be stated" in text
    assert "k\u00a0=" not in text


def test_the_logo_travels_inside_and_a_lost_one_costs_nothing(
    certificate: Certificate, tmp_path: Path
):
    image = QImage(20, 20, QImage.Format.Format_RGB32)
    image.fill(QColor("red"))
    assert image.save(str(tmp_path / "logo.png"))
    for name, inside in (("logo.png", True), ("lost.png", False), ("logo.exe", False)):
        laboratory = replace(certificate.laboratory, logo=name)
        pieces = sections(replace(certificate, laboratory=laboratory), tmp_path)
        assert ('height="60"' in pieces[0]) is inside


def test_paper_cuts_no_section_that_fits_a_page(certificate: Certificate, tmp_path: Path):
    whole = sections(certificate, tmp_path)
    paper = Paper(whole, certificate_title(certificate))
    pieces = [piece for pieces in paper.pages for piece in pieces]
    assert len(pieces) == len(whole)
    for pieces in paper.pages:
        bottoms = [piece.top + piece.source[1] - piece.source[0] for piece in pieces]
        assert max(bottoms) <= paper.height
        assert [piece.top for piece in pieces] == sorted(piece.top for piece in pieces)


def test_a_table_longer_than_a_page_goes_on_without_losing_a_row():
    rows = tuple((f"row {n}", str(n)) for n in range(150))
    table = TableState("Long", "", ("name", "n"), rows)
    paper = Paper(("<p>before</p>", *part_html(table), "<p>after</p>"), "foot")
    assert len(paper.pages) >= 3
    assert len(paper.pages[0]) == 2  # it begins where there is room
    pieces = [piece for pieces in paper.pages for piece in pieces][1:-1]
    headers = [piece for piece in pieces if piece.source[1] - piece.source[0] < 40.0]
    assert len(headers) == len(paper.pages) - 1
    assert len({piece.source for piece in headers}) == 1
    ends = [piece.source for piece in pieces if piece not in headers]
    assert ends[0][0] == 0.0
    assert all(before[1] == after[0] for before, after in pairwise(ends))
    assert ends[-1][1] == pytest.approx(pieces[0].section.size().height())


def test_long_remarks_are_cut_between_lines():
    words = "The unit was warmed up before the first position. " * 400
    paper = Paper((f"<p>{words}</p>",), "foot")
    assert len(paper.pages) == 3
    heights = {
        round((piece.source[1] - piece.source[0]) / 14.0, 1)
        for pieces in paper.pages[:-1]
        for piece in pieces
    }
    assert len(heights) <= 2


def test_a_wide_table_goes_on_below_itself():
    header = ("No.", "Mount", *(f"U{n}" for n in range(1, 13)))
    row = ("1", "X from", *(str(n) for n in range(1, 13)))
    pieces = part_html(TableState("Measured", "U = k·a", header, (row,), 2))
    assert len(pieces) == 2
    assert "Measured, further columns" in pieces[1]
    assert all(piece.count("X from") == 1 for piece in pieces)
    assert [f">U{n}<" in pieces[0] for n in range(1, 13)] == [True] * 6 + [False] * 6
    assert [f">U{n}<" in pieces[1] for n in range(1, 13)] == [False] * 6 + [True] * 6


def test_the_pdf_has_its_pages_and_a_full_disk_is_told(certificate: Certificate, tmp_path: Path):
    paper = Paper(sections(certificate, tmp_path), certificate_title(certificate))
    paper.save(tmp_path / "c.pdf")
    content = (tmp_path / "c.pdf").read_bytes()
    assert content.startswith(b"%PDF")
    assert f"/Count {len(paper.pages)}".encode() in content
    with pytest.raises(StorageError):
        paper.save(tmp_path / "no folder" / "c.pdf")


def test_a_page_on_the_screen_is_the_page_on_paper(certificate: Certificate, tmp_path: Path):
    paper = Paper(sections(certificate, tmp_path), "foot")
    image = QImage(round(paper.width), round(paper.height), QImage.Format.Format_RGB32)
    image.fill(QColor("white"))
    painter = QPainter(image)
    paper.draw(painter, 0)
    painter.end()
    dark = sum(
        QColor(image.pixel(x, y)).lightness() < 100
        for x in range(0, image.width(), 2)
        for y in range(0, image.height(), 2)
    )
    assert dark > 500


def test_curves_become_tables_and_symbols_get_their_indices():
    curve = CurveState("Error", "angle, deg", "error, deg", (("own", (0.0, 90.0), (0.1, 0.2), ()),))
    (text,) = part_html(curve)
    assert "Error, error, deg" in text
    assert ">90</td>" in text
    assert ">0.2</td>" in text
    assert symbols("U = k_z·a_z + U0") == "U = k<sub>z</sub>·a<sub>z</sub> + U<sub>0</sub>"
    assert symbols("Non-orthogonality Ux") == "Non-orthogonality Ux"
