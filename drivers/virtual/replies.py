"""What a unit on the rig does with the commands of its profile."""

from collections.abc import Mapping

import numpy as np

from drivers.checksums import Checksum
from drivers.profile import Profile
from drivers.profile_types import Command, FrameSpec, LengthSpec

_MEMORY = 256


class Answering:
    """Stops, starts and tells who it is.

    Parameters
    ----------
    profile : whose commands it understands
    identity : ``serial``, ``model``, ``firmware``
    reply_bytes : length of its answer to an identify command; 0 if it has none
    """

    def __init__(self, profile: Profile, identity: Mapping[str, str], reply_bytes: int) -> None:
        self.streaming = True
        self._profile = profile
        self._identity = identity
        self._reply_bytes = reply_bytes
        self._heard = b""
        self._replies = bytearray()

    def receive(self, data: bytes) -> None:
        """Take bytes from the computer; commands may come in pieces, among anything else."""
        self._heard += data
        while True:
            places = [
                (self._heard.find(command.data), command)
                for command in self._profile.commands.values()
            ]
            at, command = min(
                (place for place in places if place[0] >= 0),
                key=lambda place: place[0],
                default=(-1, None),
            )
            if command is None:
                self._heard = self._heard[-_MEMORY:]
                return
            self._heard = self._heard[at + len(command.data) :]
            self._obey(command)

    def reply(self) -> bytes:
        """Return the answers that have not gone yet."""
        data = bytes(self._replies)
        self._replies.clear()
        return data

    def _obey(self, command: Command) -> None:
        if command.name.startswith("start"):
            self.streaming = True
        elif command.name.startswith("stop"):
            self.streaming = False
        elif command.expect_bytes and self._reply_bytes:
            self._replies += self._answer(command)

    def _answer(self, command: Command) -> bytes:
        row = np.zeros((1, self._reply_bytes), dtype=np.uint8)
        row[0, : len(command.expect_bytes)] = list(command.expect_bytes)
        for name, capture in command.capture.items():
            text = self._identity.get(name, "").encode("ascii")[: capture.size]
            row[0, capture.at : capture.at + len(text)] = list(text)
        stream = self._profile.stream
        if isinstance(stream, FrameSpec):
            if isinstance(stream.length, LengthSpec):
                field = stream.length
                told = (self._reply_bytes - field.add) // field.mul
                order = "little" if field.endian == "little" else "big"
                row[0, field.at : field.at + field.size] = list(told.to_bytes(field.size, order))
            if stream.checksum is not None:
                Checksum(stream.checksum).stamp(row)
        return row.tobytes()
