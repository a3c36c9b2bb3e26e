import json
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest

from core.errors import FormatError, Severity
from core.plans.plan import load_plans
from core.procedures.accuracy import Limit, check_accuracy
from core.records.legacy.reader import read_legacy
from core.records.session.record import JOURNAL_NAME, START_NAME, extra_name, read_session
from core.records.session.store import Session
from core.samples.accumulate import accumulation_of
from core.samples.block import Channel
from core.samples.run import Conditions


@pytest.fixture
def session(tmp_path, start, clock):
    with Session.create(tmp_path / "s", start, now=clock) as session:
        yield session


def test_a_session_as_a_run(session, start, means):
    steps = start.plan.steps
    session.accept(steps[0], means(1000.0), temperature_c=26.1)
    session.accept(steps[0], means(2000.0))
    session.accept(steps[4], means(3000.0), set_temperature_c=50.0)
    run = read_session(session.folder).run()
    assert (run.test, run.sensor, run.device) == ("dividing_head", "accelerometer", "PW09")
    assert (run.channels, run.axes) == (("acc_x", "acc_y", "acc_z"), ("x", "y", "z"))
    assert run.unit == "code"
    np.testing.assert_allclose(run.y[:, 0], [1000, 2000, 3000], atol=0.5)
    assert (run.y_se > 0).all()
    assert run.run.tolist() == [1, 2, 1]
    assert run.mount == ("X_from", "X_from", "Y_from")
    assert run.t_s.tolist() == [10.0, 30.0, 50.0]
    np.testing.assert_array_equal(run.temperature_c, [26.1, np.nan, 50.0])
    assert np.isnan(run.set_rate_dps).all()
    assert run.extra["step"].tolist() == [1, 1, 13]
    assert run.extra["attempt"].tolist() == [1, 2, 1]
    assert {"gyro_x", "temp_case", "temp_acc_x", "se_dof", "samples"} <= set(run.extra)
    np.testing.assert_array_equal(run.extra["set_temperature_c"], [np.nan, np.nan, 50.0])
    assert run.conditions.accumulation_s == start.plan.accumulation_s
    assert run.conditions.sample_rate_hz == 100.0
    assert run.meta["plan"] == "pointer_8"
    assert run.meta["profile"] == "pw09_raw"
    assert run.meta["measured_utc"] == "2024-05-14T06:30:05+00:00"
    assert len(str(run.meta["source_sha256"])) == 64


def test_the_other_sensor_of_the_unit(session, start, means):
    session.accept(start.plan.steps[0], means(1.0))
    run = session.run("gyro")
    assert (run.test, run.channels, run.axes) == ("static_positions", ("gyro_x",), ("x",))
    assert "acc_z" in run.extra


def test_an_assembly_of_nine_with_seven_unused_places(tmp_path, start):
    channels = tuple(Channel(f"S{i}", "code", f"adc.{i}") for i in range(1, 10))
    channels += tuple(Channel(f"T{i}", "code", f"temp.adc.{i}") for i in range(1, 10))
    plan = load_plans()["accelerometer_8"]
    board = replace(start, channels=channels, sensor="gyro", plan=plan, legacy="clbdus_head")
    data = np.zeros((32, 18))
    data[:, [1, 4]] = np.random.default_rng(1).normal(-700.0, 1.0, (32, 2))
    data[:, 13] = 24800.0
    with Session.create(tmp_path / "s", board) as session:
        session.accept(plan.steps[0], accumulation_of(channels, np.arange(32) / 100, data))
        run = session.run()
        assert session.legacy_error is None
    assert (run.test, run.channels, run.axes) == (
        "static_positions",
        ("gyro_2", "gyro_5"),
        ("z", "z"),
    )
    assert run.extra["temp_5"].tolist() == [24800.0]


def test_rates_of_a_table(tmp_path, start, means):
    plan = load_plans()["pointer_8"]
    step = replace(plan.steps[0], rate_dps=-80.0)
    table = replace(start, sensor="gyro", plan=replace(plan, test="rate_table"), legacy="")
    with Session.create(tmp_path / "s", table) as session:
        session.accept(step, means(1.0))
        run = session.run()
    assert run.test == "rate_table"
    assert run.set_rate_dps.tolist() == [-80.0]


def test_a_session_without_rows_or_without_the_sensor(session, start, means):
    with pytest.raises(FormatError, match="no position has been accepted"):
        session.run()
    session.accept(start.plan.steps[0], means(1.0))
    with pytest.raises(FormatError, match="no magnetometer"):
        session.run("magnetometer")


def test_doubts_about_positions_come_with_the_run(session, start, means):
    doubtful = accumulation_of(
        start.channels, np.arange(8) / 100, np.random.default_rng(1).normal(5, 1, (8, 7))
    )
    session.accept(start.plan.steps[4], doubtful)
    notes = session.run().notes
    assert notes[0].subject == "too_short"
    assert notes[0].text.startswith("position 13: ")


def test_missing_events_are_told(session, start, means):
    for step in start.plan.steps[:3]:
        session.accept(step, means(1.0))
    path = session.folder / JOURNAL_NAME
    lines = path.read_bytes().splitlines(True)
    path.write_bytes(lines[0] + lines[2])
    record = read_session(session.folder)
    assert [(note.severity, note.subject) for note in record.notes] == [
        (Severity.ERROR, "events_missing")
    ]
    assert len(record.positions) == 2
    assert record.run().notes[0].subject == "events_missing"


def test_what_is_no_session_is_refused(tmp_path, session):
    with pytest.raises(FormatError, match="cannot be read"):
        read_session(tmp_path)
    document = json.loads((session.folder / START_NAME).read_text(encoding="utf-8"))
    document["schema_version"] = 9
    (session.folder / START_NAME).write_text(json.dumps(document), encoding="utf-8")
    with pytest.raises(FormatError, match="newer CalRig"):
        read_session(session.folder)


@pytest.mark.parametrize(
    ("role", "name"),
    [
        ("acc.x", "acc_x"),
        ("rate.z", "gyro_z"),
        ("temp", "temp_case"),
        ("temp.adc.3", "temp_3"),
        ("temp.rate.y", "temp_gyro_y"),
        ("temp.mag.z", "temp_mag_z"),
        ("angle.pitch", "unit_pitch_deg"),
        ("", "channel_N"),
    ],
)
def test_names_of_further_columns(role, name):
    assert extra_name(Channel("N", "code", role)) == name


ANGLES = tuple(Channel(name, "deg", f"angle.{name}") for name in ("heading", "pitch", "roll"))


def accuracy_session(folder, start, clock, channels):
    plan = load_plans()["roll_accuracy_3"]
    begun = replace(start, plan=plan, channels=channels, legacy="accuracy")
    opened = Session.create(folder, begun, now=clock)
    for step, angle in zip(plan.steps, (0.0, 30.0, 60.0), strict=True):
        rng = np.random.default_rng(step.number)
        data = rng.normal(0.0, 0.02, (200, len(channels)))
        data[:, -3:] += [120.0, 0.1, angle]
        data[:, 1:-3] += 500.0 * step.number
        opened.accept(step, accumulation_of(channels, np.arange(200) / 100.0, data))
    opened.finish()
    return read_session(folder)


def test_a_unit_without_raw_codes_is_measured_by_its_angles(tmp_path, start, clock):
    channels = (Channel("N", "", "counter"), *ANGLES)
    record = accuracy_session(tmp_path / "s", start, clock, channels)
    run = record.run()
    assert run.channels == ()
    assert run.y.shape == (3, 0)
    assert run.extra["unit_roll_deg"] == pytest.approx([0.0, 30.0, 60.0], abs=0.01)
    found = check_accuracy(run, Conditions(g_mps2=9.81), limit=Limit(0.1))
    assert found.traces[0].source == "inter"
    assert found.trace("inter").statistics.noise_std == pytest.approx(0.02, rel=0.2)
    assert "no raw codes" in found.notes[0].text
    # The text for the old programs, and the same once more from it.
    (legacy,) = record.folder.glob("Accuracy_*.txt")
    again = check_accuracy(read_legacy(legacy).to_run(), Conditions(g_mps2=9.81), kind="roll")
    assert again.trace("inter").error == pytest.approx(found.trace("inter").error, abs=6e-3)
    # On the head the same unit has nothing that could be calibrated.
    with pytest.raises(FormatError, match="no accelerometer"):
        replace(record, start=replace(record.start, plan=start.plan)).run()


def test_an_accuracy_check_keeps_the_noise_of_single_samples(tmp_path, start, clock):
    channels = (*start.channels[:4], *ANGLES)
    run = accuracy_session(tmp_path / "s", start, clock, channels).run()
    assert run.channels == ("acc_x", "acc_y", "acc_z")
    for name in ("std_acc_x", "std_acc_z", "std_unit_roll_deg"):
        assert run.extra[name] == pytest.approx([0.02] * 3, rel=0.2)
    assert run.extra["se_unit_roll_deg"] == pytest.approx([0.02 / 200**0.5] * 3, rel=0.6)


def test_a_clock_that_was_set_back_is_told(tmp_path, start, means):
    first = datetime(2024, 5, 14, 6, 30, 15, tzinfo=UTC)
    shown = iter([first, first, first - timedelta(hours=1), first - timedelta(hours=1)])
    with Session.create(tmp_path / "s", start, now=lambda: next(shown)) as session:
        for step in start.plan.steps[:2]:
            session.accept(step, means(100.0), temperature_c=26.0)
        (note,) = [n for n in session.run().notes if n.subject == "clock_set_back"]
    one, other = (step.number for step in start.plan.steps[:2])
    assert f"between positions {one} and {other} (2024-05-14 06:30:15, then" in note.text
