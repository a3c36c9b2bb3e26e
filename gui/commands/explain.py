"""Say what the model of FILE lacks.

FILE is a session's folder, a run file, a legacy text file, or a long record: a recording, a file
of CVGCom, a run file of a record.

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
from core.errors import FormatError
from core.records.cvgcom import is_cvgcom
from core.records.open import read_any
from core.records.series_run import sampled_run, with_first
from core.samples.run import Run
from drivers.records import is_recording
from drivers.series import read_series
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
    parser.add_argument(
        "--report", type=Path, metavar="OUT", help="the whole story as OUT.html or OUT.pdf"
    )
    parser.add_argument(
        "--channel", default="", help="output of a record (its first): name, role or number"
    )
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Compare, name, and say what to do next."""
    measured = _read(args)
    conditions, _ = conditions_of(args, measured.conditions)
    settings = Settings(alpha=args.alpha, max_effects=args.max_effects)
    measured = replace(measured, conditions=conditions)
    story = explain(measured, settings)
    lines = [f"{args.file}: {story.verdict}", *_lines(story)]
    if args.report is not None:
        _write_report(measured, story, args.file, args.report)
        lines.append(f"  report in {args.report}")
    text = "\n".join(lines)
    return Answer(explanation_to_json(story), text)


def _write_report(measured: Run, story: Explanation, source: Path, path: Path) -> None:
    """Write the story for paper or a browser; only this needs Qt."""
    if path.suffix.lower() not in (".html", ".pdf"):
        raise FormatError(path, "a report ends in .html or .pdf")
    from gui.discrepancy.paper_view import an_application
    from gui.discrepancy.report import write_report
    from gui.discrepancy.working import Story

    application = an_application()
    write_report(Story(measured, (source,), None, story), path)
    application.processEvents()


def _read(args: argparse.Namespace) -> Run:
    """The rows of a test, or the samples of a record with the output first that is asked for."""
    path: Path = args.file
    if path.is_file() and (is_recording(path) or is_cvgcom(path)):
        return sampled_run(read_series(path), args.channel, args.sensor or "")
    measured = read_any(path, sensor=args.sensor, mounts=args.mount)
    return with_first(measured, args.channel) if args.channel else measured


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
