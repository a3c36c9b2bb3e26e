"""The faults, each with how often it happens in the tests and in the long run."""

from tests.reliability import clocks, disks, killed, links
from tests.reliability.fault import Fault, Run


def _kill(few: int, many: int, while_: str, victim: str, check: killed.Check) -> Fault:
    return Fault(f"kill -9 while {while_}", killed.kills(victim, check), few, many)


def _two(programs: str, victim: str, check: killed.Check) -> Fault:
    return Fault(f"two programs {programs}", killed.together(victim, check), 1, 10)


def _disk(title: str, run: Run, many: int) -> Fault:
    return Fault(title, run, 0, many)  # the tests try all kinds of work in one process


FAULTS: dict[str, Fault] = {
    "recording": Fault("cable pulled in mid-record", links.pulled_while_recording, 2, 40),
    "accumulating": Fault(
        "cable pulled in mid-accumulation", links.pulled_while_accumulating, 2, 40
    ),
    "baud": Fault("wrong baud rate, then the right one", links.wrong_baud, 1, 12),
    "garbage": Fault(
        "garbage, half and lost frames, cable pulled, 3 min each", links.garbage, 1, 20
    ),
    "suspended": Fault("program suspended and woken", links.suspended, 2, 40),
    "clock": Fault("clock set between positions", clocks.set_while_measuring, 6, 100),
    "times": Fault("files from the past and the future", clocks.set_while_archiving, 1, 20),
    "kill session": _kill(8, 100, "positions are accepted", "measure", killed.session_kept),
    "kill record": _kill(8, 100, "a record grows", "record", killed.record_kept),
    "kill certificate": _kill(
        4, 40, "certificates are issued", "certify", killed.certificates_kept
    ),
    "kill file": _kill(8, 100, "a calibration is saved", "overwrite", killed.overwritten_whole),
    "kill index": _kill(1, 30, "the archive is indexed", "index", killed.index_kept),
    "cut session": Fault("power cut: the journal ends anywhere", killed.cut_journal, 20, 200),
    "cut record": Fault("power cut: the record ends anywhere", killed.cut_record, 20, 200),
    "two session": _two("measure into one session", "measure", killed.session_kept),
    "two record": _two("record into one file", "record", killed.record_kept),
    "two certificate": _two("issue certificates", "certify", killed.certificates_kept),
    "two file": _two("save one calibration", "overwrite", killed.whole_at_all),
    "two index": _two("index one folder", "index", killed.index_kept),
    **{
        f"full {kind}": _disk(f"disk full while {words}", disks.full(kind), 4)
        for kind, words in disks.WORDS.items()
    },
    **{
        f"read-only {kind}": _disk(f"folder read-only while {words}", disks.read_only(kind), 2)
        for kind, words in disks.WORDS.items()
    },
}
