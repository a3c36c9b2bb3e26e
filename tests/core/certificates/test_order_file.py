"""The order as a text file."""

from pathlib import Path

import numpy as np
import pytest

from core.certificates.limits import ParameterLimit
from core.certificates.order_file import OrderFile, read_order
from core.errors import FormatError

WHOLE = """
[order]
customer = "Завод № 5"
calibrated = 2026-11-20
issued = "2026-11-22"
[surroundings]
temperature_c = 22.5
[conformity]
rule = "simple"
[[conformity.limit]]
parameter = "bias"
channel = "acc_x"
limit = 600
[[conformity.limit]]
parameter = "scale_factor"
nominal = 1000.0
limit = 5.0
"""


def write(folder: Path, text: str) -> Path:
    path = folder / "order.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_everything_is_read(tmp_path: Path):
    found = read_order(write(tmp_path, WHOLE))
    assert found.order.customer == "Завод № 5"
    assert (found.order.calibrated, found.order.issued) == ("2026-11-20", "2026-11-22")
    assert found.surroundings.temperature_c == 22.5
    assert np.isnan(found.surroundings.pressure_hpa)
    assert found.rule == "simple"
    assert found.limits == (
        ParameterLimit("bias", "acc_x", 0.0, 600.0),
        ParameterLimit("scale_factor", "", 1000.0, 5.0),
    )


def test_an_empty_file_states_nothing(tmp_path: Path):
    found = read_order(write(tmp_path, ""))
    assert (found.order, found.limits, found.rule) == (OrderFile().order, (), "guarded")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[order", "is no TOML"),
        ("[order]\ncustumer = 'x'", "order: custumer is not known; known are customer"),
        ("[order]\nserial = 17", r"order\.serial must be a text"),
        ("[surroundings]\ntemperature_c = 'warm'", "must be a number"),
        ("[conformity]\nrule = 'mild'", "guarded or simple"),
        ("[[conformity.limit]]\nparameter = 'bias'\nlimit = 0", "a number above zero"),
        ("[[conformity.limit]]\nlimit = 1", "parameter is missing"),
        ("colour = 'red'", "the file: colour is not known"),
    ],
)
def test_what_is_not_understood_is_refused(tmp_path: Path, text: str, words: str):
    with pytest.raises(FormatError, match=words):
        read_order(write(tmp_path, text))
