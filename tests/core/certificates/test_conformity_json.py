"""A statement of conformity comes back as it was."""

import pytest

from core.certificates.conformity_json import conformity_of_json, conformity_to_json
from core.certificates.limits import Conformity, Judged
from core.errors import FormatError
from core.procedures.conformity import Verdict
from core.records.json_fields import dump, load_object


@pytest.mark.parametrize("verdict", list(Verdict))
def test_it_comes_back(verdict: Verdict):
    judged = (Judged("acc_x", "k_x", "code", -0.5, float("inf"), 2.0, verdict),)
    stated = Conformity("the rule", judged, verdict)
    text = dump({"conformity": conformity_to_json(stated)})
    assert conformity_of_json(load_object(text, "t")) == stated


def test_none_was_stated():
    assert conformity_of_json(load_object('{"conformity": null}', "t")) is None
    with pytest.raises(FormatError, match="conformity is missing"):
        conformity_of_json(load_object("{}", "t"))
