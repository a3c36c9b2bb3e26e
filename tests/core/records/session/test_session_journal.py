import json
import zlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import FormatError, Severity, StorageError
from core.records.session.journal import Journal, read_journal


def test_a_line_is_json_with_the_checksum_of_its_event(tmp_path):
    path = tmp_path / "j"
    journal = Journal(path, create=True)
    journal.append({"id": 1, "text": "їєґ\n"})
    journal.append({"id": 2})
    journal.close()
    first, second = path.read_bytes().splitlines()
    assert json.loads(first)["event"] == {"id": 1, "text": "їєґ\n"}
    assert second == b'{"crc32":"%08x","event":{"id":2}}' % zlib.crc32(b'{"id":2}')
    events, damaged = read_journal(path)
    assert [event.data["id"] for event in events] == [1, 2]
    assert damaged == ()


def test_a_journal_is_made_once(tmp_path):
    path = tmp_path / "j"
    with pytest.raises(StorageError):
        Journal(path)
    Journal(path, create=True).close()
    with pytest.raises(StorageError, match="untouched"):
        Journal(path, create=True)


@given(cut=st.integers(0, 200))
def test_a_cut_at_any_byte_loses_only_the_cut_line(tmp_path_factory, cut):
    path = tmp_path_factory.mktemp("j") / "j"
    journal = Journal(path, create=True)
    for number in range(1, 6):
        journal.append({"id": number})
    journal.close()
    content = path.read_bytes()
    cut = len(content) - cut % len(content)
    path.write_bytes(content[:cut])
    events, damaged = read_journal(path)
    # The line end itself may be missing: the event before it is whole.
    assert len(events) == (content[:cut] + b"\n").count(b"}}\n")
    assert all(damage.last for damage in damaged)
    journal = Journal(path)
    journal.append({"id": 99})
    journal.close()
    events, damaged = read_journal(path)
    assert events[-1].data["id"] == 99
    assert not any(damage.last for damage in damaged)


@pytest.mark.parametrize("tail", [b"\0" * 100, b"{", b'{"crc32":"00000000","event":{"id":3}}\n'])
def test_a_tail_of_anything_else_is_told(tmp_path, tail):
    path = tmp_path / "j"
    journal = Journal(path, create=True)
    journal.append({"id": 1})
    journal.close()
    path.write_bytes(path.read_bytes() + tail)
    events, (damage,) = read_journal(path)
    assert len(events) == 1
    assert (damage.line, damage.last) == (2, True)
    assert damage.note(path).severity is Severity.WARNING


def test_damage_between_whole_events_is_an_error(tmp_path):
    path = tmp_path / "j"
    journal = Journal(path, create=True)
    for number in (1, 2, 3):
        journal.append({"id": number})
    journal.close()
    path.write_bytes(path.read_bytes().replace(b'"id":2', b'"id":7'))
    events, (damage,) = read_journal(path)
    assert [event.data["id"] for event in events] == [1, 3]
    assert (damage.line, damage.last) == (2, False)
    assert damage.note(path).severity is Severity.ERROR


@given(st.binary(max_size=300))
def test_any_bytes_are_read(tmp_path_factory, content):
    path = tmp_path_factory.mktemp("j") / "j"
    path.write_bytes(content)
    events, damaged = read_journal(path)
    assert events == ()
    assert len(damaged) == sum(bool(line) for line in content.split(b"\n"))


def test_a_missing_journal(tmp_path):
    with pytest.raises(FormatError, match="cannot be read"):
        read_journal(tmp_path / "none")
