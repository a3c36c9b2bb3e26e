"""One verdict, said in words."""

from collections.abc import Mapping
from dataclasses import replace
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
_EXCESS_P = 1e-3
_MANY, _LARGE_FOUND, _MUCH = 30, 1.35, 1e6
_LEFT_OVER = 0.02
FEWEST = 3
"""Degrees of freedom below which nothing is said."""


def verdict_of(steps: tuple[Step, ...], noise: NoiseFloor, after: Gap) -> str:
    """The verdict of a set of steps."""
    if any(step.effect == UNKNOWN for step in steps):
        return "unexplained_structure"
    if any(step.indistinguishable_from for step in steps):
        return "ambiguous"
    if steps:
        return "data_fault" if all(s.effect in _FAULTS for s in steps) else "explained"
    return "excess_noise" if _excess(noise, after) else "adequate"


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
    steps: tuple[Step, ...], noise: NoiseFloor, left: tuple[Where, ...], alpha: float
) -> tuple[Step, ...]:
    """The steps, the last in doubt if structure is left, noise too large, or it is but a guess.

    Two or three effects can imitate a curve that the catalogue does not know; what they leave is
    the only trace of it.
    """
    rest = min((where.p_value for where in left), default=1.0)
    if not steps:
        return steps
    last = steps[-1]
    guessed = not last.added_by_hand and last.p_value > 2.0 * alpha
    if rest > _LEFT_OVER and not _excess(noise, last.after) and not guessed:
        return steps
    if UNKNOWN in (last.effect, *last.indistinguishable_from):
        return steps
    names = (*last.indistinguishable_from, UNKNOWN)
    return (*steps[:-1], replace(last, indistinguishable_from=names))


def _excess(noise: NoiseFloor, after: Gap) -> bool:
    return bool(_large(noise.ratios)) or is_excess(after, noise)


def is_excess(gap: Gap, noise: NoiseFloor) -> bool:
    """Whether so large a gap cannot be an unlucky statement of the noise.

    Where the sizes of the noise were found from many contrasts, they cannot be far off.
    """
    if gap.dof < 1:
        return False
    found = noise.source != "residual" and noise.dof >= _MANY
    beyond = f_sf(gap.chi2_red, gap.dof, _MUCH) < _EXCESS_P / 10.0
    return (gap.p_value < _EXCESS_P and gap.gap > _LARGE) or (
        found and beyond and gap.gap > _LARGE_FOUND
    )


def _large(ratios: Mapping[str, float]) -> list[tuple[str, float]]:
    return [(name, ratio) for name, ratio in ratios.items() if ratio > _LARGE]
