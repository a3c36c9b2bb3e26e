"""One sealed case; needs no Qt."""

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass

from core.arrays import FloatArray
from core.model.effect import Effect
from core.samples.run import Run

Hidden = tuple[Effect, FloatArray]
"""An effect at its place and shape, and the values of its parameters."""


@dataclass(frozen=True, slots=True, eq=False)
class Case:
    """One sealed case.

    Parameters
    ----------
    seed : its number; the same number gives the same case
    run : what was measured
    truth : identifiers of what is hidden, in alphabetical order
    key : what the seal covers, as text
    """

    seed: int
    run: Run
    truth: tuple[str, ...]
    key: str

    @property
    def seal(self) -> str:
        """SHA-256 of the key, shown before anyone answers."""
        return hashlib.sha256(self.key.encode()).hexdigest()


def sealed(seed: int, run: Run, hidden: Sequence[Hidden], salt: str) -> Case:
    """Seal what is hidden in a run."""
    key = {
        "case": seed,
        "hidden": [
            {
                "effect": effect.id,
                "values": [float(f"{value:.6g}") for value in sizes],
                "shape": [float(f"{value:.6g}") for _, value in effect.shape],
            }
            for effect, sizes in hidden
        ],
        "salt": salt,
    }
    truth = tuple(sorted(effect.id for effect, _ in hidden))
    return Case(seed, run, truth, json.dumps(key, sort_keys=True))
