"""Starting a rig behind a pseudo-terminal and giving it orders: for the demo and for tests."""

import json
import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import cast

import drivers
from core.errors import LinkError

_END_S = 5.0


class PtyProcess:
    """A rig in a process of its own; a context manager.

    Parameters
    ----------
    url : the rig, e.g. ``"sim://clbacc?seed=3"``
    link : lasting name of its port; None for none

    Raises
    ------
    LinkError
        The process did not start.
    """

    def __init__(self, url: str, link: Path | None = None) -> None:
        command = [sys.executable, "-m", "drivers.virtual.pty_rig", url]
        if link is not None:
            command += ["--link", str(link)]
        root = Path(str(drivers.__file__)).parent.parent
        self._process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={**os.environ, "PYTHONPATH": str(root)},
        )
        self._url = url
        if self._process.stdin is None or self._process.stdout is None:
            raise LinkError(url, "the rig's process has no pipes")
        self._orders, self._answers = self._process.stdin, self._process.stdout
        try:
            first = self._answer()
        except LinkError:
            self.close()
            raise
        self.port = str(link or first["port"])
        """What to open."""

    def order(self, **order: object) -> Mapping[str, object]:
        """Give an order, e.g. ``order(turn=90)``, and return its answer.

        Raises
        ------
        ValueError
            The rig refused it.
        LinkError
            The process has ended.
        """
        try:
            self._orders.write(json.dumps(order).encode() + b"\n")
            self._orders.flush()
        except (OSError, ValueError) as error:
            raise LinkError(self._url, "the rig's process has ended") from error
        answer = self._answer()
        if "error" in answer:
            raise ValueError(str(answer["error"]))
        return answer

    def close(self) -> None:
        """End the process; may be called again."""
        for pipe in (self._orders, self._answers):
            pipe.close()
        try:
            self._process.wait(_END_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()

    def __enter__(self) -> "PtyProcess":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _answer(self) -> dict[str, object]:
        line = self._answers.readline()
        if not line:
            raise LinkError(self._url, "the rig's process has ended", "see its messages")
        return cast(dict[str, object], json.loads(line))
