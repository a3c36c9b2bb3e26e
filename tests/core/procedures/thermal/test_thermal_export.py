"""The C function is compiled and compensates as the program does."""

import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from core.procedures.calibration import Provenance
from core.procedures.thermal.cycle import ThermalCalibration, calibrate_thermal
from core.procedures.thermal.export import (
    c_header,
    csv_text,
    document,
    polynomials,
    record_document,
)
from core.procedures.thermal.record import fit_record
from core.records.json_text import to_json
from core.samples.run import Conditions, Run

CASE = Conditions(g_mps2=9.8106)
_READ = '#include <stdio.h>\n#include "unit.h"\nint main(void) {\n'
TRIAD = (
    _READ
    + """    double u[3], t, a[3];
    while (scanf("%lf %lf %lf %lf", u, u + 1, u + 2, &t) == 4) {
        const int outside = pw09_apply(u, t, a);
        printf("%.17g %.17g %.17g %d\\n", a[0], a[1], a[2], outside);
    }
    return 0;
}
"""
)
SENSORS = (
    _READ
    + """    double u, t, a; int c;
    while (scanf("%d %lf %lf", &c, &u, &t) == 3) {
        const int outside = pw09_apply(c, u, t, &a);
        printf("%.17g %d\\n", a, outside);
    }
    return 0;
}
"""
)


def answers(folder: Path, calibration: ThermalCalibration, program: str, asked: np.ndarray):
    compiler = shutil.which("cc")
    assert compiler is not None, "a C compiler is needed to test the exported header"
    (folder / "unit.h").write_text(c_header(calibration, "PW09"), encoding="utf-8")
    (folder / "main.c").write_text(program, encoding="utf-8")
    strict = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror"]
    subprocess.run(
        [compiler, *strict, "main.c", "-o", "unit"], cwd=folder, check=True, capture_output=True
    )
    text = "\n".join(" ".join(f"{value:.17g}" for value in row) for row in asked)
    done = subprocess.run([folder / "unit"], input=text, capture_output=True, text=True, check=True)
    return np.array([line.split() for line in done.stdout.splitlines()], dtype=float)


def test_the_compiled_triad_gives_the_programs_forces(tmp_path: Path, make_chamber):
    run: Run = make_chamber()
    calibration = calibrate_thermal(run, CASE, cross_order=1)
    asked = np.column_stack([run.y, run.temperature_c])
    found = answers(tmp_path, calibration, TRIAD, asked)
    expected = np.vstack(
        [
            calibration.triad_at(float(run.temperature_c[row])).calibrated(run.y[[row]])
            for row in range(len(run))
        ]
    )
    assert found[:, :3] == pytest.approx(expected, rel=1e-12, abs=1e-12)
    assert not found[:, 3].any()
    outside = answers(tmp_path, calibration, TRIAD, np.array([[*run.y[0], 200.0]]))
    held = calibration.triad_at(calibration.high_c).calibrated(run.y[:1])
    assert outside[0, :3] == pytest.approx(held[0], rel=1e-12)
    assert outside[0, 3] == 1


def test_permuted_channels_answer_in_the_order_of_the_axes(tmp_path: Path, make_chamber):
    run: Run = make_chamber()
    turned = Run(
        **{
            **{name: getattr(run, name) for name in run.__slots__},
            "y": run.y[:, [2, 0, 1]],
            "y_se": run.y_se[:, [2, 0, 1]],
            "channels": ("Z", "X", "Y"),
            "axes": ("z", "x", "y"),
        }
    )
    asked = np.column_stack([run.y, run.temperature_c])
    straight, other = (
        answers(tmp_path, calibrate_thermal(one, CASE), TRIAD, asked) for one in (run, turned)
    )
    assert other == pytest.approx(straight, rel=1e-9)


def test_two_sensors_are_compensated_each_by_itself(tmp_path: Path, make_chamber):
    run: Run = make_chamber()
    two = Run(
        **{
            **{name: getattr(run, name) for name in run.__slots__},
            "y": run.y[:, :2],
            "y_se": run.y_se[:, :2],
            "channels": ("X", "Y"),
            "axes": ("x", "y"),
        }
    )
    calibration = calibrate_thermal(two, CASE)
    found = answers(tmp_path, calibration, SENSORS, np.array([[1.0, 500.0, 40.0]]))
    fit = calibration.fit_at(1, 40.0)
    assert found[0, 0] == pytest.approx((500.0 - fit.value("bias")) / fit.value("scale_factor"))


def test_document_and_table_hold_every_coefficient(make_chamber, rates: Run):
    calibration = calibrate_thermal(make_chamber(), CASE)
    read = json.loads(to_json(document(calibration)))
    bias, k = polynomials(calibration)
    assert read["bias_polynomials"] == bias.tolist()
    fit = calibration.channels[0].fit
    assert bias[0, 1] == fit.value("bias_t1")
    assert k[0, 1, 0] == fit.value("cross_axis_y")
    assert k[0, 0, 1] == fit.value("scale_factor_t1")
    lines = csv_text(calibration).splitlines()
    assert len(lines) == 1 + sum(len(one.fit.names) for one in calibration.channels)
    record = fit_record(rates, order=2)
    assert len(csv_text(record).splitlines()) == 1 + 3 * 3
    other = json.loads(to_json(record_document(record, Provenance("p", "unit 1"))))
    assert [trend["channel"] for trend in other["trends"]] == list(rates.channels)
