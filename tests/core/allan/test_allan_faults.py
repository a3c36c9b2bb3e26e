import numpy as np
import pytest

from core.allan import faults
from core.allan.record import survey


def subjects(values):
    return [note.subject for note in survey(values).notes]


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("lsb", [0.0, 0.01, 0.1, 0.5, 1.0, 3.0])
def test_honest_noise_of_any_resolution_is_not_accused(seed, lsb):
    values = np.random.default_rng(seed).normal(size=40_000) + 0.3
    if lsb:
        values = np.rint(values / lsb) * lsb
    assert subjects(values) == []


@pytest.mark.parametrize("limit", [1.0, 2.0, 3.0])
def test_clipping_is_seen_on_the_side_where_it_is(limit):
    values = np.random.default_rng(1).normal(size=40_000)
    (note,) = survey(np.minimum(values, limit)).notes
    assert note.subject == "clipped"
    assert f"value {limit:.9g}" in note.text
    (note,) = survey(np.maximum(values, -limit)).notes
    assert f"value {-limit:.9g}" in note.text


def test_clipped_codes_are_seen():
    codes = np.rint(np.random.default_rng(1).normal(size=40_000) * 20.0)
    assert subjects(np.clip(codes, -40.0, 30.0)) == ["clipped", "clipped"]


def test_a_channel_that_froze_for_a_second_is_seen():
    values = np.random.default_rng(2).normal(size=40_000)
    values[12_000:12_100] = values[12_000]
    (note,) = survey(values).notes
    assert note.subject == "stuck"
    assert note.text.startswith("100 samples")


def test_a_frozen_stretch_is_found_across_chunks(monkeypatch):
    monkeypatch.setattr(faults, "CHUNK", 1000)
    values = np.random.default_rng(2).normal(size=40_000)
    values[11_900:12_150] = values[11_900]
    (note,) = survey(values).notes
    assert note.text.startswith("250 samples")


def test_frozen_coarse_code_is_seen():
    codes = np.rint(np.random.default_rng(2).normal(size=40_000) * 0.6)
    codes[500:900] = 1.0
    assert subjects(codes) == ["stuck"]


def test_equal_samples_on_both_sides_of_a_gap_are_no_run():
    values = np.random.default_rng(2).normal(size=4000)
    values[1940:2060] = 0.25
    values[2000] = np.nan
    found = survey(values, gaps="stretches")
    assert [note.subject for note in found.notes] == ["gaps"]
