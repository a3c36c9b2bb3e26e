"""Say what the model of FILE (a session's folder, a run file, a legacy text file) lacks.

The plain model of the test is compared with the rows; effects of the catalogue that explain what is
left are named one by one, with what cannot be told from them and what to measure next.
"""

import argparse
from dataclasses import replace
from pathlib import Path

from core.discrepancy.ladder import explain
from core.discrepancy.result import Explanation, Fitted, Step
from core.discrepancy.settings import Settings
from core.discrepancy.to_json import explanation_to_json
from core.records.open import read_any
from gui.commands.answer import Answer
from gui.commands.conditions import add_conditions, conditions_of
from gui.commands.fitted import note_lines

_REGRESSORS = 5
_SMALLEST = 12


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file, the output, and how hard to look."""
    parser.add_argument("file", type=Path)
    parser.add_argument("--sensor", choices=["accelerometer", "gyro"], help="where a file has both")
    parser.add_argument(
        "--mount", action="append", metavar="MOUNT", help="mounts of a file that does not say them"
    )
    parser.add_argument("--max-effects", type=int, default=4, metavar="N", help="most steps (4)")
    parser.add_argument(
        "--alpha",
        type=float,
        default=0.01,
        metavar="A",
        help="probability that clean data give a name (0.01)",
    )
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Compare, name, and say what to do next."""
    measured = read_any(args.file, sensor=args.sensor, mounts=args.mount)
    conditions, _ = conditions_of(args, measured.conditions)
    settings = Settings(alpha=args.alpha, max_effects=args.max_effects)
    story = explain(replace(measured, conditions=conditions), settings)
    text = "\n".join([f"{args.file}: {story.verdict}", *_lines(story)])
    return Answer(explanation_to_json(story), text)


def _lines(story: Explanation) -> list[str]:
    lines = [f"  {story.summary}"]
    if story.verdict == "not_enough_data":
        return lines
    noise = story.noise
    parts = ", ".join(f"{name} {size:.3g}" for name, size in noise.components.items())
    lines.append(f"  noise floor {noise.sigma:.4g} {noise.unit} from {noise.source} ({parts})")
    lines.append("  where (adjusted p)")
    lines += [
        f"    {where.regressor:<14} p = {where.p_value:.3f}  {where.share:4.0%} of the excess,"
        f" {where.worst_sigma:+.1f} sigma at {where.worst_value:.6g} {where.unit}".rstrip()
        for where in story.where[:_REGRESSORS]
    ]
    lines.append(f"  {'model':<34} {'gap':>6} {'held out':>9} {'rms':>11}")
    before = story.before
    lines.append(_rung("plain model", before.gap, story.held_out_before, before.rms))
    for step in story.steps:
        lines += _step_lines(step)
    for following in story.next_measurements:
        lines.append(
            f"  next: {following.title} ({following.why}); decides with"
            f" {following.probability:.0%}, {following.minutes:.0f} min"
        )
    if story.verdict in ("adequate", "excess_noise"):
        lines.append("  smallest sizes that these rows would have named")
        lines += [
            f"    {each.effect:<28} {each.size:>10.3g} {each.unit}"
            for each in story.smallest[:_SMALLEST]
        ]
    if story.invisible:
        lines.append(f"  invisible in this plan: {', '.join(story.invisible)}")
    for effect, column in story.untested.items():
        lines.append(f"  not tested, for {column} is missing: {effect}")
    return lines + note_lines(story.notes, "  ")


def _step_lines(step: Step) -> list[str]:
    after = step.after
    lines = [_rung(f"+ {step.effect}", after.gap, step.held_out_gap_after, after.rms)]
    lines.append(f"      {step.name}: {step.plain}")
    lines += [f"      {_number(each)}" for each in step.parameters]
    lines.append(f"      probability {step.probability:.2f}, p = {step.p_value:.3f}")
    if step.indistinguishable_from:
        lines.append(f"      cannot be told from: {', '.join(step.indistinguishable_from)}")
    lines.append(f"      {step.advice}")
    return lines


def _rung(name: str, gap: float, held_out: float, rms: float) -> str:
    return f"  {name:<34} {gap:>6.2f} {held_out:>9.2f} {rms:>11.4g}"


def _number(each: Fitted) -> str:
    if each.u != each.u:
        return f"{each.name} = {each.value:.6g} {each.unit}".rstrip()
    return f"{each.name} = {each.value:.5g} +- {each.u:.2g} {each.unit}"
