"""What an operator changes in a description."""

import numpy as np

from core.samples.block import Channel
from drivers.profile import parse_profile
from drivers.profile_types import FrameSpec
from drivers.teach.analysis import analyse
from drivers.teach.frames import FrameProposal
from gui.frames.readings import field_rows, read_latest
from gui.frames.saving import file_of, save, why_not
from gui.frames.taught import (
    Taught,
    add_fields,
    change_channel,
    change_field,
    change_scale,
    found,
    remove_fields,
    with_check,
)
from tests.drivers.teach.layouts import frames_of
from tests.gui.frames.conftest import strange

ROWS = frames_of(strange(), np.random.default_rng(1), 0, 300)
DATA = ROWS.tobytes()


def taught() -> Taught:
    return found(Taught(name="Board"), analyse(DATA, 17.0 * 200.0))


def spec_of(one: Taught) -> FrameSpec:
    assert isinstance(one.stream, FrameSpec)
    return one.stream


def types(one: Taught) -> list[tuple[int, str]]:
    return [(field.at, field.type) for field in spec_of(one).fields]


def test_what_was_found_is_a_device_file():
    one = taught()
    assert one.doubt(115200) == ""
    profile = parse_profile(one.text(115200), "board.toml")
    assert profile.stream == one.stream
    assert profile.nominal_hz == 200.0


def test_pointing_at_bytes_replaces_what_stood_there():
    one = remove_fields(taught(), 5, 6)
    assert (4, "i24") not in types(one)
    assert types(add_fields(one, 4, 7, ROWS)) == types(taught())
    # A part of two numbers takes both away and is one of its own.
    over = add_fields(taught(), 6, 8, ROWS)
    assert (6, "u16") in types(over) or (6, "i16") in types(over)
    assert not {(4, "i24"), (7, "i24")} & set(types(over))


def test_bytes_that_stay_the_same_become_one_whole_number():
    still = ROWS.copy()
    still[:, 4:6] = 7
    assert (4, "u16") in types(add_fields(taught(), 4, 6, still))


def test_taking_the_counter_away_takes_its_counting_away():
    one = taught()
    assert spec_of(one).counter is not None
    assert spec_of(remove_fields(one, 3, 4)).counter is None


def test_a_role_makes_a_counter_and_another_ends_it():
    one = change_channel(taught(), 0, Channel("n", "code"))
    assert spec_of(one).counter is None
    again = change_channel(one, 0, Channel("n", "code", "counter"))
    assert spec_of(again).counter.field == "n"
    assert again.doubt(9600) == ""


def test_types_scales_and_hiding_are_changed():
    one = change_scale(taught(), 1, 0.5, -2.0)
    one = change_field(one, 1, type="u24", endian="little")
    one = change_field(one, 2, hide=True)
    field = spec_of(one).fields[1]
    assert (field.type, field.endian, field.scale, field.offset) == ("u24", "little", 0.5, -2.0)
    assert spec_of(one).fields[2].hide
    # What would reach beyond the frame is refused.
    assert change_field(one, 4, type="f64") == one


def test_a_unit_that_a_role_does_not_take_is_told():
    doubt = change_channel(taught(), 1, Channel("a", "furlong", "acc.x")).doubt(9600)
    assert "m/s^2" in doubt


def test_without_a_checksum_the_next_header_decides():
    one = with_check(taught(), None)
    assert spec_of(one).checksum is None
    assert with_check(one, one.checks[0]).stream == taught().stream


def test_text_has_columns_to_change():
    data = b"".join(b"%d,%d.5\n" % (n, n % 7) for n in range(60))
    one = found(Taught(name="Lines"), analyse(data))
    one = change_channel(one, 1, Channel("ax", "m/s^2", "acc.x"))
    one = change_scale(one, 1, 9.8, 0.0)
    assert one.doubt(9600) == ""
    rows = field_rows(one, np.empty((0, 0), np.uint8))
    assert [(row.name, row.scale) for row in rows] == [("ch1", 1.0), ("ax", 9.8)]
    # Byte operations mean nothing here.
    assert add_fields(one, 0, 2, ROWS) == remove_fields(one, 0, 2) == with_check(one, None) == one
    live = read_latest(data, one).live
    assert live[1].value == f"{9.8 * 3.5:.3f}"


def test_live_values_need_a_whole_frame():
    assert [live.value for live in read_latest(b"", taught()).live] == [""] * 5
    readings = read_latest(DATA, taught())
    assert readings.live[0].value == str(299 % 256)
    assert readings.per_byte == 1 / 17
    assert readings.bytes.parts[0].name == "header"


def test_nothing_is_no_device_file():
    assert Taught().doubt(9600)
    assert Taught().text(9600) == ""
    unnamed = found(Taught(), analyse(DATA))
    assert "name" in unnamed.doubt(9600)


def test_files_of_the_program_are_not_covered_up(tmp_path):
    assert "another name" in why_not(tmp_path, "CVGx48", ["cvgx48"])
    assert why_not(tmp_path, "Board", ["cvgx48"]) == ""
    path = save(tmp_path, taught(), 57600)
    assert path == file_of(tmp_path, "Board")
    # One's own may be written again.
    assert why_not(tmp_path, "Board", ["board"]) == ""


def test_a_proposal_of_frames_brings_its_checks():
    proposal = analyse(DATA)
    assert isinstance(proposal.found, FrameProposal)
    assert taught().checks == proposal.found.checks
