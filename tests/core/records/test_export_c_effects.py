"""The C of the added effects, compiled, against the program's own compensation."""

import shutil
from dataclasses import replace

import numpy as np

from core.model.catalogue.listing import CATALOGUE
from core.model.catalogue.nonlinear import CrossAxisSquare, CrossCoupling
from core.procedures.added import Added
from core.procedures.compensation import compensated
from core.procedures.dividing_head import calibrate
from core.records.export_c import header_text
from core.records.export_c_effects import effects_text
from tests.core.procedures.bent_triad import STATED, bent_run, outputs
from tests.core.procedures.test_added import FOUND
from tests.core.records.test_export_c import compiled

A = np.array([[1.0, -2.0, 9.0], [-9.0, 3.0, 1.0], [5.0, 6.0, -5.0]])
USE = """
#include <stdio.h>
#include "cal.h"
int main(void) {{
    const double u[3][3] = {{{rows}}};
    double a[3];
    for (int i = 0; i < 3; i++) {{
        pw09_acc_compensate(u[i]{celsius}, a);
        printf("%.17g %.17g %.17g\\n", a[0], a[1], a[2]);
    }}
    return 0;
}}
"""


def use(u, celsius=""):
    rows = ", ".join("{" + ", ".join(repr(float(v)) for v in row) + "}" for row in u)
    return USE.format(rows=rows, celsius=celsius)


def test_a_header_without_effects_has_no_word_of_them(triad):
    assert "compensate" not in header_text(triad)


def test_what_belongs_to_the_test_is_said_and_not_taken_out():
    added = Added((*FOUND.effects, ("acc_z", CATALOGUE["head_eccentricity"])))
    bent = calibrate(bent_run(), STATED, added=added)
    text = header_text(bent)
    assert "Head eccentricity" in text
    assert "of this test alone" in text
    assert not any("head_sine" in line for line in effects_text(bent, "p", ("a", "b", "c")))


if shutil.which("cc") or shutil.which("gcc") or shutil.which("clang"):

    def test_a_firmware_gets_the_same_input(tmp_path):
        bent = calibrate(bent_run(noise=1e-6), STATED, added=FOUND)
        u = outputs(A)
        found = np.reshape(compiled(header_text(bent), use(u), tmp_path), (3, 3))
        np.testing.assert_allclose(found, compensated(bent, u), rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(found, A, atol=1e-5)

    def test_every_term_of_the_catalogue(tmp_path):
        rng = np.random.default_rng(4)
        run = replace(bent_run(noise=5.0), temperature_c=20.0 + 14.0 * rng.random(48))
        names = (
            *("second_order_nonlinearity", "third_order_nonlinearity"),
            *("odd_quadratic_nonlinearity", "scale_factor_asymmetry", "bias_asymmetry"),
            *("bias_temperature", "scale_factor_temperature"),
        )
        added = Added(
            (
                *(("acc_x", CATALOGUE[name]) for name in names),
                ("acc_y", CrossAxisSquare("z")),
                ("acc_y", CATALOGUE["cross_coupling"]),
                ("acc_z", CrossCoupling("xz")),
            )
        )
        bent = calibrate(run, STATED, added=added)
        u = outputs(A)
        found = np.reshape(compiled(header_text(bent), use(u, ", 31.0"), tmp_path), (3, 3))
        wanted = compensated(bent, u, np.full(3, 31.0))
        np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-9)
        assert np.abs(wanted - bent.triad().calibrated(u)).max() > 1e-3
