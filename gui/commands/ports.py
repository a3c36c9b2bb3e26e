"""Simulated ports (``sim://...``) are listed last and can be opened like any other."""

import argparse

from drivers.ports import PortInfo, list_ports
from gui.commands.answer import Answer


def add_arguments(_parser: argparse.ArgumentParser) -> None:
    """Add nothing: listing needs no choice."""


def run(_args: argparse.Namespace) -> Answer:
    """List the ports of this machine and the simulated ones."""
    ports = list_ports()
    return Answer({"ports": ports}, "\n".join(_lines(ports)))


def _lines(ports: tuple[PortInfo, ...]) -> list[str]:
    rows = [(port.url, port.kind, port.text) for port in ports]
    url, kind = (max(len(row[column]) for row in rows) for column in (0, 1))
    lines = [f"{row[0]:<{url}}  {row[1]:<{kind}}  {row[2]}" for row in rows]
    if all(port.kind == "simulated" for port in ports):
        lines.insert(0, "No serial port was found on this machine.")
    return lines
