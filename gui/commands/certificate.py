"""A calibration certificate as PDF, HTML and JSON from a file of results.

    calrig certificate SESSION --laboratory lab.json --order order.toml --out CERTIFICATES
    calrig certificate --template laboratory.toml

FILE is a session's folder, a run file, a file of the old programs, a calibration (JSON), or a
record at rest, whose noise (N, B, K, Q) is then certified. The laboratory's file is the one that
the window keeps, laboratory.json, or a laboratory.toml that was filled in: --template writes one
with comments. order.toml holds customer, item, surroundings and limits:

    [order]
    customer = "Plant No. 5, Kharkiv"
    contact = "O. Ivanenko"
    item = "inclinometer"
    serial = "PW09-17"
    condition = "without visible damage"

    [surroundings]
    temperature_c = 22.5

    [conformity]
    rule = "guarded"
    [[conformity.limit]]
    parameter = "bias"
    limit = 600.0

The number is given once: the folder is the register of the laboratory. Exit code 1: issued, but
ISO/IEC 17025 asks for something that is not stated (or a limit is not kept).
"""

import argparse
import os
import sys
from dataclasses import replace
from datetime import date
from pathlib import Path

from core.samples.run import Conditions
from gui.commands.answer import Answer
from gui.commands.conditions import add_conditions, stated_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the files, and what the laboratory states."""
    parser.add_argument("file", type=Path, nargs="?", metavar="FILE")
    parser.add_argument(
        "--laboratory", type=Path, metavar="FILE", help="the laboratory's file, JSON or TOML"
    )
    parser.add_argument(
        "--template", type=Path, metavar="TOML", help="write a laboratory's file to be filled in"
    )
    parser.add_argument("--order", type=Path, metavar="TOML", help="customer, item, limits")
    parser.add_argument("--out", type=Path, default=Path("certificates"), metavar="FOLDER")
    parser.add_argument("--device", help="which one, where a file holds several")
    parser.add_argument("--channel", default="", help="of a record: whose noise is certified")
    parser.add_argument(
        "--scale-factor",
        type=float,
        default=0.0,
        metavar="K",
        help="of a record: output for 1 deg/s (1 m/s^2)",
    )
    parser.add_argument("--language", default="en", choices=["en", "uk", "ru"], help="of the words")
    parser.add_argument(
        "--draft", action="store_true", help="write PDF and HTML only; no number is given"
    )
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Process the file, state what is stated, give the number, write everything."""
    from core.certificates.laboratory_file import open_laboratory, write_template
    from core.errors import FormatError, StorageError

    if args.template is not None:
        write_template(args.template)
        return Answer({"template": args.template}, f"{args.template}: to be filled in")
    wanted = {"FILE": args.file, "--laboratory": args.laboratory}
    left_out = [name for name, value in wanted.items() if value is None]
    if left_out:
        raise FormatError("certificate", f"give {' and '.join(left_out)}, or --template")
    if sys.platform.startswith("linux"):
        os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

    from core.certificates.certificate import Certificate
    from core.certificates.limits import judge_stated
    from core.certificates.order_file import OrderFile, read_order
    from core.certificates.register import Register
    from core.procedures.conformity import Verdict
    from core.records.noise_study import StudyRequest
    from gui.certificate.draft import day_of_moment
    from gui.certificate.html import results_html
    from gui.certificate.issuing import issue, write_files
    from gui.certificate.pdf import application_for_paper
    from gui.languages.choice import Languages
    from gui.measured_file import measured_of_file

    application = application_for_paper()
    languages = Languages(args.language)
    laboratory = open_laboratory(args.laboratory)
    stated = OrderFile() if args.order is None else read_order(args.order)
    request = StudyRequest(channel=args.channel, scale_factor=args.scale_factor)
    measured = measured_of_file(args.file, Conditions(**stated_of(args)), args.device, request)
    origin = measured.provenance
    order = replace(
        stated.order,
        serial=stated.order.serial or origin.device,
        calibrated=stated.order.calibrated or day_of_moment(origin.measured_utc),
        issued=stated.order.issued or date.today().isoformat(),
    )
    conformity = measured.conformity
    if measured.stated:
        conformity = judge_stated(measured.stated, stated.limits, stated.rule)
    draft = Certificate("", laboratory, order, measured, stated.surroundings, conformity)
    results, folder = results_html(measured.printed), args.laboratory.parent
    args.out.mkdir(parents=True, exist_ok=True)
    if args.draft:
        draft = replace(draft, number="DRAFT")
        files = write_files(draft, results, folder, args.out / "draft.json")
        lines = ["draft, without a number"]
    else:
        done = issue(Register(args.out), draft, results, folder)
        if done.problem:
            raise StorageError(f"No. {done.certificate.number} is issued, but {done.problem}")
        draft, files = done.certificate, (done.path, *done.files)
        lines = [f"No. {draft.number}"]
    del application, languages
    missing, doubts = draft.missing(), draft.doubts()
    lines += [str(path) for path in files]
    lines += [f"missing: {words}" for words in missing]
    lines += [f"{note.severity.value}: {note.text}" for note in doubts]
    if conformity is not None:
        lines.append(f"conformity: {conformity.verdict.value}")
    data = {
        "number": draft.number,
        "files": files,
        "missing": missing,
        "doubts": doubts,
        "verdict": None if conformity is None else conformity.verdict.value,
    }
    failed = conformity is not None and conformity.verdict is not Verdict.PASS
    return Answer(data, "\n".join(lines), code=1 if missing or failed else 0)
