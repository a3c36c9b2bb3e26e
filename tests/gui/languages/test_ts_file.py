"""Files of Qt Linguist."""

from pathlib import Path

import pytest

from core.errors import FormatError
from gui.languages.ts_file import Message, read_ts, write_ts

MESSAGES = [
    Message("A", "Two\nlines & <more>", "gui/a.py", "Два\nрядки & <ще>"),
    Message("B", "Left out", "core/b.py", ""),
]


def test_what_is_written_is_read_again(tmp_path: Path):
    path = tmp_path / "x_uk.ts"
    write_ts(path, "uk", MESSAGES)
    read = read_ts(path)
    assert [(m.context, m.source, m.translation) for m in read] == [
        (m.context, m.source, m.translation) for m in MESSAGES
    ]


def test_an_unfinished_translation_counts_as_none(tmp_path: Path):
    path = tmp_path / "x_uk.ts"
    write_ts(path, "uk", MESSAGES)
    text = path.read_text(encoding="utf-8")
    assert text.count('type="unfinished"') == 1
    path.write_text(
        text.replace(
            '<translation type="unfinished" />', '<translation type="unfinished">?</translation>'
        ),
        encoding="utf-8",
    )
    assert read_ts(path)[1].translation == ""


def test_what_is_no_xml_tells_where(tmp_path: Path):
    path = tmp_path / "x.ts"
    path.write_text("<TS>\n<context>\n</TS>\n", encoding="utf-8")
    with pytest.raises(FormatError, match="line 3") as caught:
        read_ts(path)
    assert caught.value.line == 3


def test_another_document_is_refused(tmp_path: Path):
    path = tmp_path / "x.ts"
    path.write_text("<html/>", encoding="utf-8")
    with pytest.raises(FormatError, match="Qt Linguist"):
        read_ts(path)


def test_a_missing_file_is_told(tmp_path: Path):
    with pytest.raises(FormatError, match="cannot be read"):
        read_ts(tmp_path / "none.ts")
