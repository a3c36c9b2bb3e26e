import array
import io
import stat
import sys
import wave

import numpy as np
import pytest

from core.errors import StorageError
from gui.widgets.sound import RATE, Cue, Sounds, sound_file, wave_bytes

on_posix = pytest.mark.skipif(sys.platform == "win32", reason="winsound plays without a program")


def tone_of(samples):
    spectrum = np.abs(np.fft.rfft(samples * np.hanning(samples.size), 1 << 16))
    return np.argmax(spectrum) * RATE / (1 << 16)


@pytest.mark.parametrize("cue", list(Cue))
def test_a_cue_is_its_tones(cue):
    with wave.open(io.BytesIO(wave_bytes(cue, 0.5))) as file:
        assert (file.getframerate(), file.getnchannels(), file.getsampwidth()) == (RATE, 1, 2)
        samples = np.array(array.array("h", file.readframes(file.getnframes())), dtype=float)
    assert 0.45 < np.abs(samples).max() / 32767 <= 0.5001
    place = 0
    for frequency, seconds in cue.value:
        count = round(seconds * RATE)
        part = samples[place : place + count]
        assert tone_of(part) == pytest.approx(frequency, rel=0.02)
        assert abs(part[0]) < 50
        assert abs(part[-1]) < 1500
        place += count
    assert place == samples.size


def test_a_file_is_made_once(tmp_path):
    path = sound_file(tmp_path / "sounds", Cue.DONE, 0.6)
    made = path.stat().st_mtime_ns
    assert sound_file(tmp_path / "sounds", Cue.DONE, 0.6) == path
    assert path.stat().st_mtime_ns == made
    assert sound_file(tmp_path / "sounds", Cue.DONE, 0.3) != path


def player(folder, name, body):
    path = folder / name
    path.write_text(f"#!/bin/sh\n{body}\n", encoding="utf-8")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


@pytest.fixture
def sounds(qapp, tmp_path):
    made = Sounds(tmp_path / "sounds")
    yield made
    made.stop()


@on_posix
def test_the_systems_player_gets_the_file(qtbot, sounds, tmp_path):
    heard = tmp_path / "heard"
    sounds._player = str(player(tmp_path, "aplay", f'echo "$@" > {heard}'))
    sounds.play(Cue.ERROR)
    qtbot.waitUntil(lambda: heard.exists() and bool(heard.read_text(encoding="utf-8")))
    words = heard.read_text(encoding="utf-8").split()
    assert words[0] == "-q"
    assert words[1].endswith(".wav")
    assert "error" in words[1]


@on_posix
def test_playing_never_waits_and_stop_ends_it(qtbot, sounds, tmp_path):
    sounds._player = str(player(tmp_path, "paplay", "exec sleep 30"))
    for cue in Cue:
        sounds.play(cue)
    process = sounds._process
    assert process is not None
    sounds.stop()
    assert sounds._process is None


@on_posix
def test_no_player_is_a_beep(qtbot, sounds, monkeypatch):
    beeps = []
    monkeypatch.setattr(sounds, "_beep", lambda: beeps.append(1))
    sounds._player = ""
    sounds.play(Cue.START)
    sounds._player = "/nowhere/aplay"
    sounds.play(Cue.START)
    qtbot.waitUntil(lambda: len(beeps) == 2)
    assert sounds._player == ""


def test_off_is_silent(sounds, monkeypatch):
    monkeypatch.setattr(sounds, "_run", lambda path: pytest.fail("played"))
    monkeypatch.setattr(sounds, "_beep", lambda: pytest.fail("beeped"))
    sounds.set_volume(-1.0)
    sounds.play(Cue.DONE)
    assert sounds.volume == 0.0
    sounds.set_volume(7.0)
    assert sounds.volume == 1.0


def test_a_cache_that_cannot_be_written_still_gives_a_cue(qtbot, tmp_path, monkeypatch):
    blocked = tmp_path / "file"
    blocked.write_text("", encoding="utf-8")
    with pytest.raises(StorageError):
        sound_file(blocked / "sounds", Cue.DONE, 0.5)
    sounds = Sounds(blocked / "sounds")
    beeps = []
    monkeypatch.setattr(sounds, "_beep", lambda: beeps.append(1))
    sounds.play(Cue.DONE)
    assert beeps == [1]
