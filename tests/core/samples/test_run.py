"""A run keeps its columns together and refuses those that do not fit."""

from dataclasses import replace

import numpy as np
import pytest

from core.samples.run import Conditions, Run


def a_run() -> Run:
    n = 4
    return Run(
        test="dividing_head",
        sensor="accelerometer",
        device="PW09",
        channels=("X", "Y"),
        axes=("x", "y"),
        unit="code",
        y=np.arange(8.0).reshape(n, 2),
        y_se=np.full((n, 2), 0.1),
        run=np.zeros(n, dtype=np.int64),
        order=np.arange(n),
        mount=("X_from", "X_from", "Y_from", "Y_from"),
        head_deg=np.array([0.0, 90.0, 0.0, 90.0]),
        set_rate_dps=np.full(n, np.nan),
        temperature_c=np.array([20.0, 21.0, 22.0, 23.0]),
        t_s=np.arange(n) * 30.0,
        extra={"temp_1": np.array([1.0, 2.0, 3.0, 4.0])},
    )


def test_rows_take_every_column_along() -> None:
    chosen = a_run().rows([3, 1])
    assert len(chosen) == 2
    np.testing.assert_array_equal(chosen.y, [[6.0, 7.0], [2.0, 3.0]])
    assert chosen.mount == ("Y_from", "X_from")
    np.testing.assert_array_equal(chosen.extra["temp_1"], [4.0, 2.0])
    np.testing.assert_array_equal(chosen.t_s, [90.0, 30.0])


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"channels": ("X",)}, "2 outputs, 1 names"),
        ({"axes": ("x", "y", "z")}, "3 axes"),
        ({"mount": ("X_from",)}, "column mount has 1 rows, y has 4"),
        ({"extra": {"temp_1": np.zeros(3)}}, "column temp_1 has 3 rows"),
        ({"y_se": np.zeros((4, 1))}, "2 outputs"),
    ],
)
def test_columns_that_do_not_fit_are_refused(change: dict[str, object], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        replace(a_run(), **change)


def test_nothing_is_stated_unless_somebody_states_it() -> None:
    stated = Conditions()
    assert np.isnan(stated.g_mps2)
    assert np.isnan(stated.head_u_arcsec)
    assert stated.repeatability == 0.0
