"""The simulated rig: what a hand would do to the bench, and the bytes that the unit sends.

The rig lives in the thread that reads its port. The other threads give orders and look at
snapshots; orders are carried out before the next sample.
"""

import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from queue import SimpleQueue

import numpy as np

from core.arrays import IntArray
from core.plans.orientation import BaseOrientation, Mount
from drivers.decoders import make_decoder
from drivers.encode import encode
from drivers.profile import Profile, load_profiles
from drivers.virtual.bench import Bench, Manner, Place
from drivers.virtual.devices import Output, make_device
from drivers.virtual.faults import Faults, Line
from drivers.virtual.replies import Answering
from drivers.virtual.unit import Unit

_MOST = 4096
_Order = Callable[[Bench], None]


class Unplugged(Exception):
    """The cable of the rig is out."""


@dataclass(frozen=True, slots=True)
class RigOptions:
    """How a rig is made.

    Parameters
    ----------
    device : ``"clbacc"``, ``"pointer"``, ``"clbdus"`` or ``"cvg25"``
    seed : of all chance; the same seed gives the same bytes to the same orders
    rate_hz : samples per second; 0 for the device's own
    noise : multiplies all noise of the sensors
    cold : the unit has just been switched on
    place, manner : where the rig stands, how it moves
    effects : further effects by identifier, or ``ROLE/identifier`` for one output alone
    """

    device: str = "clbacc"
    seed: int = 1
    rate_hz: float = 0.0
    noise: float = 1.0
    cold: bool = False
    place: Place = field(default_factory=Place)
    manner: Manner = field(default_factory=Manner)
    effects: Mapping[str, tuple[float, ...]] = field(default_factory=dict[str, tuple[float, ...]])


@dataclass(frozen=True, slots=True)
class RigState:
    """What one sees of the rig.

    Parameters
    ----------
    time_s : time since the start, by the samples
    head_deg, head_target_deg : where the head stands, where it is going
    mount : how the unit is bolted on
    moving : whether anything is in motion
    table_dps, table_target_dps, axis : rate of the table; the case axis along its axis, empty on
        the head
    chamber_c, case_c : temperature of the chamber and of the unit
    base : how the base plate stands
    streaming, plugged : whether the unit sends, and is connected
    """

    time_s: float
    head_deg: float
    head_target_deg: float
    mount: str
    moving: bool
    table_dps: float
    table_target_dps: float
    axis: str
    chamber_c: float
    case_c: float
    base: BaseOrientation
    streaming: bool
    plugged: bool


class Rig:
    """A bench with one unit.

    Raises
    ------
    ValueError
        The options name an unknown device or effect.
    """

    def __init__(self, options: RigOptions) -> None:
        device = make_device(options.device, options.seed)
        for key, values in options.effects.items():
            device = device.with_effect(key, values)
        self.options = options
        self.profile: Profile = load_profiles()[device.profile_id]
        self.channels = make_decoder(self.profile).channels
        self.rate_hz = options.rate_hz or self.profile.nominal_hz
        shaking, noise, line = (
            np.random.default_rng([options.seed, stream]) for stream in range(3)
        )
        self._device = device
        self._bench = Bench(
            options.place,
            options.manner,
            self.rate_hz,
            shaking,
            timed=options.cold or device.timed,
        )
        self._unit = Unit(
            device, self.channels, self.rate_hz, noise, noise=options.noise, cold=options.cold
        )
        self._line = Line(line)
        self._answering = Answering(self.profile, device.identity, device.reply_bytes)
        self._orders: SimpleQueue[tuple[float, _Order]] = SimpleQueue()
        self._agenda: list[tuple[int, _Order]] = []
        self._faults = Faults()
        self._plugged = True
        self._next = 0
        self._port = threading.Lock()
        self._state = self._look()

    # What a hand does; `after_s` lets it begin later, in the time of the rig.

    def turn(self, head_deg: float, *, after_s: float = 0.0) -> None:
        """Turn the dividing head to an angle, the short way round."""
        self._order(after_s, lambda bench: bench.turn(head_deg))

    def remount(self, mount: str, *, after_s: float = 0.0) -> None:
        """Bolt the unit on another way, e.g. ``"Y_from"``; `ValueError` for an unknown mount."""
        Mount.parse(mount)
        self._order(after_s, lambda bench: bench.remount(mount))

    def spin(self, rate_dps: float, axis: str = "z", *, after_s: float = 0.0) -> None:
        """Put the unit on the rate table, a case axis along its axis, and turn it at a rate."""
        if axis not in ("x", "y", "z"):
            raise ValueError(f"axis {axis!r}; expected x, y or z")
        self._order(after_s, lambda bench: bench.spin(rate_dps, axis))

    def heat(self, chamber_c: float, *, after_s: float = 0.0) -> None:
        """Set the chamber to a temperature; the unit follows slowly."""
        self._order(after_s, lambda bench: bench.heat(chamber_c))

    def be_at(self, celsius: float) -> None:
        """Stand at a temperature, unit and all, as after hours in the chamber."""
        self._order(0.0, lambda bench: bench.be_at(celsius))

    def tilt_base(self, base: BaseOrientation) -> None:
        """Set the base plate of the head."""
        self._order(0.0, lambda bench: bench.tilt_base(base))

    def fail(self, faults: Faults) -> None:
        """Let things go wrong from now on; `Faults()` mends all."""
        self._faults = faults

    def unplug(self) -> None:
        """Pull the cable."""
        self._plugged = False
        self._state = replace(self._state, plugged=False)

    def plug_in(self) -> None:
        """Put the cable back."""
        self._plugged = True
        self._state = replace(self._state, plugged=True)

    # What one sees.

    @property
    def state(self) -> RigState:
        """The rig as it stood after the latest sample."""
        return self._state

    @property
    def identity(self) -> Mapping[str, str]:
        """What the unit tells of itself: ``serial``, ``model``, ``firmware``."""
        return self._device.identity

    def truth(self) -> tuple[Output, ...]:
        """The hidden truth: what each output does to its input, its bias with the drift so far."""
        pairs = zip(self._device.outputs, self._unit.drift, strict=True)
        return tuple(output.shifted(float(drift)) for output, drift in pairs)

    def damaged(self) -> IntArray:
        """Sample numbers of all frames that the faults kept from arriving whole."""
        return np.concatenate([*self._line.damaged, np.empty(0, dtype=np.int64)])

    # What its port does.

    def acquire(self) -> bool:
        """Take the one connection; False if another has it."""
        return self._port.acquire(blocking=False)

    def release(self) -> None:
        """Give the connection back."""
        self._port.release()

    def receive(self, data: bytes) -> None:
        """Take bytes from the computer."""
        self._answering.receive(data)

    def produce(self, count: int) -> bytes:
        """Let time go on by so many samples and return what comes down the line.

        Raises
        ------
        Unplugged
            Nothing can come.
        """
        pieces: list[bytes] = []
        while True:
            if not self._plugged:
                raise Unplugged(self.options.device)
            self._obey()
            pieces.append(self._answering.reply())
            step = min(count, self._until_next_order(), _MOST)
            if not step:
                break
            pieces.append(self._piece(step))
            count -= step
        self._state = self._look()
        return b"".join(pieces)

    def _order(self, after_s: float, order: _Order) -> None:
        self._orders.put((after_s, order))

    def _obey(self) -> None:
        """Carry out the orders whose time has come, in the order of their times."""
        while not self._orders.empty():
            after_s, order = self._orders.get()
            self._agenda.append((self._next + round(after_s * self.rate_hz), order))
        self._agenda.sort(key=lambda entry: entry[0])
        while self._agenda and self._agenda[0][0] <= self._next:
            self._agenda.pop(0)[1](self._bench)

    def _until_next_order(self) -> int:
        return self._agenda[0][0] - self._next if self._agenda else _MOST

    def _piece(self, count: int) -> bytes:
        data = self._unit.sends(self._bench.stimulus(count), count)
        first = self._next
        self._next += count
        if not self._answering.streaming:
            return b""
        faults = self._faults
        self._line.freeze(data, faults)
        index = np.arange(first, first + count)
        return self._line.carry(encode(self.profile, index, data), first, count, faults)

    def garble(self, count: int) -> bytes:
        """Return random bytes in place of `count`, as a wrong baud rate makes them."""
        return self._line.noise(count)

    def _look(self) -> RigState:
        bench = self._bench
        return RigState(
            time_s=bench.time_s,
            head_deg=bench.head.value,
            head_target_deg=bench.head.target,
            mount=bench.mount,
            moving=bench.moving,
            table_dps=bench.table.value,
            table_target_dps=bench.table.target,
            axis=bench.axis,
            chamber_c=bench.chamber.value,
            case_c=bench.case_c,
            base=bench.base,
            streaming=self._answering.streaming,
            plugged=self._plugged,
        )
