import numpy as np
import pytest

from core.errors import FormatError
from core.records.legacy.reader import parse_legacy

CARDINAL = [0, 90, 180, 270]


def clbacc(*blocks: tuple[float, list[int]]) -> str:
    lines: list[str] = []
    for temperature, angles in blocks:
        for angle in angles:
            cells = ["C", f"{temperature:+g}", angle, angle // 15, 0, 0, len(lines) + 1.25]
            lines.append("\t".join(map(str, [*cells, *[0] * 8, 14798, *[0] * 8])))
    return "\n".join(lines)


def run_of(*blocks, mounts=None):
    return parse_legacy(clbacc(*blocks), "f.txt").to_run(mounts=mounts)


def test_the_second_pass_is_about_y():
    run = run_of((27, CARDINAL * 2))
    assert run.mount == ("X_from",) * 4 + ("Y_from",) * 4
    assert run.run.tolist() == [1] * 8
    (note,) = run.notes
    assert note.subject == "mount_inferred"
    assert "second as Y_from" in note.text


def test_two_passes_at_each_temperature():
    run = run_of((27, CARDINAL * 2), (-10, CARDINAL * 2), (27, CARDINAL * 2))
    assert run.mount == (("X_from",) * 4 + ("Y_from",) * 4) * 3
    assert run.run.tolist() == [1] * 16 + [2] * 8


def test_one_pass_in_a_thermal_cycle_is_about_x():
    cycle = [27, -10, -40, -10, 27, 50, 70, 50, 27]
    run = run_of(*((t, CARDINAL) for t in cycle))
    assert set(run.mount) == {"X_from"}
    assert run.run[::4].tolist() == [1, 1, 1, 2, 2, 1, 1, 2, 3]


def test_replicates_without_moving_stay_in_their_pass():
    run = run_of((27, [0, 0, 90, 90, 180, 180, 270, 270, 0, 0, 90, 90]))
    assert run.mount == ("X_from",) * 8 + ("Y_from",) * 4
    assert run.run.tolist() == [1, 2] * 6


def test_360_is_not_the_start():
    run = run_of((27, [*range(0, 361, 15), *range(0, 361, 15)]))
    assert run.mount == ("X_from",) * 25 + ("Y_from",) * 25


@pytest.mark.parametrize(
    ("blocks", "why"),
    [
        ([(27, CARDINAL * 3)], "3 passes"),
        ([(27, CARDINAL * 2), (50, CARDINAL)], "3 passes of head angles in 2 stays"),
        # The same series of temperatures twice looks like a re-mount after the first.
        ([(27, CARDINAL), (50, CARDINAL), (27, CARDINAL), (50, CARDINAL)], "4 passes"),
    ],
)
def test_passes_that_do_not_tell_the_mount_are_refused(blocks, why):
    with pytest.raises(FormatError, match=why) as caught:
        run_of(*blocks)
    assert "X_from,Y_from" in str(caught.value)


@pytest.mark.parametrize(
    ("angles", "line"),
    [
        ([0, 90, 180, 270, 180, 90, 0], 5),
        ([0, 90, 180, 270, 270, 180, 90, 0], 6),
        ([0, 90, 180, 90, 270], 4),
        ([0, 90, 180, 270, 90, 180, 270, 0], 5),
    ],
)
def test_a_sweep_back_is_not_taken_for_a_remount(angles, line):
    with pytest.raises(FormatError, match="comes again") as caught:
        run_of((27, angles))
    assert (caught.value.line, caught.value.column) == (line, 3)


def test_given_mounts_replace_the_inference():
    assert run_of((27, CARDINAL * 3), mounts=["X_from", "Y_from", "Z_from"]).mount[8] == "Z_from"
    sweep = run_of((27, [0, 90, 180, 270, 180, 90, 0]), mounts=["Y_to"])
    assert set(sweep.mount) == {"Y_to"}
    assert sweep.run.tolist() == [1, 1, 1, 1, 2, 2, 2]
    assert sweep.notes == ()
    cycle = run_of((27, CARDINAL * 2), (50, CARDINAL * 2), mounts=["X_to", "Y_to@90"])
    assert cycle.mount == (("X_to",) * 4 + ("Y_to@90",) * 4) * 2


def test_mounts_that_do_not_fit_are_refused():
    with pytest.raises(FormatError, match="2 mounts are given, but the file has 3 passes"):
        run_of((27, CARDINAL * 3), mounts=["X_from", "Y_from"])
    with pytest.raises(FormatError, match="unknown mount 'W_from'"):
        run_of((27, CARDINAL), mounts=["W_from"])


def test_position_numbers_tell_the_mount():
    rows = "\n".join(
        "\t".join(map(str, [31, i, 0, 0, 1.5, *[0] * 8, *[24800] * 9])) for i in range(8)
    )
    run = parse_legacy(rows, "f.txt").to_run()
    assert run.mount == ("X_from",) * 4 + ("Y_from",) * 4
    np.testing.assert_array_equal(run.head_deg, CARDINAL * 2)
    with pytest.raises(FormatError, match="already tell"):
        parse_legacy(rows, "f.txt").to_run(mounts=["X_from"])


def test_the_inferred_senses_of_pointer_are_noted():
    rows = "\n".join(
        "\t".join(map(str, ["PW09", i, 0, 0, *[1.5] * 6, *[1] * 9])) for i in range(16)
    )
    run = parse_legacy(rows, "f.txt").to_run()
    assert run.mount[4:12] == ("X_to",) * 4 + ("Y_to",) * 4
    assert [note.subject for note in run.notes] == ["mount_inferred"]
