"""FILE is a run of one accelerometer through a turn of the dividing head, at any angles.

The file may hold two mounts, the second with the sensor turned over about its input axis: then
fixture and sensor are told apart. The split (18) of the source is printed where the second
harmonic allows it.
"""

import argparse
from pathlib import Path

from core.errors import FitError
from core.fit.estimate import Estimate
from core.procedures.fourier.flip import Flip
from core.procedures.fourier.pairs import TurnPair, turn_pairs
from core.procedures.fourier.split import Split
from core.procedures.fourier.study import TumbleRequest, study_tumble
from core.procedures.fourier.tumble import TumbleResult
from core.procedures.propagation import Spread
from core.records.open import read_any
from gui.commands.answer import Answer
from gui.commands.conditions import KYIV_G_MPS2, add_conditions, conditions_of
from gui.commands.fitted import estimate_text, note_lines


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file, the output, and what to fit."""
    parser.add_argument("file", type=Path)
    parser.add_argument(
        "--channel", type=int, default=1, metavar="N", help="which output, from 1 (1)"
    )
    parser.add_argument(
        "--harmonics", type=int, choices=(2, 3), default=2, help="highest harmonic (2)"
    )
    parser.add_argument(
        "--remove-drift", action="store_true", help="fit a steady drift along with the series"
    )
    parser.add_argument(
        "--gravity-projection",
        action="store_true",
        help="signs of k_x and k_y as in the source, which projects gravity",
    )
    parser.add_argument("--pairs", action="store_true", help="also the test turns (4) to (11)")
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Fit every mount of the file; of two, separate fixture and sensor."""
    measured = read_any(args.file, sensor="accelerometer")
    if not 1 <= args.channel <= len(measured.channels):
        names = ", ".join(measured.channels)
        raise FitError(f"{args.file}: no output {args.channel}; there are: {names}")
    conditions, assumed = conditions_of(args, measured.conditions)
    request = TumbleRequest(
        args.channel - 1, args.harmonics, args.remove_drift, args.gravity_projection
    )
    found = study_tumble(measured, conditions, request)
    data: dict[str, object] = {
        "file": args.file,
        "g_mps2": conditions.g_mps2,
        "tumbles": found.tumbles,
    }
    lines: list[str] = []
    for mount, result in zip(found.mounts, found.tumbles, strict=True):
        lines += _report(f"{args.file}: {measured.device}, {mount}", result)
    if found.flip is not None:
        data["flip"] = found.flip
        lines += _flip_lines(found.flip)
    if found.split is not None:
        data["split"] = found.split
        lines += _split_lines(found.split)
    if args.pairs:
        pairs = turn_pairs(measured, conditions, channel=args.channel - 1)
        data["pairs"] = pairs
        lines += _pair_lines(pairs)
    if assumed:
        lines.append(f"  g = {KYIV_G_MPS2} m/s^2 was assumed (Kyiv); state yours by --g")
    return Answer(data, "\n".join(lines))


def _report(title: str, result: TumbleResult) -> list[str]:
    lines = [
        title,
        f"  u = C0 + C1 sin a + C2 cos a + ..., a: elevation of {result.axis.upper()};"
        f" g = {result.g_mps2} m/s^2",
        f"  {estimate_text('C0', result.bias)}",
        f"  {estimate_text('k', result.sensitivity)}",
        f"  {estimate_text('d', result.misalignment)}   in the plane, fixture and sensor",
    ]
    for harmonic in result.harmonics[1:]:
        n = harmonic.order
        lines.append(f"  {estimate_text(f'sin {n}a', harmonic.sine)}")
        lines.append(f"  {estimate_text(f'cos {n}a', harmonic.cosine)}")
    if result.overlap is not None:
        drift = estimate_text("drift", result.overlap.drift)
        lines.append(f"  {drift}   over a full turn, {result.overlap.pairs} angles twice")
    return lines + note_lines(result.notes, "  ")


def _split_lines(parts: Split) -> list[str]:
    lines = ["  Split (18):" if parts.separable else "  Split (18), not separable:"]
    if parts.separable:
        named = (
            ("alpha0", parts.alpha0),
            ("k_x", parts.k_x),
            ("k_y", parts.k_y),
            ("k_xy", parts.k_xy),
        )
        lines += [f"    {_spread_text(symbol, spread)}" for symbol, spread in named]
    return lines + note_lines(parts.notes, "    ")


def _spread_text(symbol: str, spread: Spread) -> str:
    return (
        f"{symbol:<8} {spread.value:>14.8g}   {spread.low:.6g} ... {spread.high:.6g}"
        f" {spread.unit}  (95 %)"
    )


def _flip_lines(flip: Flip) -> list[str]:
    named: tuple[tuple[str, Estimate], ...] = (
        ("fixture", flip.fixture),
        ("sensor", flip.misalignment),
        ("U0", flip.bias),
        ("k", flip.k),
        ("k cross", flip.k_cross),
        ("k_xy", flip.product),
        ("K2", flip.quadratic),
    )
    return ["  Fixture and sensor apart:"] + [
        f"    {estimate_text(symbol, found)}" for symbol, found in named
    ]


def _pair_lines(pairs: tuple[TurnPair, ...]) -> list[str]:
    lines: list[str] = []
    for pair in pairs:
        lines.append(f"  {estimate_text(f'U0 ({pair.axis})', pair.bias)}")
        lines.append(f"  {estimate_text(f'k_{pair.axis}', pair.response)}")
    return lines
