"""What the unit does with bytes from the computer."""

from drivers.commands import answer_in
from drivers.profile import load_profiles
from drivers.virtual.replies import Answering

PROFILE = load_profiles()["pw09_raw"]
IDENTITY = {"serial": "PW09", "firmware": "MiniAhrs 2.12", "model": "x"}


def unit(reply_bytes: int = 174) -> Answering:
    return Answering(PROFILE, IDENTITY, reply_bytes)


def test_commands_in_pieces_and_among_noise():
    one = unit()
    stop = PROFILE.commands["stop"].data
    one.receive(b"noise" + stop[:4])
    assert one.streaming
    one.receive(stop[4:] + b"more noise" * 100)
    assert not one.streaming
    assert one.reply() == b""


def test_answer_is_what_the_profile_expects():
    one = unit()
    question = PROFILE.commands["identify"]
    one.receive(question.data * 2)
    heard = one.reply()
    assert len(heard) == 2 * 174
    assert one.reply() == b""
    assert answer_in(question, b"frames before" + heard) == {
        "serial": "PW09",
        "firmware": "MiniAhrs 2.12",
    }


def test_a_unit_without_an_answer_is_silent():
    one = unit(reply_bytes=0)
    one.receive(PROFILE.commands["identify"].data)
    assert one.reply() == b""


def test_the_order_of_commands_is_kept():
    profile = load_profiles()["inertiallabs_ahrs"]
    one = Answering(profile, IDENTITY, 0)
    stop, start = profile.commands["stop"].data, profile.commands["start"].data
    one.receive(stop + start)
    assert one.streaming
    one.receive(start + stop)
    assert not one.streaming
