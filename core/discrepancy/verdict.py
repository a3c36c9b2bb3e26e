"""One verdict, said in words."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import cast

from core.discrepancy.engine import Engine
from core.discrepancy.result import UNKNOWN, Gap, NoiseFloor, Smallest, Step, Where
from core.errors import Note, Severity
from core.fit.quantiles import f_sf

_LARGE = 2.0
_FAULTS = frozenset(
    (
        "stuck_reading",
        "positions_swapped",
        "mount_reversed",
        "channels_permuted",
        "rate_sign_reversed",
        "stale_temperature",
    )
)
_MANY, _LARGE_FOUND, _MUCH = 30, 1.35, 1e6
_BEYOND = 1e-4
_GROSS = 60.0
_NAMED = ("mount", "run", "direction")
"""Structure in these has names, and is no trace of an effect without one."""
FEWEST = 3
"""Degrees of freedom below which nothing is said."""


@dataclass(frozen=True, slots=True)
class Limits:
    """From where on the noise is too large, and from where on names are in doubt.

    Parameters
    ----------
    excess_p, excess_gap : a gap less likely and larger than this is no unlucky noise
    left_over : names are in doubt if structure that is left has a smaller p value
    every : which of several names is then wrong nobody can say, so that all are in doubt
    """

    excess_p: float = 1e-3
    excess_gap: float = 2.0
    left_over: float = 0.02
    every: bool = False


USUAL = Limits()
ROWS = Limits(excess_p=0.015, excess_gap=1.25, left_over=0.05, every=True)
"""Of accumulated rows, whose floor is stated by the certificates and seldom too small."""


def verdict_of(
    steps: tuple[Step, ...], noise: NoiseFloor, after: Gap, limits: Limits = USUAL
) -> str:
    """The verdict of a set of steps."""
    if any(step.effect == UNKNOWN for step in steps):
        return "unexplained_structure"
    if any(step.indistinguishable_from for step in steps):
        return "ambiguous"
    if steps:
        return "data_fault" if all(s.effect in _FAULTS for s in steps) else "explained"
    return "excess_noise" if _excess(noise, after, limits) else "adequate"


def summary_of(verdict: str, steps: tuple[Step, ...], before: Gap, after: Gap) -> str:
    """One or two sentences."""
    named = ", ".join(step.name for step in steps)
    closing = f"The gap goes from {before.gap:.2f} to {after.gap:.2f} noise floors."
    texts = {
        "adequate": f"The model explains the data: the gap is {before.gap:.2f} noise floors."
        " What these rows could have shown is listed.",
        "explained": f"Missing in the model: {named}. {closing}",
        "data_fault": f"The data are at fault: {named}. {closing}",
        "ambiguous": "Something is missing, and these data cannot tell which of several effects: "
        + "; ".join(" or ".join([step.effect, *step.indistinguishable_from]) for step in steps)
        + f". {closing}",
        "unexplained_structure": "There is structure that no effect of the catalogue explains: "
        + "; ".join(step.plain if step.effect == UNKNOWN else step.name for step in steps)
        + ".",
        "excess_noise": f"No effect stands out, but the noise is {before.gap:.2f} times what is"
        " stated, or a part of it is.",
    }
    return texts[verdict]


def notes_of(
    engine: Engine, noise: NoiseFloor, verdict: str, smallest: tuple[Smallest, ...]
) -> tuple[Note, ...]:
    """Doubts about floor, reference values and what is invisible in principle."""
    found = [*engine.problem.notes]

    def say(severity: Severity, subject: str, text: str) -> None:
        found.append(Note(severity, subject, text))

    if noise.source != "replicates":
        told = {
            "y_se": "standard errors and certificates, not from replicates",
            "residual": "the residuals alone, for neither replicates nor standard errors are there",
        }[noise.source]
        say(
            Severity.WARNING,
            "floor_not_measured",
            f"the noise floor is from {told}; measure every position twice",
        )
    for name, ratio in _large(noise.ratios):
        say(
            Severity.WARNING,
            "excess_noise",
            f"the part {name!r} of the noise is {ratio:.1f} times what is stated or usual",
        )
    if engine.problem.run.test != "rate_table":
        say(
            Severity.INFO,
            "invisible_in_principle",
            "a wrong value of g, a common error of all angles and a tilt seen through one mounting"
            " alone hide in scale factor, misalignment and bias; no number of rows shows them",
        )
    else:
        say(
            Severity.INFO,
            "invisible_in_principle",
            "an error of the table's speed in proportion to the rate hides in the scale factor;"
            " only its period shows it",
        )
    temperature = engine.problem.stimulus.columns.get("temperature_c")
    if temperature is not None and "scale_factor_temperature" in {s.effect for s in smallest}:
        mean = float(cast(float, temperature.mean()))
        say(Severity.INFO, "reference_temperature", f"temperatures count from {mean:.2f} degC")
    if verdict in ("explained", "ambiguous"):
        say(
            Severity.INFO,
            "not_yet_confirmed",
            "named, not yet confirmed: only a new series with other angles or order confirms it",
        )
    return tuple(found)


def doubted(
    steps: tuple[Step, ...],
    noise: NoiseFloor,
    left: tuple[Where, ...],
    alpha: float,
    limits: Limits = USUAL,
    *,
    imitated: bool = False,
) -> tuple[Step, ...]:
    """The steps, in doubt if structure is left, noise too large, or the last is but a guess.

    Two or three effects can imitate a curve that the catalogue does not know; what they leave is
    the only trace of it, or that one curve does nearly as much as they do together (`imitated`).
    Which of them is wrong then nobody can say; what stands out by far is not in doubt.
    """
    rest = min((one.p_value for one in left if one.regressor not in _NAMED), default=1.0)
    if not steps:
        return steps
    last = steps[-1]
    guessed = not last.added_by_hand and last.p_value > 2.0 * alpha
    uncertain = rest <= limits.left_over or _excess(noise, last.after, limits)
    if not (uncertain or guessed or imitated):
        return steps

    def doubtful(step: Step) -> bool:
        return step is last or imitated or (uncertain and limits.every and step.evidence < _GROSS)

    return tuple(_or_unknown(step) if doubtful(step) else step for step in steps)


def _or_unknown(step: Step) -> Step:
    if step.added_by_hand or UNKNOWN in (step.effect, *step.indistinguishable_from):
        return step
    return replace(step, indistinguishable_from=(*step.indistinguishable_from, UNKNOWN))


def _excess(noise: NoiseFloor, after: Gap, limits: Limits) -> bool:
    return bool(_large(noise.ratios)) or is_excess(after, noise, limits)


def is_excess(gap: Gap, noise: NoiseFloor, limits: Limits = USUAL) -> bool:
    """Whether so large a gap cannot be an unlucky statement of the noise.

    Where the sizes of the noise were found from many contrasts, they cannot be far off.
    """
    if gap.dof < 1:
        return False
    found = noise.source != "residual" and noise.dof >= _MANY
    beyond = f_sf(gap.chi2_red, gap.dof, _MUCH) < _BEYOND
    return (gap.p_value < limits.excess_p and gap.gap > limits.excess_gap) or (
        found and beyond and gap.gap > _LARGE_FOUND
    )


def _large(ratios: Mapping[str, float]) -> list[tuple[str, float]]:
    return [(name, ratio) for name, ratio in ratios.items() if ratio > _LARGE]
