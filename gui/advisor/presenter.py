"""The page Which procedure?: clicks in, `AdvisorState` out."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, Signal

from core.errors import FormatError, LabError, Severity
from core.plans.plan import OWN_PLANS, Plan, Step, load_plans
from core.plans.plan_text import plan_text
from core.procedures.prediction.catalogue import METHODS
from core.procedures.prediction.propose import Proposal
from core.records.atomic import make_folder, write_text_atomic
from core.records.names import safe_name
from gui.advisor.findings import findings_of
from gui.advisor.state import (
    TYPICAL,
    Advised,
    AdvisorChoices,
    AdvisorState,
    ProposalRow,
    StepRow,
)
from gui.advisor.words import minutes_words, plan_words, step_words
from gui.advisor.working import advise, predicted
from gui.jobs import Jobs
from gui.messages import Messages
from gui.record_noise import RecordNoise, noise_of_record
from gui.widgets.analysis_page import AnalysisState
from gui.widgets.states import ActionBarState, ActionItem, BannerState

SOURCE = "advisor"
_ON_TABLE = "rate_table"
_PLAIN_MOUNTS = ("X_from", "X_to", "Y_from", "Y_to", "Z_from", "Z_to")


class AdvisorPresenter(QObject):
    """Everything the page asks for.

    Parameters
    ----------
    jobs : computes
    messages : where it is told what was saved or refused
    root : returns the folder of all sessions; plans of the operator stand in its folder ``plans``
    open_plan : hands a plan to the tab that measures it; returns whether one took it
    """

    changed = Signal(object)
    """A new `AdvisorState`."""

    def __init__(
        self,
        jobs: Jobs,
        messages: Messages,
        root: Callable[[], Path],
        open_plan: Callable[[Plan], bool],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._messages = messages
        self._root = root
        self._open_plan = open_plan
        self._advised = Advised(AdvisorChoices())
        self._choices = self._asked = self._advised.choices
        self._plans = self._load_plans()
        self._busy = False
        self._advise()

    @property
    def advised(self) -> Advised:
        """What is on the page."""
        return self._advised

    @property
    def choices(self) -> AdvisorChoices:
        """What is decided."""
        return self._choices

    @property
    def state(self) -> AdvisorState:
        """The page as it is now."""
        advised = self._advised
        findings = findings_of(advised)
        whole = advised.whole
        return AdvisorState(
            choices=self._choices,
            proposals=tuple(_row(one) for one in advised.proposals),
            current=(advised.choices.method, advised.choices.plan_id),
            steps=() if whole is None else self._steps(whole),
            on_table=whole is not None and whole.test == _ON_TABLE,
            mounts=() if whole is None else _mounts(whole),
            frame=AnalysisState(
                self._hint() if findings is None else "", findings, ActionBarState(self._items())
            ),
        )

    # --- what the operator does -------------------------------------------------------------------

    def decide(self, choices: AdvisorChoices) -> None:
        """Take what was decided about sensor and rig."""
        if choices.kind != self._choices.kind:
            choices = replace(choices, noise=TYPICAL[choices.kind], noise_source="")
        self._change(choices)

    def set_noise(self, noise: tuple[float, float, float]) -> None:
        """Take noise that was typed."""
        self._change(replace(self._choices, noise=noise, noise_source=""))

    def load_noise(self, name: str) -> None:
        """Take the noise from a record of the sensor at rest."""
        path, kind = Path(name), self._choices.kind
        self._start(lambda: noise_of_record(path, kind))

    def choose(self, method: str, plan_id: str) -> None:
        """Look at another proposal, with all its steps."""
        self._change(
            replace(self._choices, method=method, plan_id=plan_id, dropped=frozenset(), added=())
        )

    def keep(self, number: int, kept: bool) -> None:
        """Measure a step, or leave it out; a step that was added goes altogether."""
        choices = self._choices
        if number < 0:
            place = -number - 1
            added = choices.added[:place] + choices.added[place + 1 :]
            self._change(replace(choices, added=added))
            return
        dropped = choices.dropped - {number} if kept else choices.dropped | {number}
        self._change(replace(choices, dropped=dropped))

    def add(self, mount: str, value: float) -> None:
        """Add a step: an angle of the head, or a rate of the table."""
        whole = self._advised.whole
        if whole is None:
            return
        on_table = whole.test == _ON_TABLE
        axis = mount[:1].lower()
        step = Step(0, "", mount, 0.0, value, axis) if on_table else Step(0, "", mount, value)
        self._change(replace(self._choices, added=(*self._choices.added, step)))

    def act(self, key: str) -> None:
        """A button of the row of actions."""
        if key == "open":
            self.open_plan()
        elif key == "restore":
            self._change(replace(self._choices, dropped=frozenset(), added=()))

    def open_plan(self) -> None:
        """Save the plan as the operator's own, and hand it to the tab that measures it."""
        advised = self._advised
        if advised.plan is None or advised.whole is None:
            return
        plan = advised.plan
        if plan != self._plans.get(plan.id):
            plan = self._own(plan, advised.whole)
            try:
                path = self._save(plan)
            except LabError as error:
                words = QCoreApplication.translate("Advisor", "The plan is not saved")
                self._messages.tell_error(SOURCE, words, error)
                return
            words = QCoreApplication.translate("Advisor", "The plan is saved: {path}")
            self._messages.log(Severity.INFO, words.format(path=path), SOURCE)
            self._plans = {**self._plans, plan.id: plan}
        self._messages.clear(SOURCE)
        if not self._open_plan(plan):
            self._messages.show(
                SOURCE,
                BannerState(
                    Severity.WARNING,
                    QCoreApplication.translate("Advisor", "No tab can take this plan now"),
                    QCoreApplication.translate(
                        "Advisor", "Its test is {test}, or an accumulation is running."
                    ).format(test=plan.test),
                    QCoreApplication.translate(
                        "Advisor", "End the session in its tab by New session, then open it again."
                    ),
                ),
            )

    # --- the work ---------------------------------------------------------------------------------

    def _load_plans(self) -> Mapping[str, Plan]:
        try:
            return load_plans(self._root() / OWN_PLANS)
        except FormatError as error:
            words = QCoreApplication.translate("Advisor", "A plan of your own is refused")
            self._messages.tell_error(SOURCE, words, error)
            return load_plans()

    def _own(self, plan: Plan, whole: Plan) -> Plan:
        """The plan under a name that no other has."""
        for count in range(1, 1000):
            plan_id = f"{safe_name(whole.id)}_own{count}"
            if plan_id not in self._plans:
                template = QCoreApplication.translate("Advisor", "{title}, own {count}")
                title = template.format(title=whole.title, count=count)
                return replace(plan, id=plan_id, title=title)
        raise RuntimeError("a thousand plans of one name")

    def _save(self, plan: Plan) -> Path:
        path = self._root() / OWN_PLANS / f"{plan.id}.toml"
        make_folder(path.parent)
        write_text_atomic(path, plan_text(plan))
        return path

    def _change(self, choices: AdvisorChoices) -> None:
        if choices == self._choices:
            return
        self._choices = choices
        self._advise()

    def _advise(self) -> None:
        """Compare all plans where sensor or rig were changed; else predict the chosen one anew."""
        if self._busy:
            return
        choices, plans, before = self._choices, self._plans, self._advised
        if before.proposals and _rig(choices) == _rig(before.choices):
            self._start(lambda: predicted(choices, before.proposals))
        else:
            self._start(lambda: advise(choices, plans))

    def _start(self, job: Callable[[], object]) -> None:
        if self._busy:
            return
        self._busy, self._asked = True, self._choices
        self._jobs.start("prediction", job, self._on_done, self._on_failed)

    def _on_done(self, result: object) -> None:
        self._busy = False
        match result:
            case Advised():
                self._advised = result
                if self._choices == self._asked:
                    self._choices = result.choices
                else:
                    self._advise()
            case RecordNoise(source, model):
                noise = (model.random_walk, model.bias_instability, model.rate_random_walk)
                self._change(replace(self._choices, noise=noise, noise_source=source))
            case _:
                raise TypeError(f"a prediction brought {type(result).__name__}")
        self.changed.emit(self.state)

    def _on_failed(self, error: LabError) -> None:
        self._busy = False
        words = QCoreApplication.translate("Advisor", "Nothing can be predicted")
        self._messages.tell_error(SOURCE, words, error)
        self.changed.emit(self.state)

    # --- what is shown ----------------------------------------------------------------------------

    def _steps(self, whole: Plan) -> tuple[StepRow, ...]:
        choices = self._choices
        on_table = whole.test == _ON_TABLE
        rows = [
            StepRow(
                step.number,
                f"{step.number}   {step_words(step, on_table)}",
                step.group,
                step.number not in choices.dropped,
            )
            for step in whole.steps
        ]
        group = QCoreApplication.translate("Advisor", "Added")
        rows += [
            StepRow(-place, f"{step.mount}   {step_words(step, on_table)}", group, True)
            for place, step in enumerate(choices.added, start=1)
        ]
        return tuple(rows)

    def _hint(self) -> str:
        if self._busy:
            return QCoreApplication.translate("Advisor", "The plans are being compared …")
        if not self._choices.noise[0] > 0:
            return QCoreApplication.translate(
                "Advisor",
                "State the white noise N of the sensor at the left, or take it from a record.",
            )
        return QCoreApplication.translate(
            "Advisor", "No plan measures this sensor with the tools that are ticked at the left."
        )

    def _items(self) -> tuple[ActionItem, ...]:
        advised = self._advised
        changed = bool(self._choices.dropped or self._choices.added)
        none = QCoreApplication.translate("Advisor", "There is no plan that would work.")
        return (
            ActionItem(
                "open",
                QCoreApplication.translate("Advisor", "Open this plan"),
                "Space",
                default=True,
                enabled=advised.after is not None,
                why_not=none,
            ),
            ActionItem(
                "restore",
                QCoreApplication.translate("Advisor", "Restore all steps"),
                "Ctrl+Z",
                enabled=changed,
                why_not=QCoreApplication.translate("Advisor", "Nothing was changed."),
            ),
            ActionItem(
                "export",
                QCoreApplication.translate("ActionBar", "Export"),
                "Ctrl+E",
                enabled=advised.after is not None,
                why_not=none,
            ),
        )


def _rig(choices: AdvisorChoices) -> AdvisorChoices:
    """What the comparison of all plans depends on."""
    return replace(choices, method="", plan_id="", dropped=frozenset(), added=(), noise_source="")


def _row(proposal: Proposal) -> ProposalRow:
    plan, prediction = proposal.plan, proposal.prediction
    parts = [METHODS[proposal.method].title, minutes_words(prediction.minutes)]
    template = QCoreApplication.translate("Advisor", "{count} parameters")
    parts.append(template.format(count=len(prediction.parameters)))
    parts += [words for words in (plan_words(plan),) if words]
    return ProposalRow((proposal.method, plan.id), plan.title, ", ".join(parts))


def _mounts(plan: Plan) -> tuple[str, ...]:
    return tuple(dict.fromkeys((*(step.mount for step in plan.steps), *_PLAIN_MOUNTS)))
