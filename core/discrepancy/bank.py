"""All instances of all effects as projected columns, scored together."""

from dataclasses import dataclass

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray
from core.discrepancy.evidence import block_evidence, log_mean, many_block_evidence
from core.discrepancy.problem import COMMON, EACH, Problem
from core.discrepancy.space import Space
from core.model.effect import Effect, Kind

_SEEN = 1e-5
_ADDITIVE = (Kind.BLOCK, Kind.EVENT)


@dataclass(frozen=True, slots=True, eq=False)
class Instance:
    """One effect at one place, of one shape, in one channel.

    Parameters
    ----------
    effect : the instance of the effect
    channel : which channel, or `COMMON`, or `EACH`
    """

    effect: Effect
    channel: int


@dataclass(frozen=True, slots=True, eq=False)
class Bank:
    """Columns of all instances.

    Parameters
    ----------
    names : identifiers of the effects
    instances : all of them
    name : (m,) place in `names` of each
    first, count : (m,) its first column, how many there are
    raw : (n, q) output that one unit of each parameter adds
    """

    names: tuple[str, ...]
    instances: tuple[Instance, ...]
    name: IntArray
    first: IntArray
    count: IntArray
    raw: FloatArray

    @classmethod
    def of(cls, problem: Problem) -> "Bank":
        """All instances that the rows could show."""
        names: list[str] = []
        instances: list[Instance] = []
        name: list[int] = []
        blocks: list[FloatArray] = []
        for effect in problem.effects:
            if effect.kind not in _ADDITIVE:
                continue
            places = [COMMON] if effect.shared else list(range(problem.channels))
            if problem.channels > 1 and not effect.shared and not effect.alone:
                places = [EACH] if effect.together else [*places, EACH]
            found = [
                Instance(one, place)
                for place in places
                for one in effect.instances(problem.stimulus, problem.models[max(place, 0)].sensor)
            ]
            for instance in found:
                instances.append(instance)
                name.append(len(names))
                blocks.append(problem.columns(instance.effect, instance.channel))
            if found:
                names.append(effect.id)
        count = np.array([block.shape[1] for block in blocks], dtype=np.int64)
        return cls(
            names=tuple(names),
            instances=tuple(instances),
            name=np.array(name, dtype=np.int64),
            first=np.cumsum(count) - count,
            count=count,
            raw=np.hstack(blocks),
        )

    def block(self, instance: int) -> slice:
        """Columns of an instance."""
        first = int(self.first[instance])
        return slice(first, first + int(self.count[instance]))

    def in_space(self, space: Space) -> "Projected":
        """The bank in a whitened space."""
        return Projected.of(self, space)

    def by_name(self, evidence: FloatArray) -> FloatArray:
        """Mean evidence (names,) or (names, k) over the instances (m,) or (m, k) of each name."""
        edges = np.flatnonzero(np.diff(self.name, prepend=-1))
        parts = np.split(evidence, edges[1:], axis=0)
        return np.array([log_mean(part, axis=0) for part in parts])


@dataclass(frozen=True, slots=True, eq=False)
class Projected:
    """A bank in a whitened space.

    Parameters
    ----------
    bank, space : which
    columns : (n, q) whitened columns without the plain model
    gram : by the number of columns: (m', p, p) products within each instance
    """

    bank: Bank
    space: Space
    columns: FloatArray
    gram: dict[int, FloatArray]
    members: dict[int, IntArray]
    seen: BoolArray

    @classmethod
    def of(cls, bank: Bank, space: Space) -> "Projected":
        """Whiten and project."""
        white = space.white(bank.raw)
        columns = space.project(white)
        before = np.sum(white**2, axis=0)
        after = np.sum(columns**2, axis=0)
        visible = after > _SEEN**2 * np.maximum(before, 1e-300)
        columns = columns * visible
        gram: dict[int, FloatArray] = {}
        members: dict[int, IntArray] = {}
        for p in sorted(set(bank.count.tolist())):
            chosen = np.flatnonzero(bank.count == p).astype(np.int64)
            members[p] = chosen
            places = bank.first[chosen][:, None] + np.arange(p, dtype=np.int64)
            blocks = columns[:, places]  # (n, m', p)
            gram[p] = np.einsum("nmp,nmq->mpq", blocks, blocks)
        seen = np.array([bool(np.any(visible[bank.block(i)])) for i in range(len(bank.instances))])
        return cls(bank, space, columns, gram, members, seen)

    def explained(self, residual: FloatArray, added: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Sum of squares that each instance takes away, and its number of free columns.

        Parameters
        ----------
        residual : (n,) or (n, k) whitened, without the plain model and without `added`
        added : (n, s) orthonormal, of the effects that are in the model already

        Returns
        -------
        explained, rank : (m,) or (m, k); (m,)
        """
        along = self.columns.T @ residual
        shadow = added.T @ self.columns
        m = len(self.bank.instances)
        found = np.zeros((m, *along.shape[1:]))
        rank = np.zeros(m)
        for p, chosen in self.members.items():
            places = self.bank.first[chosen][:, None] + np.arange(p)
            inner = self.gram[p]
            if added.shape[1]:
                parts = shadow[:, places]
                inner = inner - np.einsum("smp,smq->mpq", parts, parts)
            b = along[places]
            if p == 1:
                size = inner[:, 0, 0]
                free = size > 1e-6 * np.maximum(self.gram[p][:, 0, 0], 1e-300)
                scale = np.where(free, 1.0 / np.where(free, size, 1.0), 0.0)
                found[chosen] = (b[:, 0].T ** 2 * scale).T
                rank[chosen] = free
                continue
            unit = np.sqrt(np.einsum("mpp->mp", self.gram[p]))
            unit = np.where(unit > 0.0, unit, 1.0)
            values, vectors = np.linalg.eigh(inner / unit[:, :, None] / unit[:, None, :])
            free = values > 1e-6
            inverse = np.where(free, 1.0 / np.where(free, values, 1.0), 0.0)
            scaled = b / (unit if b.ndim == 2 else unit[:, :, None])
            turned = np.einsum("mpq,mp...->mq...", vectors, scaled)
            weight = inverse if b.ndim == 2 else inverse[:, :, None]
            found[chosen] = np.sum(turned**2 * weight, axis=1)
            rank[chosen] = free.sum(axis=1)
        return found, rank

    def evidence(self, residual: FloatArray, added: FloatArray) -> FloatArray:
        """Evidence (m,) or (m, k) of each instance; what the rows cannot show has none."""
        explained, rank = self.explained(residual, added)
        rss = np.sum(residual**2, axis=0)
        dof = self.space.dof - added.shape[1]
        if explained.ndim == 1:
            evidence = block_evidence(explained, rank, rss, self.space.prior, dof)
            return np.where(rank > 0, evidence, 0.0)
        many = many_block_evidence(explained, rank, rss, self.space.prior, dof)
        return np.where((rank > 0)[:, None], many, 0.0)
