"""Notes about the table itself; those about a sensor are tested where they arise."""

import numpy as np

from core.fit.estimate import Estimate
from core.procedures.characteristic import Term
from core.procedures.rate_notes import table_notes, temperature_notes

ROWS = np.arange(11)


def straight() -> tuple[Term, ...]:
    return (Term(2, Estimate(0.0, 1.0, 8.0, ""), 0.5, 0.5, 0.0),)


def bent() -> tuple[Term, ...]:
    return (Term(2, Estimate(9.0, 1.0, 8.0, ""), 81.0, 1e-5, 0.0),)


def errors(share: float, sensors: int, seed: int = 1) -> list[np.ndarray]:
    rng = np.random.default_rng(seed)
    common = rng.normal(0.0, np.sqrt(share), 11)
    return [common + rng.normal(0.0, np.sqrt(1 - share), 11) for _ in range(sensors)]


def test_common_errors_accuse_the_table():
    (note,) = table_notes([(e, ROWS, straight()) for e in errors(0.95, 5)])
    assert note.subject == "common_error"
    assert "5 sensors" in note.text


def test_errors_of_their_own_do_not():
    assert table_notes([(e, ROWS, straight()) for e in errors(0.0, 9)]) == []


def test_sensors_that_bend_alike_do_not_accuse_the_table():
    assert table_notes([(e, ROWS, bent()) for e in errors(0.95, 5)]) == []


def test_two_sensors_or_other_rows_are_no_crowd():
    assert table_notes([(e, ROWS, straight()) for e in errors(0.95, 2)]) == []
    first, *rest = errors(0.95, 3)
    mixed = [(first, ROWS, straight()), *((e, ROWS + 1, straight()) for e in rest)]
    assert table_notes(mixed) == []
    assert table_notes([]) == []


def test_mixed_temperatures_are_said():
    (note,) = temperature_notes(np.array([-40.0, 27.0, 70.0]))
    assert note.subject == "temperature_varies"
    assert "-40 to 70 degC" in note.text
    assert temperature_notes(np.array([25.0, 27.0])) == []
    assert temperature_notes(np.array([])) == []
