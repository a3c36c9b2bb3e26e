import pytest

from core.errors import FormatError
from core.records.text import decode, lines_of, read_bytes


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "cp1251"])
def test_what_lab_computers_write(encoding):
    assert decode("Збірка №5\r\n".encode(encoding), "f") == "Збірка №5\r\n"


def test_what_is_no_text():
    with pytest.raises(FormatError, match="UTF-16"):
        decode("a".encode("utf-16"), "f")
    with pytest.raises(FormatError, match="neither UTF-8 nor CP1251") as caught:
        decode(b"a\nb\n\x98", "f")
    assert caught.value.line == 3


def test_only_cr_and_lf_end_a_line():
    assert lines_of("a\r\nb\nc\rd\x0be\u2028f") == ["a", "b", "c", "d\x0be\u2028f"]
    assert lines_of("a\n\n") == ["a", ""]
    assert lines_of("") == []


def test_files_too_large_for_what_they_should_be(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"x" * 1001)
    assert len(read_bytes(path, max_bytes=1001)) == 1001
    with pytest.raises(FormatError, match="is larger than"):
        read_bytes(path, max_bytes=1000)
    with pytest.raises(FormatError, match="cannot be read: No such file"):
        read_bytes(tmp_path / "none")
