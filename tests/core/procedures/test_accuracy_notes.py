"""Notes on angles that do not follow; the others are tested with the check itself."""

import numpy as np

from core.procedures.accuracy_notes import head_note, mount_notes, no_calibration, no_codes

SET = np.array([0.0, 30.0, 60.0, 120.0, 180.0])


def test_angles_that_follow_are_fine():
    assert mount_notes(SET, SET + 0.5) == []
    assert mount_notes(np.array([179.9]), np.array([-179.9])) == []


def test_angles_that_follow_backwards_are_named():
    (note,) = mount_notes(SET, -SET + 0.1)
    assert note.subject == "sign_reversed"
    assert "0.1 deg with the sign turned" in note.text


def test_angles_that_do_not_follow_are_named():
    (note,) = mount_notes(SET, SET + 45.0)
    assert note.subject == "wrong_angles"
    assert "45 deg off" in note.text


def test_what_is_missing_is_said():
    assert "PW09" in no_codes("PW09").text
    assert no_calibration().subject == "no_calibration"
    assert head_note().subject == "head_u_missing"
