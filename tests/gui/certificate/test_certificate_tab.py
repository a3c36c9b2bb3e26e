"""From results to an issued certificate, as the operator does it."""

from dataclasses import replace
from datetime import date
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLineEdit
from pytestqt.qtbot import QtBot

from core.certificates.laboratory import FILE, read_laboratory
from core.certificates.measured import Measured
from core.certificates.register import Register
from core.errors import FormatError, Severity
from gui.certificate.presenter import CertificatePresenter
from gui.certificate.tab import CertificateTab
from gui.messages import Messages
from tests.gui.allan.conftest import cvg_record
from tests.gui.certificate.conftest import TRIAD

TODAY = date.today().isoformat()
FIRST, SECOND = f"{TODAY[:4]}-0001", f"{TODAY[:4]}-0002"


def messages_of(tab: CertificateTab) -> Messages:
    return tab.presenter._services.messages


def banner(tab: CertificateTab) -> str:
    shown = messages_of(tab).current
    return "" if shown is None else f"{shown.what} {shown.meaning}"


def fill(presenter: CertificatePresenter) -> None:
    order = replace(
        presenter.state.order,
        customer="Plant",
        contact="O. Ivanenko",
        item="inclinometer",
        condition="as new",
        calibrated=TODAY,
    )
    presenter.set_order(order)
    presenter.set_surroundings(replace(presenter.state.surroundings, temperature_c=22.5))


def issue(tab: CertificateTab, qtbot: QtBot) -> None:
    tab.presenter.act("issue")
    qtbot.waitUntil(lambda: tab.presenter.state.issued and not tab.presenter.state.busy)


def test_without_results_nothing_can_be_issued(tab: CertificateTab):
    state = tab.presenter.state
    assert state.hint.startswith("Process a calibration")
    assert not tab.view.action_bar.button("issue").isEnabled()
    assert tab.view.preview.sheet.paper is None
    assert state.laboratory.name == "Laboratory"


def test_a_draft_tells_what_is_missing_until_it_is_stated(tab: CertificateTab, triad: Measured):
    tab.certify(triad)
    state = tab.presenter.state
    assert (state.number, state.order.serial) == (FIRST, triad.provenance.device)
    assert state.order.issued == TODAY
    assert "customer" in state.needs
    assert "ambient temperature" in state.needs
    fill(tab.presenter)
    assert tab.presenter.state.needs == ()


def test_typing_reaches_the_pages(tab: CertificateTab, triad: Measured, qtbot: QtBot):
    tab.certify(triad)
    field = tab.view.order.order.fields["customer"]
    assert isinstance(field, QLineEdit)
    field.insert("Завод №5")
    before = tab.presenter.paper
    assert tab.presenter.state.order.customer == "Завод №5"
    qtbot.waitUntil(lambda: tab.presenter.paper is not before)
    paper = tab.presenter.paper
    assert paper is not None
    assert paper is tab.view.preview.sheet.paper
    assert any("Завод №5" in html for html in paper.sections)
    # What has not changed was not laid out again.
    kept = [html for html in paper.sections if before is not None and html in before.sections]
    assert len(kept) == len(paper.sections) - 1
    assert all(paper.sections[html] is before.sections[html] for html in kept)


def test_the_number_is_given_once_and_everything_is_written(
    tab: CertificateTab, triad: Measured, root: Path, qtbot: QtBot
):
    tab.certify(triad)
    fill(tab.presenter)
    issue(tab, qtbot)
    names = sorted(path.name for path in (root / "certificates").iterdir())
    assert names == [f"certificate_{FIRST}.{suffix}" for suffix in ("html", "json", "pdf")]
    text = (root / "certificates" / names[0]).read_text(encoding="utf-8")
    assert FIRST in text
    assert "Plant, O. Ivanenko" in text
    assert tab.presenter.state.number == FIRST
    assert "is issued" in banner(tab)
    tab.presenter.act("draft")
    assert tab.presenter.state.number == SECOND


def test_an_incomplete_one_is_issued_only_if_the_operator_insists(
    tab: CertificateTab, triad: Measured, root: Path, qtbot: QtBot
):
    tab.certify(triad)
    tab.presenter.act("issue")
    assert "Missing: customer" in banner(tab)
    assert not (root / "certificates").exists()
    messages_of(tab).press("anyway")
    qtbot.waitUntil(lambda: tab.presenter.state.issued)
    assert Register(root / "certificates").entries()[0].number == FIRST


def test_a_full_disk_costs_the_pdf_but_not_the_certificate(
    tab: CertificateTab, triad: Measured, root: Path, qtbot: QtBot
):
    pdf = root / "certificates" / f"certificate_{FIRST}.pdf"
    pdf.mkdir(parents=True)  # nothing can be written there
    tab.certify(triad)
    fill(tab.presenter)
    issue(tab, qtbot)
    assert "its PDF is not written" in banner(tab)
    pdf.rmdir()
    qtbot.waitUntil(lambda: not tab.presenter.state.busy)
    tab.presenter.act("files")
    qtbot.waitUntil(pdf.is_file)
    qtbot.waitUntil(lambda: not tab.presenter.state.busy)
    before = pdf.read_bytes()
    tab.presenter.act("files")
    qtbot.waitUntil(lambda: "not overwritten" in banner(tab))
    assert pdf.read_bytes() == before


def test_an_issued_one_is_replaced_by_one_that_names_it(
    tab: CertificateTab, triad: Measured, root: Path, qtbot: QtBot
):
    tab.certify(triad)
    fill(tab.presenter)
    issue(tab, qtbot)
    tab.presenter.act("replace")
    state = tab.presenter.state
    assert not state.issued
    assert state.order.replaces == FIRST
    assert state.order.customer == "Plant"
    assert state.needs == ("what was changed, and why",)
    assert tab.view.order.order.fields["change"].isVisibleTo(tab.view)
    tab.presenter.set_order(replace(state.order, serial="18", change="serial number"))
    issue(tab, qtbot)
    newer, older = Register(root / "certificates").entries()
    assert (newer.number, older.replaced_by) == (SECOND, SECOND)
    qtbot.waitUntil(lambda: len(tab.presenter.state.register) == 2)
    tab.presenter.open(FIRST)
    qtbot.waitUntil(lambda: tab.presenter.state.number == FIRST)
    assert not tab.view.action_bar.button("replace").isEnabled()


def test_a_withdrawal_needs_a_reason(tab: CertificateTab, triad: Measured, qtbot: QtBot):
    tab.certify(triad)
    fill(tab.presenter)
    issue(tab, qtbot)
    register = tab.view.register
    tab.view.pages.setCurrentIndex(3)
    qtbot.mouseClick(register.withdraw, Qt.MouseButton.LeftButton)
    assert "needs a reason" in banner(tab)
    register.reason.setText("wrong head")
    qtbot.mouseClick(register.withdraw, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: bool(tab.presenter.state.register[0].withdrawn))
    assert register.list.topLevelItem(0).text(1) == "withdrawn"
    assert not register.withdraw.isEnabled()


def test_a_file_becomes_a_draft_and_a_bad_one_is_told(
    tab: CertificateTab, tmp_path: Path, qtbot: QtBot
):
    tab.load(TRIAD)
    qtbot.waitUntil(lambda: bool(tab.presenter.state.subject))
    bad = tmp_path / "bad.txt"
    bad.write_text("nothing", encoding="utf-8")
    tab.load(bad)
    qtbot.waitUntil(lambda: "bad.txt" in banner(tab))
    assert tab.presenter.state.subject


def test_a_record_at_rest_becomes_a_draft_of_its_noise_with_limits_and_pages(
    tab: CertificateTab, qtbot: QtBot, tmp_path: Path
):
    tab.load(cvg_record(tmp_path, "25-143", 1))
    presenter = tab.presenter
    qtbot.waitUntil(lambda: presenter.state.order.serial == "25-143", timeout=20_000)
    symbols = {row.parameter: row.symbol for row in presenter.state.limits}
    assert symbols["random_walk"] == "N"
    assert {"bias_instability", "rate_random_walk"} <= set(symbols)
    tab.view.pages.setCurrentIndex(1)
    place = list(symbols).index("random_walk")
    for limit, verdict in (("0,05", "PASS"), ("0.01", "FAIL")):
        tab.view.limits.table.item(place, 2).setText(limit)
        assert presenter.state.verdict == verdict
    titles = [part.title for part in presenter.state.parts]
    assert titles[:2] == ["Noise coefficients, 95 %", "Allan deviation with its 95 % limits"]
    fill(presenter)
    issue(tab, qtbot)
    twin, *_ = Register(presenter.folder).entries()
    assert twin.verdict == "fail"


def test_limits_judge_and_are_remembered(tab: CertificateTab, triad: Measured):
    tab.certify(triad)
    presenter = tab.presenter
    tab.view.pages.setCurrentIndex(1)
    table = tab.view.limits.table
    bias = [row.parameter for row in presenter.state.limits].index("bias")
    table.item(bias, 2).setText("1e9")
    assert presenter.state.verdict == "PASS"
    table.item(bias, 2).setText("0,001")
    assert presenter.state.verdict == "FAIL"
    table.item(bias, 2).setText("wide")
    assert presenter.state.verdict == ""
    assert presenter.state.doubts[-1].severity is Severity.ERROR
    assert not tab.view.action_bar.button("issue").isEnabled()
    table.item(bias, 2).setText("500")
    tab.certify(triad)
    assert presenter.state.limits[bias].limit == "500"


def test_a_check_brings_its_own_verdict(tab: CertificateTab, check: Measured):
    tab.certify(check)
    state = tab.presenter.state
    assert state.limits == ()
    assert state.verdict == "PASS"
    paper = tab.presenter.paper
    assert paper is not None
    assert any("Statement of conformity" in html for html in paper.sections)


def test_a_part_can_be_left_out(tab: CertificateTab, triad: Measured):
    tab.certify(triad)
    presenter = tab.presenter
    titles = [part.title for part in presenter.state.parts]
    place = titles.index("Derived quantities")
    tab.view.limits.parts.item(place).setCheckState(Qt.CheckState.Unchecked)
    presenter._lay_out()
    paper = presenter.paper
    assert paper is not None
    assert not any("Derived quantities" in html for html in paper.sections)
    assert any("Residuals by position" in html for html in paper.sections)


def test_the_laboratory_is_kept_beside_the_sessions(tab: CertificateTab, root: Path, qtbot: QtBot):
    form = tab.view.laboratory
    name = form.texts.fields["name"]
    assert isinstance(name, QLineEdit)
    assert name.text() == "Laboratory"
    name.setText("New laboratory")
    qtbot.mouseClick(form.add, Qt.MouseButton.LeftButton)
    form.table.item(0, 3).setText("2001-01-01")
    tab.close()
    kept = read_laboratory(root / FILE)
    assert kept.name == "New laboratory"
    assert [one.valid_until for one in kept.standards] == ["2001-01-01"]


def test_an_expired_standard_is_a_doubt(tab: CertificateTab, triad: Measured):
    tab.certify(triad)
    tab.view.laboratory.table.item(0, 3).setText("2001-01-01")
    assert "valid until 2001-01-01" in tab.presenter.state.doubts[0].text


def test_a_damaged_laboratory_file_is_told_and_left_alone(tab: CertificateTab, root: Path):
    (root / FILE).write_text("{", encoding="utf-8")
    with pytest.raises(FormatError):
        read_laboratory(root / FILE)
    tab.presenter.keeper._laboratory = None
    assert tab.presenter.laboratory.name == ""
    assert "refused" in banner(tab)
    told = messages_of(tab).current
    assert told is not None
    assert "Correct the place that is named" in told.remedy
    tab.close()
    assert (root / FILE).read_text(encoding="utf-8") == "{"


def test_a_pattern_without_a_number_stops_the_issue(tab: CertificateTab, triad: Measured):
    tab.certify(triad)
    tab.presenter.set_laboratory(replace(tab.presenter.laboratory, number="{year}"))
    assert "has no {n}" in tab.presenter.state.doubts[-1].text
    assert not tab.view.action_bar.button("issue").isEnabled()


def test_pages_are_turned_and_zoomed(tab: CertificateTab, triad: Measured, qtbot: QtBot):
    tab.certify(triad)
    preview = tab.view.preview
    assert not preview.back.isEnabled()
    qtbot.mouseClick(preview.on, Qt.MouseButton.LeftButton)
    assert preview.sheet.number == 1
    assert preview.place.text().startswith("Page 2 of")
    wide = preview.sheet.width()
    preview.zoom.setCurrentIndex(1)
    preview.zoom.activated.emit(1)
    assert preview.sheet.width() < wide
    assert preview.sheet.height() <= preview.area.height()
    assert preview.area.horizontalScrollBar().maximum() == 0


def test_another_language_writes_the_pages_anew(tab: CertificateTab, triad: Measured, qtbot: QtBot):
    tab.certify(triad)
    before = tab.presenter.paper
    tab.presenter.retranslate()
    assert tab.presenter.paper is not before
    assert tab.presenter.state.parts
