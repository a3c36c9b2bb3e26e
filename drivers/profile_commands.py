"""The [[command]] sections of a device file."""

import re
from collections.abc import Sequence

import numpy as np

from drivers.checksums import Checksum, ChecksumSpec
from drivers.profile_sections import ENDIANS, LONGEST_FRAME, doubtful, read_hex
from drivers.profile_types import Capture, Command
from drivers.toml_table import Table


def _capture(table: Table) -> dict[str, Capture]:
    captures: dict[str, Capture] = {}
    for name in table.keys():  # noqa: SIM118
        inner = table.table(name)
        captures[name] = Capture(
            at=inner.integer("at", high=LONGEST_FRAME),
            type=inner.choice("type", ("ascii", "hex", "uint")),
            size=inner.integer("size", low=1, high=256),
            endian=inner.choice("endian", ENDIANS, "little"),
        )
        inner.done()
    return captures


def _with_checksum(table: Table, data: bytes, checksum: ChecksumSpec | None) -> bytes:
    if checksum is None:
        table.fail("append_checksum", "the frame has no checksum to append")
    doubt = doubtful(checksum, len(data) + checksum.size)
    if doubt or checksum.at != -checksum.size:
        table.fail("append_checksum", doubt or "the checksum is not at the end of a frame")
    whole = np.frombuffer(data + bytes(checksum.size), dtype=np.uint8).reshape(1, -1).copy()
    Checksum(checksum).stamp(whole)
    return whole.tobytes()


def _command(table: Table, checksum: ChecksumSpec | None) -> Command:
    name = table.text("name")
    if table.has("hex") == table.has("ascii"):
        table.fail("name", "a command needs either hex or ascii")
    if table.has("hex"):
        data = read_hex(table, "hex", table.text("hex"))
    else:
        data = table.text("ascii").encode("ascii", errors="replace")
    if not data:
        table.fail("name", "a command needs at least one byte")
    if table.flag("append_checksum", False):
        data = _with_checksum(table, data, checksum)
    expect = table.text("expect", "")
    try:
        re.compile(expect)
    except re.error as error:
        table.fail("expect", f"is no regular expression: {error}")
    command = Command(
        name,
        data,
        repeat=table.integer("repeat", 1, low=1, high=100),
        gap_ms=table.integer("gap_ms", 0, high=10_000),
        wait_ms=table.integer("wait_ms", 200, high=60_000),
        expect=expect,
        expect_bytes=read_hex(table, "expect_hex", table.text("expect_hex", "")),
        capture=_capture(table.table("capture")),
    )
    table.done()
    return command


def read_commands(tables: Sequence[Table], checksum: ChecksumSpec | None) -> dict[str, Command]:
    """Read the [[command]] sections."""
    commands: dict[str, Command] = {}
    for table in tables:
        command = _command(table, checksum)
        if command.name in commands:
            table.fail("name", f'"{command.name}" is used twice')
        commands[command.name] = command
    return commands
