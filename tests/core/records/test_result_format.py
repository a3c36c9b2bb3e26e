"""A text of a result, with names in C after the file."""

from pathlib import Path

import pytest

from core.errors import FitError
from core.procedures.calibration import Provenance
from core.records.result_format import ResultFormat

WHO = Provenance("drift", "GIB-7")


def test_a_result_is_written_under_the_name_of_its_file(tmp_path: Path):
    kind = ResultFormat(
        "Text", ".txt", lambda value, who, name: f"{name} of {who.device}: {value}, Δ\n"
    )
    kind.write(2.5, WHO, tmp_path / "bias.txt")
    assert (tmp_path / "bias.txt").read_bytes() == "bias of GIB-7: 2.5, Δ\n".encode()


def test_a_result_that_the_format_cannot_hold_leaves_no_file(tmp_path: Path):
    def refuse(value: float, who: Provenance, name: str) -> str:
        raise FitError(f"{name}: {value} of {who.device} is too large")

    with pytest.raises(FitError, match=r"bias: 2\.5 of GIB-7"):
        ResultFormat("Text", ".txt", refuse).write(2.5, WHO, tmp_path / "bias.txt")
    assert not list(tmp_path.iterdir())
