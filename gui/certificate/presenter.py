"""The tab Certificates: clicks in, `CertificateState` out; the preview beside it."""

from collections.abc import Callable
from dataclasses import replace
from datetime import date
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from core.certificates.certificate import Certificate, Order, Surroundings
from core.certificates.laboratory import Laboratory
from core.certificates.measured import Measured
from core.certificates.register import Register
from core.errors import FormatError, LabError, Severity
from core.procedures.conformity import RULES
from gui.certificate.draft import KEPT, Draft, first_order
from gui.certificate.html import (
    certificate_sections,
    certificate_title,
    results_html,
)
from gui.certificate.issuing import (
    Done,
    Opened,
    Registered,
    entries_of,
    issue,
    opened,
    write_files,
    year_of,
)
from gui.certificate.keeping import LaboratoryKeeper
from gui.certificate.pdf import Paper
from gui.certificate.scene import Scene, state_of
from gui.certificate.state import CertificateState
from gui.certificate.texts import missing_words, remedy_of, say
from gui.services import Services
from gui.settings import text_of
from gui.widgets.states import BannerAction, BannerState

SOURCE, FOLDER = "certificate", "certificates"
_PREVIEW_MS = 200
"""Typing goes on for so long before the pages follow it."""
_ANYWAY = "anyway"


class CertificatePresenter(QObject):
    """Everything the view asks for.

    Parameters
    ----------
    services : what all tabs share
    """

    changed = Signal(object)
    """A new `CertificateState`."""
    previewed = Signal(object)
    """The `Paper` to be shown; None for none."""

    def __init__(self, services: Services, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._services = services
        self._remembered = dict(services.settings.section(SOURCE))
        self.keeper = LaboratoryKeeper(services.root, self)
        self.keeper.failed.connect(self._on_keeper)
        self._draft: Draft | None = None
        self._shown: Opened | None = None
        self._shown_results: tuple[str, ...] = ()
        self._entries = Registered(())
        self._chosen = ""
        self._busy = 0
        self._paper: Paper | None = None
        self._preview = QTimer(self)
        self._preview.setSingleShot(True)
        self._preview.setInterval(_PREVIEW_MS)
        self._preview.timeout.connect(self._lay_out)
        services.messages.action.connect(self._on_action)

    # --- what is known ----------------------------------------------------------------------------

    @property
    def folder(self) -> Path:
        """Where issued certificates lie."""
        return self._services.root() / FOLDER

    @property
    def laboratory(self) -> Laboratory:
        """Who issues."""
        return self.keeper.laboratory

    @property
    def paper(self) -> Paper | None:
        """What the preview shows."""
        return self._paper

    def shown(self) -> None:
        """The tab comes to the front: other programs may have issued meanwhile."""
        self._start("certificates", lambda: entries_of(Register(self.folder)))

    def retranslate(self) -> None:
        """Another language is spoken: everything is written anew."""
        if self._draft is not None:
            self._draft.write()
        if self._shown is not None:
            self._shown_results = results_html(self._shown.certificate.measured.printed)
        self._lay_out()

    # --- where results come from ------------------------------------------------------------------

    def take(self, measured: Measured) -> None:
        """Begin a certificate of these results."""
        order = first_order(measured, self._remembered)
        surroundings = Surroundings() if self._draft is None else self._draft.surroundings
        self._begin(measured, order, surroundings)

    def load(self, path: Path) -> None:
        """Begin a certificate of what a file holds."""
        read = self._services.read_measured
        self._start("certificate's results", lambda: read(path))

    def _begin(self, measured: Measured, order: Order, surroundings: Surroundings) -> None:
        rule = text_of(self._remembered, "rule", next(iter(RULES)))
        sensor = measured.subject
        limits = self._remembered.get(f"limits {sensor}")
        try:
            self._draft = Draft(
                measured,
                order,
                surroundings,
                rule if rule in RULES else next(iter(RULES)),
                limits if isinstance(limits, dict) else {},
            )
        except LabError as error:
            what = say("No certificate can be made of these results")
            self._tell_error(what, error, remedy_of("results"))
            return
        self._shown, self._chosen = None, ""
        self._services.messages.clear(SOURCE)
        self._lay_out()

    # --- what is typed ----------------------------------------------------------------------------

    def set_order(self, order: Order) -> None:
        """Take what was typed about customer and item."""
        if self._draft is not None and self._shown is None and order != self._draft.order:
            self._draft.order = order
            self._remember(**{key: getattr(order, key) for key in KEPT})
            self._typed()

    def set_surroundings(self, surroundings: Surroundings) -> None:
        """Take what was typed about the air."""
        if self._draft is not None and self._shown is None:
            self._draft.surroundings = surroundings
            self._typed()

    def set_laboratory(self, laboratory: Laboratory) -> None:
        """Take another laboratory; it is kept for all certificates to come."""
        if laboratory != self.laboratory:
            self.keeper.take(laboratory)
            self._typed()

    def set_limit(self, parameter: str, nominal: str, limit: str) -> None:
        """Judge a parameter by what was typed."""
        draft = self._draft
        if draft is not None and self._shown is None:
            draft.set_limit(parameter, nominal, limit)
            self._remember(**{f"limits {draft.sensor}": draft.limits.typed()})
            self._typed()

    def set_rule(self, rule: str) -> None:
        """Judge by another rule."""
        if self._draft is not None and self._shown is None:
            self._draft.rule = rule
            self._remember(rule=rule)
            self._typed()

    def set_printed(self, place: int, printed: bool) -> None:
        """Print a part of the results, or leave it out."""
        if self._draft is not None and self._shown is None:
            self._draft.set_printed(place, printed)
            self._typed()

    def _remember(self, **values: object) -> None:
        self._remembered.update(values)
        self._services.settings.store(SOURCE, self._remembered)

    # --- what is done -----------------------------------------------------------------------------

    def act(self, key: str) -> None:
        """A button of the row of actions."""
        if key == "issue":
            self._issue(sure=False)
        elif key == "draft":
            self._shown, self._chosen = None, ""
            self._lay_out()
        elif key == "replace":
            self._replace()
        elif key == "files" and self._shown is not None:
            one, results, root = self._shown, self._shown_results, self._services.root()

            def work() -> Done:
                files = write_files(one.certificate, results, root, one.path)
                return Done(one.certificate, one.path, files)

            self._start("certificate's files", work)

    def open(self, number: str) -> None:
        """Show an issued certificate."""
        entry = next((one for one in self._entries.entries if one.number == number), None)
        if entry is None:
            return
        self._chosen = number
        if entry.damage:
            what = say("The certificate cannot be read")
            self._show(Severity.ERROR, what, entry.damage, remedy_of("twin"))
            self._tell()
            return
        self._start("certificate", lambda: opened(Register(self.folder), entry.path))

    def withdraw(self, reason: str) -> None:
        """State that the shown certificate holds no longer."""
        if self._shown is None:
            return
        if not reason.strip():
            remedy = remedy_of("withdrawal")
            self._show(Severity.WARNING, say("A withdrawal needs a reason"), "", remedy)
            return
        register, number = Register(self.folder), self._shown.certificate.number

        def work() -> Registered:
            register.withdraw(number, date.today().isoformat(), reason.strip())
            return entries_of(register)

        self._start("withdrawal", work)

    def _replace(self) -> None:
        """Begin a certificate that replaces the one that is shown."""
        if self._shown is None:
            return
        old = self._shown.certificate
        order = replace(old.order, replaces=old.number, change="", issued=date.today().isoformat())
        self._begin(old.measured, order, old.surroundings)

    def _issue(self, *, sure: bool) -> None:
        draft = self._draft
        if draft is None or self._shown is not None or self._busy:
            return
        certificate = draft.certificate(self.laboratory, "")
        missing = missing_words(certificate.missing())
        doubts = [note.text for note in certificate.doubts()]
        if (missing or doubts) and not sure:
            parts = [say("Missing: {list}.").format(list=", ".join(missing))] if missing else []
            banner = BannerState(
                Severity.WARNING,
                say("The certificate is not complete"),
                " ".join([*parts, *(f"{text}." for text in doubts)]),
                say("What is issued gets its number for ever."),
                (BannerAction(_ANYWAY, say("Issue all the same")),),
            )
            self._services.messages.show(SOURCE, banner)
            return
        self._services.messages.clear(SOURCE)
        self.keeper.flush()
        register, results, root = Register(self.folder), draft.results, self._services.root()
        self._start("certificate", lambda: issue(register, certificate, results, root))

    def _on_keeper(self, what: str, error: object) -> None:
        if isinstance(error, LabError):
            refused = say("The laboratory's file is refused")
            unwritten = say("The laboratory's file is not written")
            told = (refused, remedy_of("laboratory")) if what == "read" else (unwritten, "")
            self._tell_error(told[0], error, told[1])

    def _on_action(self, source: str, key: str) -> None:
        if source == SOURCE and key == _ANYWAY:
            self._services.messages.clear(SOURCE)
            self._issue(sure=True)

    # --- what comes back --------------------------------------------------------------------------

    def _start(self, name: str, work: Callable[[], object]) -> None:
        self._busy += 1
        self._services.jobs.start(name, work, self._on_done, self._on_failed)
        self._tell()

    def _on_done(self, result: object) -> None:
        self._busy -= 1
        if isinstance(result, Measured):
            self.take(result)
        elif isinstance(result, Registered):
            self._entries = result
            self._lay_out()
        elif isinstance(result, Opened):
            self._on_opened(result)
        elif isinstance(result, Done):
            self._on_issued(result)
        else:
            raise TypeError(f"the work brought {type(result).__name__}")
        self._tell()

    def _on_opened(self, one: Opened) -> None:
        try:
            self._shown_results = results_html(one.certificate.measured.printed)
        except LabError as error:
            self._tell_error(say("The certificate cannot be read"), error, remedy_of("twin"))
            return
        self._shown, self._chosen = one, one.certificate.number
        self._lay_out()

    def _on_issued(self, done: Done) -> None:
        number = done.certificate.number
        if done.problem:
            what = say("No. {number} is issued, its PDF is not written")
            remedy = say("Write PDF and HTML does it once there is room.")
            banner = BannerState(
                Severity.ERROR, what.format(number=number), f"{done.problem}.", remedy
            )
            self._services.messages.show(SOURCE, banner)
        else:
            what = say("No. {number} is issued").format(number=number)
            where = say("{name}, with HTML and JSON, in the folder certificates of the sessions.")
            self._show(Severity.INFO, what, where.format(name=done.files[0].name))
        self._on_opened(Opened(done.certificate, done.path))
        self.shown()

    def _on_failed(self, error: LabError) -> None:
        self._busy -= 1
        self._tell_error(say("The certificate could not be worked on"), error, remedy_of("work"))
        self._tell()

    # --- what is shown ----------------------------------------------------------------------------

    def _typed(self) -> None:
        self._preview.start()
        self._tell()

    def _number(self) -> str:
        """What the next certificate gets; raises `FormatError` for a pattern that gives none."""
        draft = self._draft
        year = year_of("" if draft is None else draft.order.issued)
        taken = {one.path.name for one in self._entries.entries}
        register = Register(self.folder)
        n = 1
        while register.path(number := self.laboratory.number_of(year, n)).name in taken:
            n += 1
        return number

    def _lay_out(self) -> None:
        """Lay the pages out; what has not changed stays as it was."""
        self._preview.stop()
        try:
            certificate, results = self._current(self._number())
        except FormatError:
            certificate, results = self._current("")
        if certificate is None:
            self._paper = None
        else:
            sections = certificate_sections(certificate, results, self._services.root())
            self._paper = Paper(sections, certificate_title(certificate), self._paper)
        self.previewed.emit(self._paper)
        self._tell()

    def _current(self, number: str) -> tuple[Certificate | None, tuple[str, ...]]:
        """What the preview shows, and its results."""
        if self._shown is not None:
            return self._shown.certificate, self._shown_results
        if self._draft is None:
            return None, ()
        return self._draft.certificate(self.laboratory, number), self._draft.results

    @property
    def state(self) -> CertificateState:
        """The tab as it is now."""
        number, wrong = "", ""
        try:
            number = self._number()
        except FormatError as error:
            wrong = str(error) if self._shown is None else ""
        return state_of(
            Scene(
                self._current(number)[0],
                self.laboratory,
                self._draft,
                self._shown,
                self._entries.entries,
                self._chosen,
                number,
                wrong,
                self._busy > 0,
            )
        )

    def _tell(self) -> None:
        self.changed.emit(self.state)

    def _show(self, severity: Severity, what: str, meaning: str = "", remedy: str = "") -> None:
        self._services.messages.show(SOURCE, BannerState(severity, what, meaning, remedy))

    def _tell_error(self, what: str, error: LabError, remedy: str = "") -> None:
        self._services.messages.tell_error(SOURCE, what, error, remedy=remedy)
