"""Device files: the packaged ones, those of a user, and every mistake told with its place."""

from pathlib import Path

import pytest

from core.errors import FormatError
from core.samples.block import Channel
from drivers.decoders import make_decoder
from drivers.profile import load_profile, load_profiles, parse_profile
from drivers.profile_types import FrameSpec, LineSpec
from tests.drivers.device_texts import GOOD, LINES


def test_every_word_of_a_file_arrives():
    profile = parse_profile(GOOD, "folder/board.toml")
    assert (profile.id, profile.name, profile.kind, profile.layout) == (
        "board", "Board", "adc", "clbacc",
    )  # fmt: skip
    port = profile.port
    assert port.bauds == (115200, 9600)
    assert (port.data_bits, port.parity, port.stop_bits) == (7, "E", 2)
    assert (port.settle_ms, port.dtr, port.rts) == (20, True, False)
    assert profile.params == {"K": 4.0}
    assert profile.nominal_hz == 50.0
    spec = profile.stream
    assert isinstance(spec, FrameSpec)
    assert spec.sync == (0xAA, None, 0x55)
    assert (spec.length, spec.reject_abs, spec.tail) == (12, 5.0, b"")
    assert [field.at for field in spec.fields] == [3, 4, 9]
    assert spec.fields[1].channels == (
        Channel("x", "deg/s", "rate.x"),
        Channel("y", "deg/s", "rate.y"),
    )
    assert (spec.fields[1].scale, spec.fields[1].offset) == (0.25, 1.0)
    assert (spec.fields[2].bits, spec.fields[2].endian) == ((1, 2), "little")
    assert spec.counter is not None
    assert (spec.counter.bits, spec.counter.step) == (8, 2)
    command = profile.commands["identify"]
    assert command.data == bytes.fromhex("AA 00 55 01 01")
    assert (command.repeat, command.gap_ms, command.wait_ms) == (2, 10, 30)
    assert command.expect_bytes == b"\xaa\x01"
    assert command.capture["serial"].size == 4


def test_a_unit_has_its_own_params():
    profile = parse_profile(GOOD, "board", {"K": 8})
    assert isinstance(profile.stream, FrameSpec)
    assert profile.stream.fields[1].scale == 0.125
    with pytest.raises(FormatError, match='no "KA"'):
        parse_profile(GOOD, "board", {"KA": 8})


def test_what_is_no_toml_is_refused_with_the_place():
    with pytest.raises(FormatError, match="line 3"):
        parse_profile("schema = 1\n\nname = \n", "x.toml")


def test_packaged_profiles_load_and_have_decoders():
    profiles = load_profiles()
    assert list(profiles) == sorted(profiles)
    assert {"cvgx48", "adc_board9", "pw09_raw", "inertiallabs_ahrs", "stim300"} <= set(profiles)
    for profile in profiles.values():
        assert make_decoder(profile).feed(b"") == []
        assert profile.device.notes, profile.id


def test_boards_whose_format_is_unknown_say_so():
    profiles = load_profiles()
    for name, layout in (
        ("pw09_raw", "pointer"), ("adc_board9", "clbacc"), ("adxrs_board9", "clbdus"),
    ):  # fmt: skip
        assert profiles[name].layout == layout
        assert "ASSUMED" in profiles[name].device.notes


@pytest.mark.parametrize("name", ["adc_board9", "adxrs_board9"])
def test_the_boards_have_nine_sensors_and_nine_temperatures(name: str):
    roles = [channel.role for channel in make_decoder(load_profiles()[name]).channels]
    assert roles == [f"adc.{n}" for n in range(1, 10)] + [f"temp.adc.{n}" for n in range(1, 10)]


def test_a_file_of_the_user_is_added_or_replaces_one(tmp_path: Path):
    (tmp_path / "mine.toml").write_text("\ufeff" + GOOD, encoding="utf-8")
    (tmp_path / "cvgx48.toml").write_text(LINES, encoding="utf-8")
    profiles = load_profiles(tmp_path)
    assert profiles["mine"].name == "Board"
    assert isinstance(profiles["cvgx48"].stream, LineSpec)
    assert load_profile(tmp_path / "mine.toml") == profiles["mine"]


def test_a_broken_file_of_the_user_is_named(tmp_path: Path):
    (tmp_path / "bad.toml").write_bytes(b"\xff\xfe")
    with pytest.raises(FormatError, match=r"bad\.toml"):
        load_profiles(tmp_path)
    with pytest.raises(FormatError, match="cannot be read"):
        load_profile(tmp_path / "none.toml")


def test_the_examples_of_the_manual_can_be_read():
    page = (Path(__file__).parents[2] / "docs" / "device-files.md").read_text("utf-8")
    frame, line = (block.partition("```")[0] for block in page.split("```toml\n")[1:])
    profile = parse_profile(frame, "example")
    assert [channel.role for channel in make_decoder(profile).channels] == [
        "acc.x", "acc.y", "acc.z",
    ]  # fmt: skip
    assert len(profile.commands["identify"].data) == 6
    head = frame.partition("[frame]")[0]
    assert isinstance(parse_profile(head + line, "example").stream, LineSpec)


def test_a_missing_folder_of_the_user_is_an_empty_one(tmp_path: Path):
    assert list(load_profiles(tmp_path / "none")) == list(load_profiles())
