"""Damaged files of every kind: nothing but words leaves a reader, and nothing is changed.

`READERS` holds them all. What a longer search found stands here as an example of its own, in the
tests of the part that was mended.
"""

import random
import zlib
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from core.errors import FitError
from drivers.framing import MAGIC, read_blocks
from tests.reliability import repairs, seeds
from tests.reliability.edits import KINDS, ODD, Edit, chance, edited, of_bytes
from tests.reliability.readers import READERS, Broken, Reader, Seed, attempt, try_out

EDITS = st.lists(
    st.builds(
        Edit,
        st.sampled_from(KINDS),
        st.integers(0, 65535),
        st.integers(0, 255),
        st.integers(0, len(ODD) - 1),
    ),
    min_size=1,
    max_size=4,
)
EXAMPLES = {"archive index": 10}
"""An index is a database: each look at one takes as long as a hundred small files."""
_FEW, _MANY = 20, 50


def _examples(name: str) -> int:
    return EXAMPLES.get(name, _FEW if name.startswith("frames of") else _MANY)


@pytest.mark.parametrize("name", READERS)
def test_whole_files_are_read(name: str):
    assert not any(try_out(READERS[name], bytes))


@pytest.mark.parametrize("name", READERS)
def test_damage_is_answered_in_words(name: str):
    reader = READERS[name]

    @settings(max_examples=_examples(name), suppress_health_check=list(HealthCheck))
    @given(edits=EDITS)
    def search(edits: list[Edit]):
        try_out(reader, lambda content: edited(content, edits))

    search()


@pytest.mark.parametrize("name", [n for n in READERS if n not in EXAMPLES])
@pytest.mark.parametrize("content", [b"", b"\0" * 2000, b"\xff\xfe" + "G1;1".encode("utf-16-le")])
def test_what_is_no_such_file_at_all(name: str, content: bytes):
    try_out(READERS[name], lambda _: content)


# ---- the search itself must be able to fail


def _seed() -> tuple[Seed, ...]:
    return (Seed("a.txt", b"1 2 3\n"),)


def test_an_error_of_another_family_is_found():
    def read(path: Path) -> None:
        float(path.read_text("latin-1").split()[0])

    def search() -> None:
        for number in range(200):
            rng = random.Random(number)
            try_out(Reader(_seed, read), lambda content: edited(content, chance(rng)))  # noqa: B023

    with pytest.raises((ValueError, IndexError)):
        search()


def test_a_reader_that_writes_is_found(tmp_path: Path):
    def read(path: Path) -> None:
        path.with_name("b.txt").write_text("mine")

    with pytest.raises(Broken, match=r"changed on the disk: \['b.txt'\]"):
        attempt(Reader(_seed, read), _seed()[0], b"1", tmp_path)


def test_an_error_without_a_word_is_found(tmp_path: Path):
    def read(_: Path) -> None:
        raise FitError

    with pytest.raises(Broken, match="FitError without a word"):
        attempt(Reader(_seed, read), _seed()[0], b"1", tmp_path)


def test_repaired_check_sums_hold():
    rng = random.Random(3)
    for _ in range(20):
        damaged = repairs.blocks(edited(seeds.recording(), chance(rng)))
        if damaged.startswith(MAGIC) and len(damaged) > 600:
            size, crc = (int.from_bytes(damaged[at : at + 4], "little") for at in (8, 12))
            assert zlib.crc32(damaged[16 : 16 + size]) == crc
    whole = seeds.recording()
    assert repairs.blocks(whole) == whole
    journal = seeds.session()["positions.jsonl"]
    assert repairs.journal(journal) == journal


def test_repaired_blocks_are_read(tmp_path: Path):
    path = tmp_path / "a.calrec"
    whole = seeds.recording()
    path.write_bytes(whole)
    before = len(list(read_blocks(path)))
    at = whole.index(b"BLK0") + 40
    path.write_bytes(repairs.blocks(whole[:at] + b"\1\2" + whole[at:]))
    assert len(list(read_blocks(path))) == before


def test_bytes_become_edits():
    assert of_bytes(bytes([0, 128, 0, 9, 3, 2])) == [Edit("word", 32768, 9, 3)]
    assert edited(b"a=12, b=3", [Edit("word", 65536 * 2 // 9 + 1, 0, 5)]) == b"a=3.5, b=3"
