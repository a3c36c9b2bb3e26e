from core.plans.plan import load_plans
from core.records.legacy.layout import LEGACY_FORMATS, legacy_for, position_numbers


def test_the_table_of_layouts_is_consistent():
    for key, layout in LEGACY_FORMATS.items():
        names = [column.name for column in layout.columns]
        assert key == layout.id
        assert len(set(names)) == len(names)
        for sensor, outputs in layout.outputs.items():
            assert set(outputs) <= set(names)
            assert len(layout.axes[sensor]) == len(outputs)
    assert {layout.width for layout in LEGACY_FORMATS.values()} == {15, 19, 22, 23, 24}


def test_the_layout_of_a_test_by_its_program():
    plans = load_plans()
    wanted = {
        ("clbacc", "dividing_head", "clbacc_24"): "clbacc",
        ("clbacc", "dividing_head", "accelerometer_8"): "clbacc",
        ("pointer", "dividing_head", "pointer_16"): "pointer",
        ("pointer", "dividing_head", "accelerometer_8"): "pointer",
        ("pointer", "static_positions", "pointer_8"): "pointer",
        ("pointer", "accuracy", "pointer_8"): "accuracy",
        ("clbdus", "static_positions", "accelerometer_8"): "clbdus_head",
        ("clbdus", "rate_table", "accelerometer_8"): "rotation_table",
    }
    for (program, test, plan), layout in wanted.items():
        found = legacy_for(program, test, plans[plan])
        assert found is not None
        assert found.id == layout


def test_a_plan_that_a_layout_cannot_number_has_no_legacy_file():
    plans = load_plans()
    assert legacy_for("pointer", "dividing_head", plans["clbacc_24"]) is None
    assert legacy_for("clbdus", "static_positions", plans["pointer_16"]) is None
    assert legacy_for("cvgcom", "record", plans["pointer_16"]) is None


def test_position_numbers_are_the_screen_numbers_less_one():
    numbers = position_numbers("pointer_16")
    assert numbers["X_from", 0.0] == 0
    assert numbers["Y_from", 270.0] == 15
    assert len(numbers) == 16
