"""The comparison of lab 6 from files: runs, calibrations, Allan results."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import pytest

from core.errors import FitError, FormatError
from core.fit.estimate import Estimate
from core.procedures.comparison import compare_columns
from core.procedures.rate_calibration import calibration_of
from core.procedures.rate_table import calibrate_rate_table
from core.records.calibration_json import write_calibration
from core.records.gyro_facts import Facts, column_of, read_facts
from core.records.legacy.reader import read_legacy
from core.samples.run import Conditions

DATA = Path(__file__).parents[2] / "data"
LEGACY = DATA / "legacy"
TABLE = LEGACY / "RotationTable_202405151000.txt"
GOLDEN = json.loads((DATA / "golden.json").read_text("utf-8"))["source001"]
G = Conditions(g_mps2=9.8106)
HEAD = "device channel term symbol method convention unit value u lower95 upper95 upper_limit"


def head_file() -> Path:
    return next(
        path
        for path in sorted(LEGACY.glob("OpticalDividingHead_*.txt"))
        if read_legacy(path).layout.id == "clbdus_head"
    )


def noise_file(path: Path, *rows: tuple[object, ...]) -> Path:
    with path.open("w", encoding="utf-8", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow([*HEAD.split(), "regressed", "file"])
        writer.writerows(rows)
    return path


def row(term: str, unit: str, value: float, **changes: object) -> tuple[object, ...]:
    told: dict[str, object] = {
        "method": "likelihood", "upper": 1.2 * value, "limit": 0, "regressed": "", **changes
    }  # fmt: skip
    low = 0.8 * value
    return ("CVG25", "GyroOut", term, "N", told["method"], "words", unit, value, value / 100, low,
            told["upper"], told["limit"], told["regressed"], "a.txt")  # fmt: skip


def test_a_run_on_the_table_is_table_3_2():
    (facts,) = read_facts(TABLE, G)
    assert facts.quantities["scale_factor"].value == pytest.approx(-79.378668)
    assert facts.quantities["bias"].value == pytest.approx(5.5189089)
    assert "nonlinearity" in facts.quantities


def test_the_head_alone_gives_codes_and_with_a_scale_factor_deg_per_second():
    (facts,) = read_facts(head_file(), G)
    assert not facts.quantities
    assert facts.in_output["g_sensitivity"].value == pytest.approx(1.167105, rel=1e-6)
    column, notes = column_of("Gyro31", [facts])
    assert "g_sensitivity" not in column.quantities
    assert "scale factor is missing" in notes[0].text
    (table,) = read_facts(TABLE, G)
    column, _ = column_of("Gyro31", [facts, table])
    assert column.quantities["g_sensitivity"].value == pytest.approx(-0.014703005, rel=1e-5)
    assert column.quantities["g_sensitivity"].unit == "(deg/s)/(m/s^2)"


def test_a_calibration_file_tells_the_same_as_its_run(tmp_path):
    found = calibrate_rate_table(read_legacy(TABLE).to_run(), G)
    write_calibration(calibration_of(found), tmp_path / "g.cal.json")
    (facts,) = read_facts(tmp_path / "g.cal.json", G)
    (of_run,) = read_facts(TABLE, G)
    for name in ("scale_factor", "bias"):
        assert facts.quantities[name].value == pytest.approx(of_run.quantities[name].value)
        assert facts.quantities[name].u == pytest.approx(of_run.quantities[name].u)


def test_allan_results_best_method_after_regression_and_limits(tmp_path):
    path = noise_file(
        tmp_path / "noise.csv",
        row("random_walk", "deg/sqrt(s)", 3e-4, method="graphical"),
        row("random_walk", "deg/sqrt(s)", 2e-4),
        row("random_walk", "deg/sqrt(h)", 1.2e-2),
        row("random_walk", "deg/sqrt(s)", 1.9e-4, regressed="Temperature"),
        row("bias_instability", "deg/s", 1e-5, limit=1, upper=2e-5),
    )
    (facts,) = read_facts(path, G)
    assert facts.name == "CVG25 GyroOut"
    assert facts.quantities == {
        "random_walk": Estimate(1.9e-4, 1.9e-6, float("inf"), "deg/s/sqrt(Hz)")
    }
    assert "below 2e-05 deg/s" in facts.notes[0].text


def test_files_that_tell_nothing(tmp_path):
    broken = tmp_path / "noise.csv"
    broken.write_text("device,channel,term,\na,b,random_walk,\n", encoding="utf-8")
    with pytest.raises(FormatError, match="no table of noise"):
        read_facts(broken, G)
    with pytest.raises(FitError, match="no noise of a gyro"):
        read_facts(noise_file(tmp_path / "v.csv", row("random_walk", "V", 1.0)), G)
    with pytest.raises(FitError, match="gyros are compared"):
        read_facts(LEGACY / "Accuracy_202405141110.txt", G)


def test_two_sources_that_differ_are_told():
    one = Facts("A", "g", "a.json", {"bias": Estimate(1.0, 0.1, 9.0, "deg/s")}, {})
    other = replace(one, source="b.json", quantities={"bias": Estimate(2.0, 0.1, 9.0, "deg/s")})
    column, notes = column_of("A", [one, other])
    assert column.quantities["bias"].value == 2.0
    assert "differ in the bias by 7.1 standard uncertainties" in notes[0].text
    assert column_of("A", [one, one])[1] == ()


def test_the_table_of_several_units():
    facts = [Facts(n, "", "x", {"bias": Estimate(v, 0.1, 9.0, "deg/s")}, {}) for n, v in
             (("A", -0.5), ("B", 2.0))]  # fmt: skip
    table = compare_columns([column_of(one.name, [one])[0] for one in facts])
    bias = next(row for row in table.rows if row.id == "bias")
    assert (table.columns, bias.best) == (("A", "B"), 0)
