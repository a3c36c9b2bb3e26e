"""The state of the tab, put together from its parts."""

from dataclasses import dataclass

from core.certificates.certificate import Certificate, Order, Surroundings
from core.certificates.laboratory import Laboratory
from core.certificates.register import Issued
from core.errors import Note, Severity
from core.procedures.conformity import RULES
from gui.certificate.draft import Draft
from gui.certificate.html import verdict_words
from gui.certificate.issuing import Opened, files_of
from gui.certificate.state import CertificateState
from gui.certificate.texts import draft_actions, issued_actions, missing_words, say
from gui.widgets.states import ActionBarState, ActionItem


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """What there is.

    Parameters
    ----------
    certificate : what the preview shows; None for nothing
    laboratory : who issues
    draft, shown : what is being written, and the issued one that is looked at instead
    register, chosen : issued ones, and the number of the one that is chosen
    number, wrong : that the draft will get, or why there is none
    busy : whether files are being read or written
    """

    certificate: Certificate | None
    laboratory: Laboratory
    draft: Draft | None
    shown: Opened | None
    register: tuple[Issued, ...]
    chosen: str
    number: str
    wrong: str
    busy: bool


def state_of(scene: Scene) -> CertificateState:
    """Everything that the view shows now."""
    certificate, shown = scene.certificate, scene.shown
    draft = scene.draft if shown is None else None
    conformity = None if certificate is None else certificate.conformity
    return CertificateState(
        subject="" if certificate is None else certificate.measured.provenance.device,
        number=scene.number if shown is None else shown.certificate.number,
        issued=shown is not None,
        order=Order() if certificate is None else certificate.order,
        surroundings=Surroundings() if certificate is None else certificate.surroundings,
        laboratory=scene.laboratory,
        limits=() if draft is None else draft.limits.rows,
        rule=next(iter(RULES)) if draft is None else draft.rule,
        verdict="" if conformity is None else verdict_words(conformity.verdict),
        parts=() if draft is None else draft.parts,
        needs=() if certificate is None else missing_words(certificate.missing()),
        doubts=_doubts(scene),
        register=scene.register,
        chosen=scene.chosen,
        busy=scene.busy,
        actions=ActionBarState(_actions(scene)),
        hint=_hint() if certificate is None else "",
    )


def _hint() -> str:
    return say(
        "Process a calibration or a check in its tab and press Certificate on the page of its"
        " results; or load a session, a run file, an old file or a calibration here (Ctrl+O)."
    )


def _doubts(scene: Scene) -> tuple[Note, ...]:
    notes = [] if scene.certificate is None else list(scene.certificate.doubts())
    if scene.wrong:
        notes.append(Note(Severity.ERROR, "number", scene.wrong))
    if scene.draft is not None and scene.shown is None and scene.draft.limits.problem:
        notes.append(Note(Severity.ERROR, "limit", scene.draft.limits.problem))
    return tuple(notes)


def _actions(scene: Scene) -> tuple[ActionItem, ...]:
    if scene.shown is not None:
        entry = next((one for one in scene.register if one.number == scene.chosen), None)
        return issued_actions(
            holds=entry is not None and not entry.withdrawn and not entry.replaced_by,
            has_files=any(path.exists() for path in files_of(scene.shown.path)),
            has_draft=scene.draft is not None,
        )
    why_not = _why_not(scene)
    return draft_actions(ready=not why_not, why_not=why_not)


def _why_not(scene: Scene) -> str:
    """Why nothing can be issued now; empty if it can."""
    if scene.draft is None:
        return say("There are no results yet")
    if scene.wrong or scene.draft.limits.problem:
        return scene.wrong or scene.draft.limits.problem
    return say("Files are being read or written") if scene.busy else ""
