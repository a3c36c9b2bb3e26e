"""Every number is given once, whoever asks at the same moment."""

import threading
from dataclasses import replace
from pathlib import Path

import pytest

from core.certificates.certificate import Certificate, certificate_text
from core.certificates.register import Register
from core.errors import FormatError, StorageError


def issue(register: Register, certificate: Certificate) -> Certificate:
    return register.issue(
        certificate.laboratory, 2026, lambda number: replace(certificate, number=number)
    )[0]


def test_numbers_follow_each_other_and_the_twin_lies_in_the_folder(
    certificate: Certificate, tmp_path: Path
):
    register = Register(tmp_path / "certificates")
    assert register.next_number(certificate.laboratory, 2026) == "2026-0001"
    first, second = issue(register, certificate), issue(register, certificate)
    assert (first.number, second.number) == ("2026-0001", "2026-0002")
    back = register.read(register.path("2026-0002"))
    assert certificate_text(back) == certificate_text(second)
    assert sorted(path.name for path in register.folder.iterdir()) == [
        "certificate_2026-0001.json",
        "certificate_2026-0002.json",
    ]


def test_many_at_once_get_different_numbers(certificate: Certificate, tmp_path: Path):
    given: list[str] = []
    threads = [
        threading.Thread(target=lambda: given.append(issue(Register(tmp_path), certificate).number))
        for _ in range(8)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(given) == [f"2026-{n:04d}" for n in range(1, 9)]


def test_a_number_taken_meanwhile_is_not_given_again(certificate: Certificate, tmp_path: Path):
    register = Register(tmp_path)

    def slow(number: str) -> Certificate:
        if number == "2026-0001":
            register.path(number).write_text("taken", encoding="utf-8")
        return replace(certificate, number=number)

    assert register.issue(certificate.laboratory, 2026, slow)[0].number == "2026-0002"
    assert register.path("2026-0001").read_text(encoding="utf-8") == "taken"


def test_a_folder_without_links_serves_as_well(
    certificate: Certificate, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    def no_links(path: Path, target: Path) -> None:
        raise PermissionError(1, "Operation not permitted", str(path))

    monkeypatch.setattr(Path, "hardlink_to", no_links)
    register = Register(tmp_path)
    assert [issue(register, certificate).number for _ in range(2)] == ["2026-0001", "2026-0002"]
    assert register.read(register.path("2026-0001")).number == "2026-0001"


def test_a_place_that_takes_no_file_is_told(
    certificate: Certificate, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(StorageError, match="cannot be made"):
        issue(Register(tmp_path / "file"), certificate)

    def full(path: Path, target: Path) -> None:
        raise OSError(28, "No space left on device", str(path))

    monkeypatch.setattr(Path, "hardlink_to", full)
    with pytest.raises(StorageError, match=r"cannot be kept \(No space left"):
        issue(Register(tmp_path), certificate)
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_a_broken_twin_is_refused(certificate: Certificate, tmp_path: Path):
    register = Register(tmp_path)
    register.path("1").write_text("{", encoding="utf-8")
    with pytest.raises(FormatError, match="damaged JSON"):
        register.read(register.path("1"))


def test_the_list_tells_what_replaces_what(certificate: Certificate, tmp_path: Path):
    register = Register(tmp_path)
    first = issue(register, certificate)
    changed = replace(certificate.order, replaces=first.number, change="serial number", serial="18")
    issue(register, replace(certificate, order=changed))
    register.path("2026-0003").write_text("{", encoding="utf-8")
    newer, older, damaged = register.entries()
    assert (newer.number, newer.serial, newer.replaces) == ("2026-0002", "18", "2026-0001")
    assert (older.number, older.replaced_by, older.withdrawn) == ("2026-0001", "2026-0002", "")
    assert (damaged.number, older.verdict) == ("2026-0003", "")
    assert "damaged JSON" in damaged.damage


def test_a_withdrawal_leaves_the_twin_alone_and_happens_once(
    certificate: Certificate, tmp_path: Path
):
    register = Register(tmp_path)
    issue(register, certificate)
    before = register.path("2026-0001").read_bytes()
    register.withdraw("2026-0001", "2026-12-01", "the head was found to be damaged")
    assert register.path("2026-0001").read_bytes() == before
    (only,) = register.entries()
    assert only.withdrawn == "2026-12-01: the head was found to be damaged"
    with pytest.raises(StorageError, match="was withdrawn before"):
        register.withdraw("2026-0001", "2026-12-02", "again")
    with pytest.raises(StorageError, match="no such certificate"):
        register.withdraw("2026-0009", "2026-12-02", "unknown")
    assert issue(register, certificate).number == "2026-0002"
