"""What ``sim://`` addresses say."""

import math

import pytest

from drivers.virtual.address import rig_of, stand_of


def test_same_text_same_rig():
    assert rig_of("sim://clbacc?name=one") is rig_of("sim://clbacc?name=one")
    assert rig_of("sim://clbacc?name=one") is not rig_of("sim://clbacc?name=two")


def test_every_key():
    stand = stand_of(
        "sim://POINTER?speed=20&seed=7&rate=50&noise=0.5&cold=1&g=9.81&latitude=-30"
        "&effect=bias:10&effect=rate.x/bias:5&drop=0.1&bit_error=1e-6&half=0.2&garbage=0.3"
    )
    options = stand.rig.options
    assert (options.device, options.seed, options.noise, options.cold) == ("pointer", 7, 0.5, True)
    assert (options.place.g, options.place.latitude_deg) == (9.81, -30.0)
    assert stand.rig.rate_hz == 50.0
    assert stand.speed == 20.0
    truth = {output.role: output.values for output in stand.rig.truth()}
    assert truth["acc.x"][-1] == 10.0
    assert truth["rate.x"][-2:].tolist() == [10.0, 5.0]
    fast = stand_of("sim://cvg25?speed=max&block=5")
    assert math.isinf(fast.speed)
    assert fast.block_s == 5.0
    assert fast.rig.rate_hz == 200.0


@pytest.mark.parametrize(
    ("query", "why"),
    [
        ("sped=2", "unknown key 'sped'"),
        ("speed=fast", "speed = 'fast' is no number"),
        ("speed=0", "must be above zero"),
        ("block=-1", "must be above zero"),
        ("noise=nan", "no finite number"),
        ("effect=magic:1", "no effect 'magic'"),
        ("effect=bias", "is no number"),
    ],
)
def test_wrong_addresses(query, why):
    with pytest.raises(ValueError, match=why):
        rig_of(f"sim://clbacc?{query}")
