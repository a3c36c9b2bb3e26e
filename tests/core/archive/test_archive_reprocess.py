"""Positions decoded again, beside what was stored."""

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from core.archive.reprocess import reprocess
from core.arrays import frozen, frozen_int
from core.errors import FormatError
from core.plans.plan import load_plans
from core.records.session.events import RawRange
from core.records.session.record import SessionRecord, read_session
from core.records.session.start import SessionStart
from core.records.session.store import Session
from core.samples.accumulate import accumulation_of
from core.samples.block import SampleBlock
from tests.core.archive.conftest import CHANNELS

FIRST, N = 1000, 200


def samples(seed: int = 5) -> np.ndarray:
    rng = np.random.default_rng(seed)
    level = np.array([0.0, 100.0, -10.0, 12866.0, 26.0])
    return level + rng.normal(0.0, 0.5, (3 * N, len(CHANNELS)))


@pytest.fixture
def record(tmp_path: Path) -> SessionRecord:
    plan = load_plans()["pointer_8"]
    start = SessionStart(
        device="PW09",
        sensor="accelerometer",
        channels=CHANNELS,
        rate=100.0,
        plan=plan,
        started="2024-05-14T09:30:05+03:00",
    )
    session = Session.create(tmp_path / "s", start)
    (tmp_path / "s" / "a.calrec").write_bytes(b"")
    mean = accumulation_of(CHANNELS, np.arange(N) / 100.0, samples()[N : 2 * N], first=FIRST + N)
    session.accept(plan.steps[0], mean, raw=RawRange("a.calrec", 0, 9))
    session.accept(plan.steps[1], mean, raw=RawRange("lost.calrec", 0, 9))
    session.accept(plan.steps[2], mean)
    session.close()
    return read_session(tmp_path / "s")


def block(data: np.ndarray, first: int = FIRST) -> SampleBlock:
    index = frozen_int(np.arange(len(data)) + first)
    return SampleBlock(CHANNELS, index, frozen(data), 100.0)


def decoded(blocks: Sequence[SampleBlock], record: SessionRecord, tmp_path: Path):
    return reprocess(record, tmp_path / "raw", lambda _: blocks)


def test_the_same_samples_give_the_same_means(record: SessionRecord, tmp_path: Path) -> None:
    data = samples()
    parts = [block(data[:250]), block(data[250:], FIRST + 250)]
    first, second, third = decoded(parts, record, tmp_path)
    assert first.same
    assert first.n == N
    assert first.largest < 1e-6
    assert [channel.name for channel in first.channels] == ["AX", "AY", "AZ", "T"]
    assert "lost.calrec is not there" in second.why_not
    assert math.isnan(second.largest)
    assert not second.same
    assert third.same, "the only log of the folder is the one"
    (tmp_path / "s" / "b.calrec").write_bytes(b"")
    *_, third = decoded(parts, record, tmp_path)
    assert "not recorded" in third.why_not


def test_another_reading_of_the_bytes_is_seen(record: SessionRecord, tmp_path: Path) -> None:
    data = samples()
    data[:, 1] *= 1.01
    first, *_ = decoded([block(data)], record, tmp_path)
    assert not first.same
    assert first.largest > 10.0
    assert first.again[0] == pytest.approx(1.01 * first.stored[0])


@pytest.mark.parametrize(
    ("blocks", "why"),
    [([], "no samples"), ([block(samples(), first=90_000)], "1200 was accumulated")],
)
def test_bytes_without_these_samples_are_told(
    record: SessionRecord, tmp_path: Path, blocks: list[SampleBlock], why: str
) -> None:
    assert why in decoded(blocks, record, tmp_path)[0].why_not


def test_a_decoder_that_refuses_is_told(record: SessionRecord, tmp_path: Path) -> None:
    def refuse(path: Path) -> Sequence[SampleBlock]:
        raise FormatError(path, "holds no device file")

    first, *_ = reprocess(record, tmp_path, refuse)
    assert "holds no device file" in first.why_not
