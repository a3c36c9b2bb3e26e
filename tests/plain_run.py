"""A run of which a test tells what matters to it; all else is unknown."""

from typing import Any

import numpy as np

from core.samples.run import Run


def plain_run(y: np.ndarray, **told: Any) -> Run:
    """Outputs (n,) or (n, c) of accelerometers on the dividing head, codes; what is `told` counts.

    Standard errors, angles, rates, temperatures and times are unknown, all rows are of one pass in
    the order of measuring.
    """
    y = y[:, None] if y.ndim == 1 else y
    n, c = y.shape
    unknown = np.full(n, np.nan)
    known = {
        "test": "dividing_head",
        "sensor": "accelerometer",
        "device": "PW09",
        "channels": ("acc_x", "acc_y", "acc_z")[:c],
        "axes": ("x", "y", "z")[:c],
        "unit": "code",
        "y_se": np.full((n, c), np.nan),
        "run": np.ones(n, dtype=np.int64),
        "order": np.arange(n),
        "mount": ("",) * n,
        "head_deg": unknown,
        "set_rate_dps": unknown,
        "temperature_c": unknown,
        "t_s": unknown,
    }
    return Run(y=y, **{**known, **told})
