"""Commands of device files."""

import pytest

from core.errors import FormatError
from drivers.profile import load_profiles, parse_profile
from tests.drivers.device_texts import GOOD, LINES
from tests.drivers.streams import stored

COMMAND = """
[[command]]
name = "stop"
ascii = "=CONFIG,1\\r\\n"
"""


def test_text_commands_and_their_usual_settings():
    command = parse_profile(LINES + COMMAND, "x").commands["stop"]
    assert command.data == b"=CONFIG,1\r\n"
    assert (command.repeat, command.gap_ms, command.wait_ms) == (1, 0, 200)
    assert (command.expect, command.expect_bytes, command.capture) == ("", b"", {})


def test_a_name_is_used_once():
    with pytest.raises(FormatError, match=r'line 15: .* "stop" is used twice'):
        parse_profile(LINES + COMMAND + COMMAND, "x")


def test_a_checksum_can_only_be_appended_where_frames_have_one():
    with pytest.raises(FormatError, match="no checksum to append"):
        parse_profile(LINES + COMMAND + "append_checksum = true\n", "x")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('type = "uint"', 'type = "int"'),
        ("at = 3, type", "type"),
        ("size = 4", "size = 0"),
        ("size = 4", "length = 4, size = 4"),
    ],
)
def test_captures_are_read_strictly(old: str, new: str):
    head, _, tail = GOOD.partition("[command.capture]")
    with pytest.raises(FormatError, match="capture"):
        parse_profile(f"{head}[command.capture]{tail.replace(old, new)}", "x")


def test_packaged_commands_are_those_of_the_vendors():
    profiles = load_profiles()
    stored_ones = {frame["hex"] for frame in stored("inertiallabs").values()}
    stored_ones |= {frame["hex"] for frame in stored("xsens_mti").values()}
    stored_ones |= {frame["hex"] for frame in stored("vectornav").values()}
    for name, profile in profiles.items():
        if name in ("inertiallabs_ahrs", "pw09_raw", "vectornav_ascii", "vectornav_binary"):
            assert {command.data.hex() for command in profile.commands.values()} <= stored_ones
    assert profiles["xsens_mti"].commands["stop"].data.hex() in stored_ones
    # The examples of the Aceinna manuals, checksum included.
    assert profiles["aceinna_s1"].commands["identify"].data.hex() == "5555475002494423" + "3d"
    assert profiles["openimu_z1"].commands["identify"].data.hex() == "55557047005d5f"
