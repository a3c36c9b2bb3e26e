"""Talking to a device: the commands of its profile, sent and their answers read."""

import re
import threading
import time
from collections.abc import Mapping

from drivers.profile import Profile
from drivers.profile_types import Capture, Command
from drivers.transport import Transport

_NEVER = threading.Event()
_PAUSE_S = 0.15


def send(transport: Transport, command: Command, cancel: threading.Event = _NEVER) -> None:
    """Send a command as often and with the pauses that its profile asks for.

    Raises
    ------
    LinkError
        The port does not take it.
    """
    for turn in range(command.repeat):
        if turn and cancel.wait(command.gap_ms / 1000.0):
            return
        transport.write(command.data)


def ask(
    transport: Transport, command: Command, cancel: threading.Event = _NEVER
) -> Mapping[str, str]:
    """Send a command and return what its answer says, by name; empty if none came in time.

    Raises
    ------
    LinkError
        The port is gone.
    """
    send(transport, command, cancel)
    heard = bytearray()
    until = time.monotonic() + command.wait_ms / 1000.0
    while time.monotonic() < until and not cancel.is_set():
        heard += transport.read()
        answer = answer_in(command, bytes(heard))
        if answer:
            return answer
    return {}


def identify(
    transport: Transport, profile: Profile, cancel: threading.Event = _NEVER
) -> Mapping[str, str]:
    """Return what a device says about itself: ``serial``, ``model``, ``firmware`` as far as known.

    A device that can be stopped and started is stopped meanwhile, so that its answer does not
    drown; one that cannot be started again is asked while it streams. Empty if the profile knows
    no question or no answer came.

    Raises
    ------
    LinkError
        The port is gone.
    """
    questions = [c for c in profile.commands.values() if c.expect or c.expect_bytes]
    if not questions:
        return {}
    stop, start = profile.commands.get("stop"), profile.commands.get("start")
    said: dict[str, str] = {}
    if stop is not None and start is not None:
        send(transport, stop, cancel)
        _hush(transport, cancel)
    for question in questions:
        said |= ask(transport, question, cancel)
    if stop is not None and start is not None:
        send(transport, start)
    return said


def answer_in(command: Command, heard: bytes) -> Mapping[str, str]:
    """Return what the answer to a command says, if it is among these bytes; else empty."""
    if command.expect:
        match = re.search(command.expect, heard.decode("latin-1"))
        if match is None:
            return {}
        return {name: text.strip() for name, text in match.groupdict().items() if text}
    at = heard.find(command.expect_bytes) if command.expect_bytes else -1
    while at >= 0:
        pieces = {name: _piece(heard[at:], where) for name, where in command.capture.items()}
        if all(text is not None for text in pieces.values()):
            return {name: text for name, text in pieces.items() if text}
        at = heard.find(command.expect_bytes, at + 1)
    return {}


def _piece(answer: bytes, where: Capture) -> str | None:
    """Return a piece of a binary answer as text; None if it has not come or cannot be that."""
    raw = answer[where.at : where.at + where.size]
    if len(raw) < where.size:
        return None
    if where.type == "hex":
        return raw.hex()
    if where.type == "uint":
        return str(int.from_bytes(raw, "big" if where.endian == "big" else "little"))
    text = raw.rstrip(b"\0 ").decode("latin-1")
    return text if text.isprintable() else None


def _hush(transport: Transport, cancel: threading.Event) -> None:
    """Let what was under way arrive, and forget it."""
    until = time.monotonic() + _PAUSE_S
    while time.monotonic() < until and not cancel.is_set():
        transport.read()
