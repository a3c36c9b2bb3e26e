import json
from pathlib import Path

import numpy as np
import pytest

from core.errors import FormatError
from core.records.legacy.reader import parse_legacy, read_legacy

DATA = Path(__file__).parents[3] / "data"
SPECIMENS = DATA / "legacy"


def text_of(name: str) -> str:
    return (SPECIMENS / name).read_text(encoding="utf-8")


def test_table_1_2():
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405131405.txt").to_run()
    assert (run.test, run.sensor, run.device) == ("dividing_head", "accelerometer", "Colibrys")
    assert (run.channels, run.axes, run.unit) == (("acc_1",), ("z",), "code")
    np.testing.assert_array_equal(run.y[:, 0], [13185.47, 521.57, -12872.84, -595.04])
    np.testing.assert_array_equal(run.head_deg, [0, 90, 180, 270])
    np.testing.assert_array_equal(run.temperature_c, [27] * 4)
    np.testing.assert_array_equal(run.extra["temp_1"], [14798, 14799, 14790, 14780])
    assert run.mount == ("X_from",) * 4
    assert [note.subject for note in run.notes] == ["mount_inferred"]
    assert np.isnan(run.y_se).all()
    assert np.isnan(run.t_s).all()
    assert run.meta["start_local"] == "2024-05-13T14:05"
    assert len(str(run.meta["source_sha256"])) == 64


def test_table_2_2_is_table_2_2_of_the_golden_numbers(golden):
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    printed = golden["table_2_2"]["input"]
    np.testing.assert_array_equal(run.y.T, [printed["U_ax"], printed["U_ay"], printed["U_az"]])
    assert run.axes == ("x", "y", "z")
    assert run.mount == ("X_from",) * 4 + ("Y_from",) * 4
    np.testing.assert_array_equal(run.head_deg, [0, 90, 180, 270] * 2)
    np.testing.assert_array_equal(run.extra["step"], [1, 2, 3, 4, 13, 14, 15, 16])
    np.testing.assert_array_equal(run.extra["temp_acc_x"][:4], [7963, 7963, 7966, 7967])
    assert run.extra["gyro_x"][1] == -523.06
    assert run.notes == ()


def test_the_gyros_of_a_pointer_file():
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run(sensor="gyro")
    assert (run.test, run.sensor, run.channels) == ("static_positions", "gyro", ("gyro_x",))
    assert run.y[2, 0] == -544.62
    assert run.extra["acc_z"][0] == 12866.3


def test_table_2_4(golden):
    for name in ("Accuracy_202405141110.txt", "Accuracy_202405141111.txt"):
        run = read_legacy(SPECIMENS / name).to_run()
        assert (run.test, run.sensor) == ("accuracy", "accelerometer")
        np.testing.assert_array_equal(run.y, [row["U"] for row in golden["table_2_4"]])
        np.testing.assert_array_equal(
            run.extra["unit_pitch_deg"], [row["ahrs_pitch_deg"] for row in golden["table_2_4"]]
        )
        np.testing.assert_array_equal(run.extra["mag_roll_deg"], [-0.05, -0.07, -0.118])
        assert np.isnan(run.head_deg).all()  # the layout holds no set angle
        np.testing.assert_array_equal(run.run, [1, 1, 1])


def test_table_3_2(golden):
    run = read_legacy(SPECIMENS / "RotationTable_202405151000.txt").to_run()
    assert (run.test, run.sensor, run.axes) == ("rate_table", "gyro", ("z",))
    printed = golden["table_3_2"]["input"]
    np.testing.assert_array_equal(run.set_rate_dps, printed["omega_dps"])
    np.testing.assert_array_equal(run.y[:, 0], printed["U"])


def test_table_3_3(golden):
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405151045.txt").to_run()
    assert (run.test, run.sensor, run.device) == ("static_positions", "gyro", "Gyro31")
    np.testing.assert_array_equal(run.y[:, 0], golden["table_3_3"]["input"]["U"])
    assert run.mount == ("X_from",) * 4


@pytest.fixture(scope="module")
def golden():
    path = DATA / "golden.json"
    return json.loads(path.read_text(encoding="utf-8"))["source001"]


def test_rows_of_several_devices_are_parted_by_name():
    one = text_of("OpticalDividingHead_202405151045.txt")
    file = parse_legacy(one + one.replace("Gyro31", "Gyro32"), "f.txt")
    with pytest.raises(FormatError, match="Gyro31, Gyro32"):
        file.to_run()
    run = file.to_run(device="Gyro32")
    assert (run.device, len(run)) == ("Gyro32", 4)
    with pytest.raises(FormatError, match="no rows of 'Gyro33'"):
        file.to_run(device="Gyro33")


def test_nothing_measured_is_refused():
    text = "".join(f"G\t{i}" + "\t0" * 20 + "\n" for i in range(4))
    with pytest.raises(FormatError, match="nothing was measured"):
        parse_legacy(text, "f.txt").to_run()


def test_a_sensor_that_the_layout_does_not_hold():
    file = read_legacy(SPECIMENS / "RotationTable_202405151000.txt")
    with pytest.raises(FormatError, match="no accelerometer"):
        file.to_run(sensor="accelerometer")
