"""How the unit stood in each row of a legacy file.

Pointer and ClbDUS write position numbers, and the plan behind the layout knows their mounts.
ClbAcc writes the head angle alone. Its operator turns the head once round with the X axis along
the shaft, re-mounts the unit and turns once more with Y (practicum, lab 1, steps 11 to 16), so
that the angles start over: the first pass is taken as ``X_from``, the second as ``Y_from``. What
does not look like this is refused, because a wrong mount gives a wrong calibration silently.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from core.arrays import FloatArray, IntArray
from core.errors import FormatError, Note, Severity
from core.plans.orientation import Mount
from core.records.legacy.layout import plan_of

_CUSTOM = ("X_from", "Y_from")
_GIVE = "give the mounts, one a pass, e.g. X_from,Y_from, or one for all rows"


def mounts_by_number(numbers: FloatArray, plan_id: str) -> tuple[list[str], list[float]]:
    """Mounts and head angles of zero-based position numbers."""
    plan = plan_of(plan_id)
    steps = [plan.step(int(number) + 1) for number in numbers]
    return [step.mount for step in steps], [step.head_deg for step in steps]


def mounts_by_passes(
    path: str,
    temperatures: FloatArray,
    angles: FloatArray,
    lines: IntArray,
    mounts: Sequence[str] | None,
) -> tuple[list[str], tuple[Note, ...]]:
    """Mounts of the rows of a ClbAcc file, inferred unless they are given.

    Parameters
    ----------
    path : the file, for messages
    temperatures, angles : (n,) set temperature, degC, and head angle, deg
    lines : (n,) lines in the file
    mounts : one for all rows, one a pass, or one a pass of every stay at a temperature

    Raises
    ------
    FormatError
        The passes do not tell the mounts, or the given ones do not fit them.
    """
    sweep = _Sweep(path, temperatures, angles, lines, tuple(_passes(temperatures, angles)))
    if mounts is not None:
        return sweep.given(mounts), ()
    return sweep.inferred()


@dataclass(frozen=True, slots=True)
class _Pass:
    """Rows between two re-mounts: the head angles go once through their list.

    `visit` counts the stays at a set temperature, `within` the passes of a stay; `turned_back` is
    the first row whose angle had been left and came again, -1 if there is none.
    """

    visit: int
    within: int
    rows: tuple[int, ...]
    turned_back: int


@dataclass(frozen=True, slots=True, eq=False)
class _Sweep:
    path: str
    temperatures: FloatArray
    angles: FloatArray
    lines: IntArray
    passes: tuple[_Pass, ...]

    def inferred(self) -> tuple[list[str], tuple[Note, ...]]:
        for one in self.passes:
            if one.turned_back >= 0:
                raise FormatError(
                    self.path,
                    f"head angle {self.angles[one.turned_back]:g} comes again before the angles"
                    " start over: a repeated position, a sweep back or a re-mounted unit?"
                    f" {_GIVE}",
                    line=int(self.lines[one.turned_back]),
                    column=3,
                )
        per_visit = self._per_visit()
        if len(set(per_visit)) > 1 or per_visit[0] > len(_CUSTOM) or self._series_twice():
            raise FormatError(
                self.path, f"{self._count()}; this does not tell how the unit was mounted: {_GIVE}"
            )
        place = "" if len(per_visit) == 1 else " at each temperature"
        text = (
            f"one pass of angles{place} is taken as X_from"
            if per_visit[0] == 1
            else f"the angles start over{place}, so that the first pass is taken as X_from and the"
            " second as Y_from"
        )
        note = Note(
            Severity.INFO, "mount_inferred", f"{self.path}: the layout holds no mount; {text}"
        )
        return self._spread([_CUSTOM[one.within] for one in self.passes]), (note,)

    def given(self, mounts: Sequence[str]) -> list[str]:
        for mount in mounts:
            try:
                Mount.parse(mount)
            except ValueError as error:
                raise FormatError(self.path, str(error)) from error
        if len(mounts) == 1:
            return [mounts[0]] * len(self.angles)
        if len(mounts) == len(self.passes):
            return self._spread(list(mounts))
        if set(self._per_visit()) == {len(mounts)}:
            return self._spread([mounts[one.within] for one in self.passes])
        raise FormatError(
            self.path, f"{len(mounts)} mounts are given, but {self._count()}; {_GIVE}"
        )

    def _per_visit(self) -> list[int]:
        """Passes of each stay at a temperature."""
        counts = [0] * (self.passes[-1].visit + 1)
        for one in self.passes:
            counts[one.visit] += 1
        return counts

    def _series_twice(self) -> bool:
        """Whether one-pass stays go twice through the same temperatures, as after a re-mount."""
        series = [float(self.temperatures[one.rows[0]]) for one in self.passes]
        half = len(series) // 2
        return self.passes[-1].visit > 0 and half > 1 and series[:half] == series[half:]

    def _spread(self, mounts: list[str]) -> list[str]:
        by_row = [""] * len(self.angles)
        for one, mount in zip(self.passes, mounts, strict=True):
            for row in one.rows:
                by_row[row] = mount
        return by_row

    def _count(self) -> str:
        count = len(self.passes)
        starts = ", ".join(str(self.lines[one.rows[0]]) for one in self.passes[:8])
        more = ", ..." if count > 8 else ""
        visits = len(self._per_visit())
        stays = f" in {visits} stays at a temperature" if visits > 1 else ""
        word = "pass" if count == 1 else "passes"
        return f"the file has {count} {word} of head angles{stays} (lines {starts}{more})"


def _passes(temperatures: FloatArray, angles: FloatArray) -> list[_Pass]:
    passes: list[_Pass] = []
    rows: list[int] = []
    visit, within, turned_back = 0, 0, -1
    seen: set[float] = set()
    for i, angle in enumerate(angles.tolist()):
        left = i > 0 and temperatures[i] != temperatures[i - 1]
        repeat = bool(rows) and angle == angles[i - 1]
        over = bool(rows) and not repeat and angle == angles[rows[0]]
        if left or over:
            passes.append(_Pass(visit, within, tuple(rows), turned_back))
            within = 0 if left else within + 1
            visit += left
            rows, turned_back = [], -1
            seen.clear()
        elif not repeat and turned_back < 0 and angle in seen:
            turned_back = i
        rows.append(i)
        seen.add(angle)
    passes.append(_Pass(visit, within, tuple(rows), turned_back))
    return passes
