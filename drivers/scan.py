"""Who is at the other end: listen first, ask only when allowed.

Bytes that nobody asked for can set foreign hardware up anew, so the caller has asked the operator
before `active` is true.
"""

import threading
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from core.errors import LinkError
from core.samples.block import SampleBlock
from drivers.commands import identify
from drivers.decoders import Decoder, make_decoder
from drivers.events import Event, Garbage, Message
from drivers.profile import Profile
from drivers.profile_types import PortSettings
from drivers.transport import Transport, UnfitSettings, open_port

_ENOUGH = 5
_PLENTY = 40
_SPEEDS_OF_SILENCE = 2
_NEVER = threading.Event()
# Ports that pass bytes on at whatever speed.
_SPEEDLESS = ("socket://",)


@dataclass(frozen=True, slots=True)
class Found:
    """A device at a port.

    Parameters
    ----------
    url, baud : where
    profile : what it speaks
    frames : valid frames heard; 0 if it only answered
    share : part of the bytes heard that its profile explains, 0 to 1
    identity : ``serial``, ``model``, ``firmware``, as far as it was asked and answered
    """

    url: str
    baud: int
    profile: Profile
    frames: int
    share: float
    identity: Mapping[str, str]

    @property
    def name(self) -> str:
        """What it calls itself, or else the name of its profile."""
        return self.identity.get("serial") or self.identity.get("model") or self.profile.name


@dataclass(frozen=True, slots=True)
class ScanReport:
    """What a scan brought.

    Parameters
    ----------
    found : likeliest first for each port; several where several profiles fit alike
    refused : ports that did not open or vanished, with the reason
    silent : ports from which nothing came at all
    strange : ports from which bytes came that no profile explains
    """

    found: tuple[Found, ...]
    refused: tuple[LinkError, ...]
    silent: tuple[str, ...]
    strange: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class ScanStep:
    """How far a scan is: step `done` of `total` begins, at this port and speed."""

    done: int
    total: int
    url: str
    baud: int


@dataclass(frozen=True, slots=True)
class _Job:
    """One opening of a port: a speed and the profiles that know it."""

    baud: int
    settings: PortSettings
    profiles: tuple[Profile, ...]


def scan(
    urls: Sequence[str],
    profiles: Iterable[Profile],
    *,
    listen_s: float = 1.0,
    active: bool = False,
    cancel: threading.Event = _NEVER,
    progress: Callable[[ScanStep], None] | None = None,
) -> ScanReport:
    """Find out what is at each port; for a worker thread.

    Each speed that some profile knows is listened to until five valid frames came; a port that
    brings no byte at two speeds is silent at all of them. Only if `active`, devices that were
    heard are asked for their names, and ports where none was heard are asked with the questions
    of all profiles.

    Parameters
    ----------
    urls : the ports
    profiles : what may be there
    listen_s : time for each speed
    active : whether anything may be sent
    cancel : set from another thread, ends the scan with what was found so far
    progress : called in this thread before each step
    """
    jobs = _jobs(list(profiles))
    total = len(urls) * len(jobs) * (2 if active else 1)
    found: list[Found] = []
    refused: list[LinkError] = []
    silent: list[str] = []
    strange: list[str] = []
    for number, url in enumerate(urls):
        begun = number * (total // len(urls))
        visit = _Visit(url, listen_s, active, cancel, progress, begun, total)
        here = visit.run(jobs[:1] if url.startswith(_SPEEDLESS) else jobs)
        found.extend(here)
        if cancel.is_set():
            break
        if here:
            continue
        if visit.refusal is not None:
            refused.append(visit.refusal)
        else:
            (strange if visit.bytes_heard else silent).append(url)
    return ScanReport(tuple(found), tuple(refused), tuple(silent), tuple(strange))


class _Visit:
    """The scan of one port."""

    def __init__(
        self,
        url: str,
        listen_s: float,
        active: bool,
        cancel: threading.Event,
        progress: Callable[[ScanStep], None] | None,
        begun: int,
        total: int,
    ) -> None:
        self.refusal: LinkError | None = None
        self.bytes_heard = 0
        self._url = url
        self._listen_s = listen_s
        self._active = active
        self._cancel = cancel
        self._progress = progress
        self._step = begun
        self._total = total
        self._opened = False
        self._hopeless = False

    def run(self, jobs: Sequence[_Job]) -> list[Found]:
        """Listen at all speeds, then ask at all speeds."""
        for action in (self._hear, self._question) if self._active else (self._hear,):
            for number, job in enumerate(jobs):
                if self._hopeless or self._cancel.is_set():
                    return []
                # A device that sends is heard at any speed, if only as garbage.
                if action == self._hear and number >= _SPEEDS_OF_SILENCE and not self.bytes_heard:
                    break
                found = self._at(job, action)
                if found:
                    return found
        return []

    def _at(self, job: _Job, action: Callable[[Transport, _Job], list[Found]]) -> list[Found]:
        """Open the port at one speed and do something there."""
        if self._progress is not None:
            self._progress(ScanStep(self._step, self._total, self._url, job.baud))
        self._step += 1
        try:
            transport = open_port(self._url, job.settings, job.baud)
        except LinkError as error:
            # An adapter that does not know one speed may know the next.
            self._hopeless = not isinstance(error, UnfitSettings)
            if self._hopeless or not self._opened:
                self.refusal = error
            return []
        self._opened, self.refusal = True, None
        try:
            return action(transport, job)
        except LinkError as error:
            self.refusal, self._hopeless = error, True
            return []
        finally:
            transport.close()

    def _hear(self, transport: Transport, job: _Job) -> list[Found]:
        ears = [_Ear(profile) for profile in job.profiles]
        began = time.monotonic()
        heard = 0
        while not self._cancel.is_set():
            # Only a device that is still silent may need its time to wake up.
            settle_s = 0.0 if heard else job.settings.settle_ms / 1000.0
            if time.monotonic() - began > self._listen_s + settle_s:
                break
            data = transport.read()
            heard += len(data)
            for ear in ears:
                ear.take(data)
            if any(ear.frames >= _PLENTY for ear in ears):
                break
        self.bytes_heard += heard
        found = _likeliest(self._url, job.baud, ears)
        if self._active:
            found = [
                replace(one, identity=identify(transport, one.profile, self._cancel))
                for one in found
            ]
        return found

    def _question(self, transport: Transport, job: _Job) -> list[Found]:
        for profile in job.profiles:
            said = identify(transport, profile, self._cancel)
            if said:
                return [Found(self._url, job.baud, profile, 0, 0.0, said)]
        return []


class _Ear:
    """One profile listening."""

    def __init__(self, profile: Profile) -> None:
        self.profile = profile
        self.frames = 0
        self.foreign = 0
        self.bytes = 0
        self.unexplained = 0
        self._decoder: Decoder = make_decoder(profile)

    def take(self, data: bytes) -> None:
        """Listen to some bytes."""
        self.bytes += len(data)
        for event in self._decoder.feed(data):
            self._count(event)

    def _count(self, event: Event) -> None:
        match event:
            case SampleBlock():
                self.frames += len(event.index)
            case Garbage():
                self.unexplained += event.count
            case Message(kind="text"):
                self.unexplained += len(event.payload)
            case Message():
                self.foreign += 1
            case _:
                pass

    @property
    def share(self) -> float:
        """Part of the bytes that the profile explains."""
        return max(0.0, 1.0 - self.unexplained / self.bytes) if self.bytes else 0.0


def _likeliest(url: str, baud: int, ears: Sequence[_Ear]) -> list[Found]:
    """The profiles that explain what was heard; best first, worse ones left out.

    A profile whose messages came, if none that it can decode, counts when no other does better.
    """
    heard = [ear for ear in ears if ear.frames >= _ENOUGH]
    if not heard:
        return [
            Found(url, baud, ear.profile, ear.foreign, ear.share, {})
            for ear in ears
            if ear.foreign >= _ENOUGH and ear.share > 0.5
        ]
    best = max(ear.share for ear in heard)
    heard = [ear for ear in heard if ear.share > best / 2]
    heard.sort(key=lambda ear: (-round(ear.share, 1), -ear.frames))
    return [Found(url, baud, ear.profile, ear.frames, ear.share, {}) for ear in heard]


def _jobs(profiles: Sequence[Profile]) -> list[_Job]:
    """All speeds with the profiles that know them, the speeds of most profiles first."""
    rank: dict[tuple[int, int, str], int] = {}
    users: dict[tuple[int, int, str], list[Profile]] = {}
    for profile in profiles:
        port = profile.port
        for place, baud in enumerate(port.bauds):
            key = (baud, port.data_bits, port.parity)
            users.setdefault(key, []).append(profile)
            rank[key] = rank.get(key, 0) - (100 if place == 0 else 1)
    return [
        _Job(key[0], _gentle(users[key]), tuple(users[key]))
        for key in sorted(users, key=lambda key: rank[key])
    ]


def _gentle(profiles: Sequence[Profile]) -> PortSettings:
    """Settings for listening: lines down, unless some device needs them up."""
    first = profiles[0].port
    return replace(
        first,
        settle_ms=max(profile.port.settle_ms for profile in profiles),
        dtr=any(profile.port.dtr for profile in profiles),
        rts=any(profile.port.rts for profile in profiles),
    )
