"""Decoding speed: every binary profile in bulk, and the cost of live pieces of 20 ms.

CPU time. The peer is the straightforward way: find the sync, loop over the bytes of the frame for
the checksum, `struct.unpack` into a list of floats. It is written here for three of the formats.
"""

import struct
import time
from collections.abc import Callable

import numpy as np

from drivers.checksums import Checksum, ChecksumSpec
from drivers.decoders import make_decoder
from drivers.encode import encode
from drivers.profile import load_profiles
from drivers.profile_types import FrameSpec
from drivers.protocols import cvg12, stim300, vectornav, xsens

PROFILES = load_profiles()
BULK_BYTES = 24_000_000
BULK_MB_S, CVG_MB_S = 50.0, 100.0
CHUNK_S, LIVE_HZ, LIVE_PERCENT = 0.020, 2000.0, 4.0
PEER_BYTES = 400_000

Peer = Callable[[bytes], int]


def stamped(rows: np.ndarray, spec: ChecksumSpec) -> bytes:
    Checksum(spec).stamp(rows)
    return rows.tobytes()


def noise(template: bytes, count: int, begin: int) -> np.ndarray:
    """Copies of a frame with random bytes from `begin` on."""
    rows = np.tile(np.frombuffer(template, dtype=np.uint8), (count, 1))
    rows[:, begin:] = np.random.default_rng(1).integers(0, 256, rows[:, begin:].shape)
    return rows


def encoded(name: str, count: int) -> bytes:
    columns = len(make_decoder(PROFILES[name]).channels)
    data = np.random.default_rng(2).uniform(-50, 50, (count, columns))
    return encode(PROFILES[name], np.arange(count), data)


def stim(count: int) -> bytes:
    """Datagrams AF, 63 bytes, at 2000 Hz."""
    rows = noise(b"\xaf" + bytes(62), count, 1)
    rows[:, 56] = np.arange(count) % 256
    return stamped(rows, stim300.CHECKSUM)


def mtdata2(count: int) -> bytes:
    """Sample time, acceleration, rate and magnetic field: 61 bytes."""
    head = bytes.fromhex("faff3638 10600400000000 40200c") + bytes(12)
    head += bytes.fromhex("80200c") + bytes(12) + bytes.fromhex("c0200c") + bytes(12) + b"\0"
    values = np.random.default_rng(3).normal(size=(count, 9)).astype(">f4").view(np.uint8)
    rows = np.tile(np.frombuffer(head, dtype=np.uint8), (count, 1))
    rows[:, 3] = rows.shape[1] - 5
    rows[:, 7:11] = (100 * np.arange(count)).astype(">u4").reshape(-1, 1).view(np.uint8)
    for at, begin in ((14, 0), (29, 12), (44, 24)):
        rows[:, at : at + 12] = values[:, begin : begin + 12]
    return stamped(rows, xsens.CHECKSUM)


def binary_vn(count: int) -> bytes:
    """Time since start and uncompensated sensors: 44 bytes."""
    rows = np.zeros((count, 44), dtype=np.uint8)
    rows[:, :6] = list(bytes.fromhex("fa0501001c00"))
    rows[:, 6:14] = (2_500_000 * np.arange(count)).astype("<u8").reshape(-1, 1).view(np.uint8)
    values = np.random.default_rng(4).normal(size=(count, 7)).astype("<f4")
    rows[:, 14:42] = values.view(np.uint8)
    return stamped(rows, vectornav.CHECKSUM)


def twelve(count: int) -> bytes:
    """Output and twelve slow parameters in turn."""
    rows = np.zeros((count, 12), dtype=np.uint8)
    rows[:, 0] = 0xAA
    rows[:, 2] = (1 + np.arange(count) % 12) << 4
    values = np.random.default_rng(5).normal(size=(count, 2)).astype("<f4")
    rows[:, 3:11] = values.view(np.uint8)
    return stamped(rows, cvg12.CHECKSUM)


MAKERS: dict[str, Callable[[int], bytes]] = {
    "stim300": stim, "xsens_mti": mtdata2, "vectornav_binary": binary_vn, "cvgx12": twelve,
}  # fmt: skip


def peer_cvgx48(data: bytes) -> int:
    samples: list[tuple[float, ...]] = []
    at = data.find(b"\xaa\x55")
    while 0 <= at <= len(data) - 48:
        words = struct.unpack_from("<22H", data, at + 2)
        if sum(words) & 0xFFFF == struct.unpack_from("<H", data, at + 46)[0]:
            samples.append(struct.unpack_from("<11f", data, at + 2))
            at += 48
        else:
            at += 1
        at = data.find(b"\xaa\x55", at)
    return len(samples)


def peer_stim300(data: bytes) -> int:
    table = [0] * 256
    for value in range(256):
        register = value << 24
        for _ in range(8):
            register = (register << 1) ^ (0x04C11DB7 if register & 0x80000000 else 0)
        table[value] = register & 0xFFFFFFFF
    samples: list[list[float]] = []
    at = data.find(b"\xaf")
    while 0 <= at <= len(data) - 63:
        register = 0xFFFFFFFF
        for byte in data[at : at + 59] + b"\0":
            register = (register << 8 & 0xFFFFFFFF) ^ table[register >> 24 ^ byte]
        if register == int.from_bytes(data[at + 59 : at + 63], "big"):
            places = (1, 4, 7, 11, 14, 17, 21, 24, 27)
            raw = (int.from_bytes(data[at + n : at + n + 3], "big", signed=True) for n in places)
            samples.append([value / 16384 for value in raw])
            at += 63
        else:
            at += 1
        at = data.find(b"\xaf", at)
    return len(samples)


def peer_xsens(data: bytes) -> int:
    samples: list[dict[int, tuple[float, ...]]] = []
    at = data.find(b"\xfa\xff")
    while 0 <= at <= len(data) - 5:
        end = at + data[at + 3] + 5
        if sum(data[at + 1 : end]) & 0xFF == 0:
            items: dict[int, tuple[float, ...]] = {}
            item = at + 4
            while item < end - 1:
                kind, size = struct.unpack_from(">HB", data, item)
                if size == 12:
                    items[kind] = struct.unpack_from(">3f", data, item + 3)
                item += 3 + size
            samples.append(items)
            at = end
        else:
            at += 1
        at = data.find(b"\xfa\xff", at)
    return len(samples)


PEERS: dict[str, Peer] = {
    "cvgx48": peer_cvgx48, "stim300": peer_stim300, "xsens_mti": peer_xsens,
}  # fmt: skip


def seconds(work: Callable[[], object], turns: int = 3) -> float:
    """Return the least CPU time of a few turns."""
    times: list[float] = []
    for _ in range(turns):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def row(
    name: str, value: float, unit: str, peer: float | None, target: float, *, most: bool
) -> bool:
    """Print one row; return whether the target is met."""
    met = value <= target if most else value >= target
    other = f"{peer:10.2f} {unit} | {max(value / peer, peer / value):8.1f}" if peer else f"{'':26}"
    sign = "<=" if most else ">="
    words = "ok" if met else "MISSED"
    print(f"{name:42} {value:9.2f} {unit} | {other} | {sign} {target:6.1f} | {words}")
    return met


def in_bulk(name: str, stream: bytes, title: str, target: float) -> bool:
    """Rate of one call with everything."""
    rate = len(stream) / seconds(lambda: make_decoder(PROFILES[name]).feed(stream)) / 1e6
    peer = PEERS.get(name)
    other = None
    if peer is not None:
        piece = stream[:PEER_BYTES]
        other = len(piece) / seconds(lambda: peer(piece)) / 1e6
    return row(title, rate, "MB/s", other, target, most=False)


def damaged(stream: bytes, length: int) -> bytes:
    """One bit wrong in each thousandth frame."""
    whole = bytearray(stream)
    for at in range(20, len(whole), 1000 * length):
        whole[at] ^= 4
    return bytes(whole)


def live(name: str, stream: bytes, length: int, target: float) -> bool:
    """Part of one core at 2 kHz in pieces of 20 ms."""
    size = int(CHUNK_S * LIVE_HZ) * length
    pieces = [stream[at : at + size] for at in range(0, 500 * size, size)]
    decoder = make_decoder(PROFILES[name])

    def all_pieces() -> None:
        for piece in pieces:
            decoder.feed(piece)

    each = seconds(all_pieces) / len(pieces)
    peer = PEERS.get(name)
    other = seconds(lambda: peer(pieces[0])) / CHUNK_S * 100 if peer is not None else None
    title = f"{name}, {length} B at 2 kHz, {each * 1e6:.0f} us a feed"
    return row(title, each / CHUNK_S * 100, "%   ", other, target, most=True)


def main() -> int:
    """Print all rows; return the number of targets missed."""
    met: list[bool] = []
    for name, profile in PROFILES.items():
        spec = profile.stream
        if isinstance(spec, FrameSpec):
            stream = encoded(name, BULK_BYTES // spec.shortest)
        elif name == "inertiallabs_ahrs":
            stream = encoded(name, BULK_BYTES // 42)
        elif name in MAKERS:
            stream = MAKERS[name](BULK_BYTES // len(MAKERS[name](1)))
        else:
            continue
        target = CVG_MB_S if name == "cvgx48" else BULK_MB_S
        met.append(in_bulk(name, stream, f"{name} in bulk", target))
        if name in ("cvgx48", "stim300"):
            length = 48 if name == "cvgx48" else 63
            hurt = damaged(stream, length)
            met.append(in_bulk(name, hurt, f"{name} with damage", BULK_MB_S))
            met.append(live(name, stream, length, LIVE_PERCENT))
    return met.count(False)


if __name__ == "__main__":
    raise SystemExit(main())
