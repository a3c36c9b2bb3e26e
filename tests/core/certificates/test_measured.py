"""Results of any kind go into the twin and come back."""

from dataclasses import replace

import numpy as np
import pytest

from core.certificates.limits import Conformity, Judged
from core.certificates.measured import measured_of, measured_of_json, measured_to_json
from core.fit.quantiles import student_t
from core.procedures.calibration import Calibration
from core.procedures.conformity import Verdict
from core.records.json_fields import dump, load_object


def test_the_coverage_factors_are_those_of_the_fits(calibration: Calibration):
    dofs = [float(dof) for fit in calibration.fits for dof in fit.t_dof]
    factors = [student_t(0.95, dof) for dof in dofs]
    assert measured_of(calibration, ()).coverage == (min(factors), max(factors))
    bare = tuple(replace(fit, t_dof=np.zeros(len(fit.t_dof))) for fit in calibration.fits)
    assert measured_of(replace(calibration, fits=bare), ()).coverage == ()


@pytest.mark.parametrize("checked", [True, False])
def test_a_check_has_no_parameters_and_comes_back_as_well(calibration: Calibration, checked: bool):
    measured = measured_of(calibration, ({"kind": "table", "rows": [["1", "2"]]},))
    if checked:
        judged = (Judged("Inter", "γ", "deg", 0.01, 0.002, 0.1, Verdict.PASS),)
        verdict = Conformity("rule", judged, Verdict.PASS)
        measured = replace(measured, calibration=None, conformity=verdict)
    text = dump(measured_to_json(measured))
    back = measured_of_json(load_object(text, "twin.json"))
    assert dump(measured_to_json(back)) == text
    assert back.conformity == measured.conformity
    assert (back.calibration is None) is checked
    assert back.provenance == measured.provenance
