"""The noise of a CVG's record on a certificate: numbers, names, pages, twin, command."""

import json
import math
from pathlib import Path

import pytest

from core.certificates.certificate import Certificate, Order
from core.certificates.laboratory import Laboratory, write_laboratory
from core.certificates.limits import ParameterLimit, judge_stated
from core.certificates.measured import Measured, measured_of_json, measured_to_json
from core.errors import FitError
from core.procedures.conformity import Verdict
from core.records.json_fields import Fields
from core.samples.run import Conditions
from gui.certificate.html import certificate_sections, results_html, whole_html
from gui.commands.table import run_command
from gui.measured_file import measured_of_file
from gui.measuring.page import LogCurveState
from gui.measuring.printed import parts_of
from tests.gui.allan.conftest import TRUTH

pytestmark = pytest.mark.usefixtures("qapp")
SYMBOLS = {"random_walk": "N", "bias_instability": "B", "rate_random_walk": "K"}


@pytest.fixture(scope="module")
def measured(records: list[Path]) -> Measured:
    return measured_of_file(records[0], Conditions())


def test_the_coefficients_hold_the_truth_within_their_uncertainty(measured: Measured) -> None:
    found = {one.parameter: one for one in measured.stated}
    assert set(SYMBOLS) <= set(found)
    for name, symbol in SYMBOLS.items():
        one = found[name]
        assert (one.symbol, one.channel) == (symbol, "GyroOut")
        # Two of three 95 % intervals would be no surprise to miss; four halves would be.
        assert abs(one.value - TRUTH[symbol]) < 2.0 * one.expanded
    assert found["random_walk"].expanded < 0.02 * TRUTH["N"]
    assert measured.subject == "noise"
    assert measured.temperature_c == pytest.approx(26.9, abs=1.0)
    assert measured.provenance.device == "25-143"
    assert len(measured.provenance.records[0][1]) == 64


def test_the_pages_name_the_terms_as_the_standards_do(measured: Measured, tmp_path: Path) -> None:
    conformity = judge_stated(
        measured.stated, (ParameterLimit("random_walk", "", 0.0, 0.01),), "guarded"
    )
    assert conformity is not None
    assert conformity.verdict is Verdict.FAIL
    draft = Certificate("1", Laboratory("L"), Order(), measured, conformity=conformity)
    sections = certificate_sections(draft, results_html(measured.printed), tmp_path)
    page = whole_html(sections, "draft")
    for words in ("angle random walk", "bias instability", "rate random walk",
                  "IEEE 952, IEEE 1431", "Allan deviation with its 95 % limits",
                  "from the profile of the likelihood", "FAIL", "data:image/png"):  # fmt: skip
        assert words in page
    assert "σ<sup>" not in page
    assert "coverage factor" not in page


def test_the_plot_has_the_limits_and_the_fitted_terms(measured: Measured) -> None:
    (plot,) = [one for one in parts_of(measured.printed) if isinstance(one, LogCurveState)]
    assert all(low < y < high for low, y, high in zip(plot.low, plot.y, plot.high, strict=True))
    assert [name for name, _, _ in plot.lines][:2] == ["fitted model", "N"]
    # On the left N alone is left: sigma = N / sqrt(tau).
    assert plot.y[0] == pytest.approx(TRUTH["N"] / math.sqrt(plot.x[0]), rel=0.05)


def test_the_twin_gives_the_same_results_back(measured: Measured) -> None:
    text = json.dumps(measured_to_json(measured))
    again = measured_of_json(Fields("twin", "", json.loads(text)))
    assert again.stated == measured.stated
    assert again.printed == measured.printed
    old = json.loads(text)
    del old["coefficients"]
    assert measured_of_json(Fields("twin", "", old)).stated == ()


def test_a_record_of_something_else_is_refused_with_the_reason(tmp_path: Path) -> None:
    path = tmp_path / "stuck.csv"
    path.write_text("t,rate\n" + "".join(f"{0.01 * n:.2f},5\n" for n in range(3000)), "utf-8")
    from core.records.noise_study import StudyRequest
    from gui.allan.certified import measured_of_record

    with pytest.raises(FitError):
        measured_of_record(path, Conditions(), StudyRequest(rate=100.0))


def test_the_command_writes_the_certificate_of_a_record(
    records: list[Path], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_laboratory(Laboratory("Laboratory"), tmp_path / "lab.json")
    order = tmp_path / "order.toml"
    order.write_text(
        '[order]\ncustomer = "Plant"\n'
        '[[conformity.limit]]\nparameter = "random_walk"\nlimit = 0.05\n',
        "utf-8",
    )
    out = tmp_path / "out"
    arguments = ["--laboratory", str(tmp_path / "lab.json"), "--order", str(order)]
    command = [str(records[0]), *arguments, "--out", str(out), "--channel", "GyroOut"]
    assert run_command("certificate", command) == 1
    told = capsys.readouterr().out
    assert "conformity: pass" in told
    assert "missing: item" in told
    (twin,) = out.glob("*.json")
    document = json.loads(twin.read_text("utf-8"))
    assert {one["symbol"] for one in document["measured"]["coefficients"]} >= {"N", "B", "K"}
    assert len(list(out.glob("*.pdf"))) == 1
