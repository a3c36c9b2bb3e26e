"""The C function is compiled and gives the Python result to one count; JSON holds it all."""

import json
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.calibration import Provenance
from core.procedures.drift.compensate import compensate
from core.procedures.drift.curves import Alignment, Curves
from core.procedures.drift.export import c_header, document, identifier, quantised
from core.procedures.drift.table import DriftTable
from core.records.json_text import to_json

WHO = Provenance("drift", "GIB-7 */ tricky", software="CalRig", computed_utc="2026-01-01T00:00:00")
PROGRAM = """
#include <stdio.h>
#include <inttypes.h>
#include "table.h"
int main(void) {
    uint32_t time; int32_t temperature;
    while (scanf("%" SCNu32 " %" SCNd32, &time, &temperature) == 2)
        printf("%" PRId32 "\\n", NAME_correction(time, temperature));
    return 0;
}
"""


def compiled(folder: Path, table: DriftTable, name: str) -> Path:
    compiler = shutil.which("cc")
    assert compiler is not None, "a C compiler is needed to test the exported header"
    (folder / "table.h").write_text(c_header(table, name, WHO), encoding="utf-8")
    (folder / "main.c").write_text(PROGRAM.replace("NAME", name), encoding="utf-8")
    strict = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror"]
    subprocess.run(
        [compiler, *strict, "main.c", "-o", "lookup"], cwd=folder, check=True, capture_output=True
    )
    return folder / "lookup"


def answers(program: Path, times: np.ndarray, temperatures: np.ndarray) -> np.ndarray:
    asked = "\n".join(f"{a} {b}" for a, b in zip(times, temperatures, strict=True))
    done = subprocess.run([program], input=asked, capture_output=True, text=True, check=True)
    return np.array(done.stdout.split(), dtype=np.int64)


def test_the_compiled_function_agrees_to_one_count(tmp_path: Path, sharp: Curves):
    table = compensate(sharp, "deg/s", knots=10).table
    integers = quantised(table)
    rng = np.random.default_rng(8)
    edges = [0, 1, *integers.times.tolist(), 65535, 4_000_000]
    times = np.concatenate([np.repeat(edges, 40), rng.integers(0, 66000, 4000)])
    some = [-32768, *integers.temperatures.tolist(), 32767]
    temperatures = np.concatenate(
        [np.resize(some, len(edges) * 40), rng.integers(-6000, 8000, 4000)]
    )
    found = answers(compiled(tmp_path, table, "gyro_x"), times, temperatures)
    same = [integers.lookup(int(a), int(b)) for a, b in zip(times, temperatures, strict=True)]
    assert found.tolist() == same
    floating = np.array(
        [
            table.correction(
                np.array([a * integers.time_unit_ms / 1e3]), b / 100.0, extrapolate=True
            )[0]
            for a, b in zip(times, temperatures, strict=True)
        ]
    )
    # Rounding of knots and temperatures moves the argument, not the value.
    steep = np.abs(np.diff(table.values, axis=1) / np.diff(table.times_s)).max()
    slack = steep * integers.time_unit_ms / 1e3 / integers.lsb
    assert np.abs(found - floating / integers.lsb).max() <= 1.0 + slack


def test_on_knots_of_whole_counts_one_count_is_all(tmp_path: Path):
    rng = np.random.default_rng(9)
    values = np.cumsum(rng.normal(size=(5, 8)), axis=1)
    table = DriftTable(
        "deg/s",
        np.array([2.0, 5.0, 9.0, 20.0, 31.0, 60.0, 90.0, 120.0]),
        np.array([-40.0, -10.0, 25.5, 50.0, 85.0]),
        values,
        values,
        np.zeros(5),
        Alignment(1.5, 2.0, 0.0),
    )
    integers = quantised(table)
    times, temperatures = rng.integers(900, 61000, 3000), rng.integers(-4200, 8700, 3000)
    found = answers(compiled(tmp_path, table, "d"), times, temperatures)
    exact = [
        table.correction(np.array([a * integers.time_unit_ms / 1e3]), b / 100, extrapolate=True)[0]
        for a, b in zip(times, temperatures, strict=True)
    ]
    assert np.abs(found - np.array(exact) / integers.lsb).max() <= 1.0


def test_a_table_of_one_temperature_compiles(tmp_path: Path, sharp: Curves):
    table = compensate(sharp, "deg/s", knots=4).table
    lonely = replace(table, temperatures_c=table.temperatures_c[:1], values=table.values[:1])
    integers = quantised(lonely)
    found = answers(compiled(tmp_path, lonely, "one"), integers.times, np.full(4, 9999))
    assert found.tolist() == integers.values[0].tolist()


def test_the_head_says_what_it_is(sharp: Curves):
    table = compensate(sharp, "deg/s", knots=10).table
    text = c_header(table, "Gyro X", WHO)
    assert "#ifndef GYRO_X_H" in text
    assert "GIB-7 * / tricky" in text
    assert "/* deg/s in one count */" in text
    assert f"{table.bytes} bytes of tables" in text
    assert identifier("3-axis!") == "drift_3_axis"
    assert identifier("") == "drift"


def test_sixteen_bits_are_used_to_the_last():
    numbers = np.array([[0.0, -2.0], [1.0, 1.5]])
    table = DriftTable(
        "deg/s",
        np.array([2.0, 60.0]),
        np.array([0.0, 10.0]),
        numbers,
        numbers,
        np.zeros(2),
        Alignment(1.5, 2.0, 0.0),
    )
    integers = quantised(table)
    assert integers.values.min() == -32767
    assert integers.time_unit_ms == 1
    assert quantised(replace(table, times_s=np.array([2.0, 120.0]))).time_unit_ms == 2
    assert np.all(quantised(replace(table, values=0.0 * numbers)).values == 0)
    with pytest.raises(FitError, match="same count"):
        quantised(replace(table, temperatures_c=np.array([10.0, 10.001])))
    with pytest.raises(FitError, match="does not fit 16 bits"):
        quantised(replace(table, times_s=np.array([2.0, 1e6])))
    with pytest.raises(FitError, match="327 degC"):
        quantised(replace(table, temperatures_c=np.array([10.0, 400.0])))


def test_the_document_becomes_json(sharp: Curves):
    result = compensate(sharp, "deg/s", knots=6)
    read = json.loads(to_json(document(result, WHO)))
    assert read["format"] == "calrig-drift"
    assert read["values"] == result.table.values.tolist()
    assert read["integers"]["values"] == quantised(result.table).values.tolist()
    assert read["provenance"]["software"] == "CalRig"
    assert {entry["method"] for entry in read["methods"]} >= {"none", "quartic", "table"}
