"""Which subcommands there are, and the one way in which all of them run."""

import argparse
import importlib
import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, cast

from core.errors import LabError
from core.records.atomic import write_text_atomic

if TYPE_CHECKING:
    from gui.commands.answer import Answer

REFUSED = 2
"""Exit code where the work could not be done; argparse uses the same for wrong arguments."""
INTERRUPTED = 130
"""Exit code after Ctrl+C, as shells have it."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One line of the table: the module to import when the name is called, and its help."""

    module: str
    help: str


COMMANDS = {
    "ports": Entry("gui.commands.ports", "list the serial ports, the likeliest device first"),
    "scan": Entry("gui.commands.scan", "find out which device is at which port"),
    "record": Entry("gui.commands.record", "record the raw bytes of a device"),
    "teach": Entry("gui.commands.teach", "describe an unknown board from its raw bytes"),
    "fit": Entry("gui.commands.fit", "calibrate from measured positions and rates"),
    "accuracy": Entry("gui.commands.accuracy", "check pitch and roll against set angles"),
    "allan": Entry("gui.commands.allan", "Allan deviation and noise coefficients of records"),
    "export": Entry("gui.commands.export", "write a calibration as JSON, C header, MATLAB or CSV"),
    "convert": Entry("gui.commands.convert", "convert between legacy files, run files, sessions"),
    "archive": Entry("gui.commands.archive", "find, compare, follow everything that was measured"),
    "certificate": Entry("gui.commands.certificate", "issue a calibration certificate"),
    "demo": Entry("gui.commands.demo", "measure a session in the window, by itself"),
    "means": Entry("gui.commands.means", "average the records of a folder"),
    "simulate": Entry("gui.commands.simulate", "measure a session on the simulated rig"),
    "tumble": Entry("gui.commands.tumble", "turn one accelerometer through all angles"),
    "six-position": Entry("gui.commands.six_position", "split a triad into k, T and mounting"),
    "thermal": Entry("gui.commands.thermal", "calibrate over temperature"),
    "drift": Entry("gui.commands.drift", "compensate the drift after switching on"),
    "gyrocompass": Entry("gui.commands.gyrocompass", "find north with a gyro"),
    "explain": Entry("gui.commands.explain", "find the effect that a model lacks"),
    "predict": Entry("gui.commands.predict", "say which procedure, and how well, beforehand"),
}


class CommandModule(Protocol):
    """What a module of this package offers."""

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        """Add the arguments of this subcommand; ``--json`` is added for it."""
        ...

    def run(self, args: argparse.Namespace) -> "Answer":
        """Do the work; a `LabError` goes through."""
        ...


def run_command(name: str, arguments: Sequence[str]) -> int:
    """Run the subcommand `name` of `COMMANDS` and return the exit code.

    Raises
    ------
    SystemExit
        After ``--help`` and after arguments that cannot be understood.
    """
    entry = COMMANDS[name]
    module = cast("CommandModule", importlib.import_module(entry.module))
    parser = argparse.ArgumentParser(
        prog=f"calrig {name}",
        description=entry.help[0].upper() + entry.help[1:] + ".",
        epilog=module.__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    module.add_arguments(parser)
    parser.add_argument(
        "--json", metavar="OUT", help="write the result as JSON to OUT; '-' is standard output"
    )
    args = parser.parse_args(arguments)
    try:
        answer = module.run(args)
        _give(answer, args.json)
    except BrokenPipeError:
        # The reader of our output (`| head`) has had enough; Python must not flush into it at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return REFUSED
    except (LabError, OSError) as error:
        print(f"calrig {name}: {_one_line(error)}", file=sys.stderr)
        return REFUSED
    except KeyboardInterrupt:
        print(f"calrig {name}: interrupted", file=sys.stderr)
        return INTERRUPTED
    return answer.code


def _give(answer: "Answer", out: str | None) -> None:
    from core.records.json_text import to_json

    if out == "-":
        sys.stdout.write(to_json(answer.data, ascii_only=True))
    else:
        if out is not None:
            write_text_atomic(Path(out), to_json(answer.data))
        # A console of another code page shows \N escapes rather than stopping half-way.
        encoding = sys.stdout.encoding or "utf-8"
        print(answer.text.encode(encoding, "backslashreplace").decode(encoding))
    sys.stdout.flush()


def _one_line(error: Exception) -> str:
    if isinstance(error, OSError) and error.filename is not None and error.strerror:
        return f"{error.filename}: {error.strerror}"
    return " ".join(str(error).split())
