"""How visible a hidden effect is, and what else could draw the same picture.

lambda = norm of the change of the noise-free readings after whitening by the true covariance and
taking out the plain model (bias and linear sensitivity): the t-value an oracle would get.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tests.blind import effects as kinds
from tests.blind import geometry, noise, play
from tests.blind.effects import Kind
from tests.blind.world import Effects, Hidden, World

PROBES = {"saturation": (0.02, 0.05, 0.1, 0.2, 0.3)}
DUST = 1e-4
"""Sigmas below which a thousandth of an effect's largest size counts as invisible."""
WHOLE = 1000.0
"""Columns are made at a thousandth of an effect's largest size."""
APART = 0.6
"""Part of an effect that must stay visible when those hidden beside it are known."""
CLASS = 2.0
"""An effect that leaves less than this many sigmas of another one is its equal."""


def plain_columns(world: World) -> np.ndarray:
    """(n, p) of the plain model of one output, from the labels of the rows."""
    plan = world.plan
    one = np.ones((plan.size, 1))
    if plan.test == "rate_table":
        return np.hstack([one, plan.setting[:, None]])
    none = np.zeros(plan.size)
    room = geometry.attitude(list(plan.mount), np.radians(plan.setting), 0.0, none)
    return np.hstack([one, geometry.seen_from_case(geometry.UP, room)])


def orthonormal(columns: np.ndarray) -> np.ndarray:
    """Basis of the column space; what is only rounding counts as nothing."""
    length = np.linalg.norm(columns, axis=0)
    columns = columns[:, length > 1e-9 * max(length.max(initial=0.0), 1e-300)]
    if columns.shape[1] == 0:
        return columns
    columns = columns / np.linalg.norm(columns, axis=0)
    u, s, _ = np.linalg.svd(columns, full_matrices=False)
    return u[:, s > 1e-6 * s[0]]


@dataclass
class Glass:
    """The whitened space of one world, the plain model taken out."""

    world: World

    @cached_property
    def factor(self) -> np.ndarray:
        return np.linalg.cholesky(noise.covariance(self.world))

    @cached_property
    def plain(self) -> np.ndarray:
        """Orthonormal columns of the whitened plain model, all outputs."""
        blocks = np.kron(np.eye(self.world.outputs), plain_columns(self.world))
        return orthonormal(self.whiten(blocks))

    @cached_property
    def healthy(self) -> np.ndarray:
        return play.truth(self.world, {})

    def whiten(self, columns: np.ndarray) -> np.ndarray:
        from scipy.linalg import solve_triangular

        return solve_triangular(self.factor, columns, lower=True)

    def seen(self, columns: np.ndarray) -> np.ndarray:
        """What is visible of columns (n c,) or (n c, p), in sigmas."""
        white = self.whiten(columns)
        return white - self.plain @ (self.plain.T @ white)

    def change(self, effects: Effects) -> np.ndarray:
        """(n c,) visible change by effects, in sigmas."""
        delta = play.truth(self.world, effects) - self.healthy
        return self.seen(delta.T.reshape(-1))

    def visibility(self, name: str, hidden: Hidden) -> float:
        return float(np.linalg.norm(self.change({name: hidden})))


def sized(
    glass: Glass, name: str, shape: dict, limit: float, wanted: float, sign: float = 1.0
) -> float | None:
    """The size that gives lambda `wanted` with that sign; None if it takes more than `limit`.

    Angles act inside sine and cosine: at a cardinal position one sign shows more than the other.
    """

    def lam(size: float) -> float:
        return glass.visibility(name, Hidden(sign * size, shape))

    low, high = 0.0, limit
    if lam(limit) < wanted:
        return None
    guess = limit * 1e-3
    slope = lam(guess) / guess
    guess = wanted / slope if slope > 0.0 else 0.5 * limit
    for attempt in range(60):
        if attempt % 3 == 2 or not low < guess < high:
            guess = 0.5 * (low + high)
        found = lam(guess)
        if abs(found - wanted) < 2e-3 * wanted:
            return guess
        low, high = (guess, high) if found < wanted else (low, guess)
        guess = guess * wanted / found if found > 0.0 else 0.5 * (low + high)
    return None


def apart(seen: np.ndarray) -> bool:
    """Whether each of several visible changes (n, k) stays visible when the others are known."""
    for i in range(seen.shape[1]):
        others = orthonormal(np.delete(seen, i, axis=1))
        rest = seen[:, i] - others @ (others.T @ seen[:, i])
        if np.linalg.norm(rest) < APART * np.linalg.norm(seen[:, i]):
            return False
    return True


def blocks(glass: Glass, name: str, kind: Kind) -> list[np.ndarray]:
    """Columns (n c, p) of one name, one array for each of its places and shapes."""
    world = glass.world
    n, count = world.plan.size, world.outputs
    eye = np.eye(n)
    if name == "outlier":
        return [np.kron(eye_c[:, None], eye[:, [i]]) for eye_c in np.eye(count) for i in range(n)]
    if name == "bias_jump":
        steps = np.tril(np.ones((n, n)))
        return [
            np.kron(eye_c[:, None], steps[:, [i]]) for eye_c in np.eye(count) for i in range(1, n)
        ]
    if name == "wrong_angle":
        slope = noise.slopes(world)
        return [(eye[:, [i]] * slope[i]).T.reshape(-1, 1) for i in range(n)]
    out = []
    limit = kinds.limit_of(world, name, kind)
    channels = range(count) if kind.private else (0,)
    for shapes in kind.family(world):
        for channel in channels:
            for probe in PROBES.get(name, (1.0 / WHOLE,)):
                hidden = [Hidden(probe * limit, {"channel": channel, **s}) for s in shapes]
                made = [play.truth(world, {name: h}) - glass.healthy for h in hidden]
                out.append(np.stack([m.T.reshape(-1) for m in made], axis=1))
    return out


def nearest(glass: Glass, target: np.ndarray, name: str, kind: Kind) -> float:
    """Sigmas of `target` (visible, whitened) that the best version of `name` leaves over."""
    made = blocks(glass, name, kind)
    if not made:
        return float(np.linalg.norm(target))
    seen = glass.seen(np.concatenate(made, axis=1))
    best = float(target @ target)
    start = 0
    for width in (block.shape[1] for block in made):
        block = seen[:, start : start + width]
        block = block[:, np.linalg.norm(block, axis=0) > DUST]
        start += width
        if block.shape[1] == 0:
            continue
        sizes, *_ = np.linalg.lstsq(block, target, rcond=1e-6)
        if np.abs(sizes).max() <= WHOLE:
            rest = target - block @ sizes
            best = min(best, float(rest @ rest))
    return float(np.sqrt(max(best, 0.0)))


def mimics(glass: Glass, target: np.ndarray, own: str, leave: float = CLASS) -> list[str]:
    """Other single names that reproduce a visible change to within `leave` sigmas."""
    others = kinds.testable(glass.world).items()
    return [
        name
        for name, kind in others
        if name != own and not kind.natural and nearest(glass, target, name, kind) <= leave
    ]


def left_over(glass: Glass, target: np.ndarray, names: list[str]) -> float:
    """Sigmas of a visible change that the best mixture of several names leaves."""
    possible = kinds.testable(glass.world)
    families = [
        [glass.seen(block) for block in blocks(glass, name, possible[name])]
        for name in names
        if name in possible and not possible[name].natural
    ]
    chosen = [family[0] for family in families]
    best = float(np.linalg.norm(target))
    for _ in range(3):
        for slot, family in enumerate(families):
            others = chosen[:slot] + chosen[slot + 1 :]
            rests = []
            for block in family:
                basis = orthonormal(np.hstack([block, *others]))
                rests.append(float(np.linalg.norm(target - basis @ (basis.T @ target))))
            chosen[slot] = family[int(np.argmin(rests))]
            best = min(best, *rests)
    return best
