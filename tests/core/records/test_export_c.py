import shutil
import subprocess
from dataclasses import replace

import numpy as np
import pytest

from core.records.export_c import c_name, header_text

COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")

USE = """
#include <stdio.h>
#include "cal.h"
int main(void) {{
    const double u[3] = {{-1090.8, -77.56, 12845.4}};
    double a[3];
    pw09_acc_apply(u, a);
    printf("%.17g %.17g %.17g %.17g\\n", a[0], a[1], a[2], {name});
    return 0;
}}
"""


def numbers_after(text, name):
    body = text.split(name, 1)[1].split(";", 1)[0].split("*/", 1)[1]
    return [
        float(word) for word in body.replace("{", " ").replace("}", " ").split(",") if word.strip()
    ]


def test_the_numbers_are_whole(triad):
    text = header_text(triad)
    np.testing.assert_array_equal(
        np.reshape(numbers_after(text, "pw09_acc_q[3][3]"), (3, 3)), triad.triad().q
    )
    np.testing.assert_array_equal(numbers_after(text, "pw09_acc_u0[3]"), triad.triad().bias)
    for channel, fit in zip(triad.channels, triad.fits, strict=True):
        for parameter, value in zip(fit.parameters, fit.values, strict=True):
            line = text.split(f"pw09_acc_{channel}_{parameter.name} = ", 1)[1]
            assert float(line.split(";", 1)[0]) == value


def test_the_comment_tells_where_it_comes_from(triad):
    text = header_text(triad)
    for part in ("Q (U - U0)", "9.8106 m/s^2", "practicum (1.8), (2.4)", "CalRig"):
        assert part in text


def test_names_of_c():
    assert c_name("PW09") == "pw09"
    assert c_name("31 Gyro/№5") == "unit_31_gyro_no5"
    assert c_name("") == "unit"
    assert c_name("Збірка") == "unit"


def test_names_that_are_alike_stay_apart(triad):
    lines = header_text(replace(triad, channels=("a_3", "a", "a"))).splitlines()
    names = [line.split(" = ")[0] for line in lines if " = " in line and "const" in line]
    assert len(set(names)) == len(names)


def compiled(header, source, folder):
    assert COMPILER is not None
    (folder / "cal.h").write_text(header, encoding="utf-8")
    (folder / "use.c").write_text(source, encoding="utf-8")
    flags = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
    subprocess.run(
        [COMPILER, *flags, "use.c", "-o", "use"], cwd=folder, check=True, capture_output=True
    )
    done = subprocess.run([folder / "use"], check=True, capture_output=True, text=True)
    return [float(word) for word in done.stdout.split()]


if COMPILER is not None:  # a machine without a C compiler cannot tell

    def test_a_firmware_gets_the_same_acceleration(triad, tmp_path):
        source = USE.format(name="pw09_acc_acc_x_bias")
        *a, bias = compiled(header_text(triad), source, tmp_path)
        wanted = triad.triad().calibrated(np.array([[-1090.8, -77.56, 12845.4]]))[0]
        # The order of the sums may differ: rounding of terms of 10 m/s^2.
        np.testing.assert_allclose(a, wanted, rtol=0.0, atol=1e-14)
        assert bias == triad.fits[0].value("bias")

    @pytest.mark.parametrize("device", ["*/ int x; /*", "a\nb", "3 \\", "??/", "Збірка №5", ""])
    def test_no_name_breaks_the_header(single, device, tmp_path):
        odd = replace(
            single,
            provenance=replace(single.provenance, device=device),
            channels=(device,),
        )
        source = '#include "cal.h"\n#include <stdio.h>\nint main(void) { puts("1"); return 0; }\n'
        assert compiled(header_text(odd), source, tmp_path) == [1.0]
