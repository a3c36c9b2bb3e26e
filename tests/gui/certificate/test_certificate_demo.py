"""The demonstration of the tab: from the simulated rig to the printed pages."""

from pathlib import Path

import pytest

from core.certificates.register import Register
from gui.demonstration.playing import demonstrate


@pytest.mark.timeout(240)
def test_a_triad_is_measured_and_certified(tmp_path: Path) -> None:
    outcome = demonstrate(tmp_path, ("certificate",), 1)
    names = {path.name for path in outcome.files}
    assert {"certificates-draft-dark.png", "certificates-issued-light.png"} <= names
    assert {"certificate-page-1.png", "certificate-page-2.png"} <= names
    register = Register(tmp_path / "CalRig" / "certificates")
    (entry,) = register.entries()
    assert entry.verdict == "pass"
    certificate = register.read(entry.path)
    assert certificate.missing() == ()
    assert certificate.doubts() == ()
    calibration = certificate.measured.calibration
    assert calibration is not None
    assert calibration.is_triad
