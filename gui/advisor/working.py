"""The work of a job: comparing plans, predicting the chosen one as it was changed."""

from collections.abc import Mapping
from dataclasses import replace

from core.allan.model import NoiseModel
from core.errors import LabError
from core.plans.plan import Plan
from core.procedures.prediction.bench import Bench
from core.procedures.prediction.propose import Proposal, predict, propose, with_positions
from core.procedures.prediction.unseen import unseen
from core.samples.run import Conditions
from gui.advisor.state import Advised, AdvisorChoices


def bench_of(choices: AdvisorChoices) -> Bench:
    """The sensor and the rig."""
    return Bench(
        kind=choices.kind,
        noise=NoiseModel(
            random_walk=choices.noise[0],
            bias_instability=choices.noise[1],
            rate_random_walk=choices.noise[2],
        ),
        conditions=Conditions(
            g_mps2=choices.g_mps2,
            u_g_mps2=choices.u_g_mps2,
            head_u_arcsec=choices.head_u_arcsec,
            rate_u_ppm=choices.rate_u_ppm,
            latitude_deg=choices.latitude_deg,
        ),
        axis=choices.axis,
        tools=choices.tools,
        pause_s=choices.pause_s,
    )


def advise(choices: AdvisorChoices, plans: Mapping[str, Plan]) -> Advised:
    """Compare all plans, and predict the chosen one."""
    timed = [_timed(plan, choices) for plan in plans.values()]
    return predicted(choices, propose(timed, bench_of(choices)))


def predicted(choices: AdvisorChoices, proposals: tuple[Proposal, ...]) -> Advised:
    """Predict the chosen proposal with the operator's changes; the first if it is not there."""
    chosen = _chosen(choices, proposals)
    if chosen is None:
        return Advised(replace(choices, method="", plan_id=""), proposals)
    if (chosen.method, chosen.plan.id) != (choices.method, choices.plan_id):
        choices = replace(
            choices,
            method=chosen.method,
            plan_id=chosen.plan.id,
            dropped=frozenset(),
            added=(),
        )
    found = Advised(choices, proposals, chosen.plan, None, chosen.prediction)
    bench = bench_of(choices)
    try:
        plan = with_positions(chosen.plan, choices.dropped, choices.added)
        after = predict(chosen.method, plan, bench)
    except LabError as error:
        return replace(found, why=str(error))
    notes = unseen(chosen.method, plan, bench, after)
    return replace(found, plan=plan, after=after, unseen=notes)


def _timed(plan: Plan, choices: AdvisorChoices) -> Plan:
    seconds = choices.accumulation_s
    return replace(plan, accumulation_s=seconds) if seconds > 0 else plan


def _chosen(choices: AdvisorChoices, proposals: tuple[Proposal, ...]) -> Proposal | None:
    wanted = (choices.method, choices.plan_id)
    first = proposals[0] if proposals else None
    return next((one for one in proposals if (one.method, one.plan.id) == wanted), first)
