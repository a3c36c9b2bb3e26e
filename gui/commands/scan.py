"""Listening comes first; without a port all ports are scanned.

Only with ``--ask`` anything is sent, since bytes that nobody asked for can set foreign hardware up
anew; devices are then asked for their names.
"""

import argparse
import sys

from drivers.ports import list_ports
from drivers.profile import load_profiles
from drivers.scan import Found, ScanReport, ScanStep, scan
from gui.commands.answer import Answer


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the ports and the manner of asking."""
    parser.add_argument("port", nargs="*", help="COM4, /dev/ttyUSB0, sim://clbacc, ...")
    parser.add_argument("--ask", action="store_true", help="also send identify commands")
    parser.add_argument(
        "--listen", type=float, default=1.0, metavar="S", help="seconds at each speed (1)"
    )


def run(args: argparse.Namespace) -> Answer:
    """Find out what is at each port."""
    urls = args.port or [port.url for port in list_ports() if port.kind != "simulated"]
    report = scan(
        urls,
        load_profiles().values(),
        listen_s=args.listen,
        active=args.ask,
        progress=_tell,
    )
    return Answer(_plain(report), "\n".join(_lines(report)), 0 if report.found else 1)


def _tell(step: ScanStep) -> None:
    print(f"{step.done + 1} of {step.total}: {step.url} at {step.baud} baud", file=sys.stderr)


def _plain(report: ScanReport) -> dict[str, object]:
    return {
        "found": [_device(found) for found in report.found],
        "refused": [
            {"port": error.port, "why": error.why, "remedy": error.remedy}
            for error in report.refused
        ],
        "silent": report.silent,
        "strange": report.strange,
    }


def _device(found: Found) -> dict[str, object]:
    return {
        "port": found.url,
        "baud": found.baud,
        "profile": found.profile.id,
        "name": found.name,
        "frames": found.frames,
        "share": found.share,
        "identity": found.identity,
    }


def _lines(report: ScanReport) -> list[str]:
    lines = [
        f"{found.url}  {found.baud} baud  {found.name}  (profile {found.profile.id},"
        f" {found.share:.0%} of the bytes explained)"
        for found in report.found
    ]
    lines += [str(error) for error in report.refused]
    lines += [f"{url}: silent; is the unit switched on?" for url in report.silent]
    lines += [f"{url}: sends bytes that no profile explains" for url in report.strange]
    return lines or ["No port to scan."]
