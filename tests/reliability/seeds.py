"""Good files of every kind, small enough to be read thousands of times a minute."""

import functools
import json
import tempfile
from collections.abc import Mapping
from importlib import resources
from pathlib import Path

import numpy as np

from core.archive.store import Archive
from core.arrays import frozen, frozen_int
from core.certificates.certificate import Certificate, Order, Surroundings, certificate_text
from core.certificates.laboratory import Laboratory, Standard, write_laboratory
from core.certificates.limits import ParameterLimit, judge_stated, stated_of
from core.certificates.measured import measured_of
from core.plans.plan import load_plans
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import calibration_text
from core.records.cvgcom import CvgcomHead
from core.records.cvgcom_writer import CvgcomWriter
from core.records.legacy.reader import read_legacy
from core.records.run_file import run_text
from core.records.session.record import JOURNAL_NAME, START_NAME
from core.records.session.start import SessionStart
from core.records.session.store import Session
from core.samples.accumulate import Accumulation, accumulation_of
from core.samples.block import Channel, SampleBlock
from core.samples.run import Conditions
from drivers.decoders import make_decoder
from drivers.encode import encode
from drivers.profile import load_profiles
from drivers.rawlog import RawLog
from drivers.recorder import SINGLE, Recorder, RecordLayout
from tests.drivers.test_decoders import stream as stream_of

SPECIMENS = Path(__file__).parents[1] / "data" / "legacy"
STATED = Conditions(g_mps2=9.8106, u_g_mps2=1e-4, head_u_arcsec=5.0)
CHANNELS = (
    Channel("N", "", "counter"),
    Channel("AX", "code", "acc.x"),
    Channel("AY", "code", "acc.y"),
    Channel("AZ", "code", "acc.z"),
    Channel("T", "degC", "temp"),
)
_NOISE = (
    "device,channel,term,symbol,method,convention,unit,value,u,lower95,upper95,upper_limit,"
    "regressed,file\n"
    "G1,y,random_walk,N,likelihood,N,deg/sqrt(s),0.0125,0.001,0.011,0.014,0,,a.txt\n"
    "G1,y,bias_instability,B,likelihood,B,deg/s,7e-4,1e-4,5e-4,9e-4,0,,a.txt\n"
    "G1,y,rate_random_walk,K,graphical,K,deg/s*sqrt(Hz),4e-4,1e-4,2e-4,6e-4,1,T,a.txt\n"
)
_LIMITS = (
    '[[limit]]\nparameter = "bias"\nunit = "code"\nhigh = 5\nchannel = "acc_x"\n\n'
    '[[limit]]\nparameter = "bias"\nunit = "code"\nlow = -9.5\nhigh = 9.5\n'
)


_once = functools.cache


@_once
def legacy() -> Mapping[str, bytes]:
    """A file of each layout, its first rows."""
    return {
        path.name: b"".join(path.read_bytes().splitlines(keepends=True)[:8])
        for path in sorted(SPECIMENS.glob("*.txt"))
    }


@_once
def _calibration() -> Calibration:
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    return calibrate(run, STATED)


@_once
def calibration() -> bytes:
    """Table 2.2 of the practicum."""
    return calibration_text(_calibration()).encode()


@_once
def run_file() -> bytes:
    """The same positions as a run file."""
    return run_text(
        read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    ).encode()


def start() -> SessionStart:
    """What is known before the first position."""
    return start_of(CHANNELS, 100.0, "pointer")


def start_of(channels: tuple[Channel, ...], rate: float, legacy: str = "") -> SessionStart:
    """The same for another device."""
    profile = load_profiles()["cvgx48"]
    return SessionStart(
        device="PW09",
        sensor="accelerometer",
        channels=channels,
        rate=rate,
        plan=load_plans()["pointer_8"],
        started="2024-05-14T09:30:05+03:00",
        profile=profile.id,
        profile_text=profile.text,
        operator="Олена",
        legacy=legacy,
    )


@_once
def mean() -> Accumulation:
    """A second in a position."""
    data = np.random.default_rng(5).normal(0.0, 0.5, (100, len(CHANNELS)))
    data += [0.0, 100.0, -10.0, 12866.0, 26.0]
    return accumulation_of(CHANNELS, np.arange(100) / 100.0, data)


@_once
def session() -> Mapping[str, bytes]:
    """Three accepted positions, one of them measured again, one rejected."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "s"
        with Session.create(folder, start()) as made:
            steps = made.record.start.plan.steps
            last = [made.accept(step, mean(), temperature_c=26.0) for step in steps[:3]][-1]
            made.accept(steps[2], mean(), temperature_c=26.0, supersedes=(last.id,))
            made.reject(steps[3], mean(), "the head moved", temperature_c=26.0)
        return {path: (folder / path).read_bytes() for path in (START_NAME, JOURNAL_NAME)}


@_once
def archive() -> Mapping[str, bytes]:
    """A folder of files that lie still, with its index."""
    with tempfile.TemporaryDirectory() as name:
        root = Path(name)
        (root / "a.cal.json").write_bytes(calibration())
        with Archive(root) as made:
            made.refresh()
        return {path.name: path.read_bytes() for path in root.iterdir()}


def place() -> bytes:
    """The identity of an archive's folder."""
    return archive()["archive.json"]


@_once
def certificate() -> bytes:
    """A certificate with a statement of conformity."""
    calibration = _calibration()
    limits = (ParameterLimit("bias", "", 0.0, 600.0),)
    return certificate_text(
        Certificate(
            number="2026-0001",
            laboratory=_laboratory(),
            order=Order(customer="Plant", item="inclinometer", serial="17", issued="2026-11-22"),
            measured=measured_of(calibration, ({"kind": "note", "text": "all is well"},)),
            surroundings=Surroundings(22.5, 41.0),
            conformity=judge_stated(stated_of(calibration), limits, "guarded"),
        )
    ).encode()


def _laboratory() -> Laboratory:
    return Laboratory(
        name="Laboratory of inertial sensors",
        address="Kyiv",
        authorised_by="O. Petrenko",
        standards=(Standard("dividing head", "114", "UA-24/118", "2027-03-01", "institute"),),
    )


@_once
def laboratory() -> bytes:
    """A laboratory's file."""
    with tempfile.TemporaryDirectory() as name:
        path = Path(name) / "laboratory.json"
        write_laboratory(_laboratory(), path)
        return path.read_bytes()


@_once
def cvgcom() -> tuple[str, bytes]:
    """A record of CVGCom: its name and its text."""
    name = "25-143.exp(001)_s_pr1.txt"
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        writer = CvgcomWriter(path, CvgcomHead(0.01, 0.024, CHANNELS[1:]))
        writer.feed(np.arange(40), np.random.default_rng(2).normal(size=(40, 4)))
        writer.close()
        return name, path.read_bytes()


@_once
def text_series() -> bytes:
    """A table of samples with a head and units."""
    rng = np.random.default_rng(3)
    rows = [f"{n / 50:.3f};{rng.normal():.6f};{20 + n / 100:.3f}" for n in range(60)]
    head = "# device: G7\n# rate: 50 Hz\ntime (s);rate z (deg/s);temperature (degC)\n"
    return (head + "\n".join(rows) + "\n").encode()


def means() -> bytes:
    """``means.dat`` of two records."""
    rows = ("25-143.exp(001)_s_pr1.txt", "25-143.exp(002)_s_pr1.txt")
    return "".join(f"{row}\t1.250000000\t-0.500000000\t26.100000000\r\n" for row in rows).encode()


def noise() -> bytes:
    """A table of noise coefficients."""
    return _NOISE.encode()


def limits() -> bytes:
    """What a laboratory demands."""
    return _LIMITS.encode()


def settings() -> bytes:
    """Preferences of the window."""
    return json.dumps({"window": {"dark": True, "width": 1280}, "live": {"span_s": 60}}).encode()


@_once
def recording() -> bytes:
    """Bytes and samples of the CVG with a gap, a mark and an interruption."""
    profile = load_profiles()["cvgx48"]
    channels = make_decoder(profile).channels
    values = np.random.default_rng(4).normal(size=(60, len(channels)))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.calrec"
        header = {"device": "25-143", "profile": profile.id, "profile_text": profile.text}
        settings = {"settings": {"scale_factor": 0.024}}
        layout = RecordLayout(channels, profile.nominal_hz, SINGLE)
        writer = Recorder(path, {**header, **settings}, layout)
        for first, number in ((0, 0), (20, 20), (40, 70)):
            index = np.arange(20)
            data = values[first : first + 20]
            writer.take(encode(profile, index + first, data), 0.1 * first)
            writer.say(SampleBlock(channels, frozen_int(index + number), frozen(data), 200.0))
            writer.flush()
            writer.mark(number, "hit")
        writer.hold()
        writer.go_on()
        writer.close()
        return path.read_bytes()


@_once
def raw_log() -> bytes:
    """The bytes of the CVG alone, interrupted once."""
    profile = load_profiles()["cvgx48"]
    columns = len(make_decoder(profile).channels)
    values = np.random.default_rng(6).normal(size=(60, columns))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.calrec"
        log = RawLog(path, {"profile": profile.id, "profile_text": profile.text})
        for first in (0, 20, 40):
            data = values[first : first + 20]
            log.write(encode(profile, np.arange(first, first + 20), data), log._zero + first / 200)
            log.mark("link lost", why="pulled")
        log.close()
        return path.read_bytes()


@_once
def profiles() -> Mapping[str, bytes]:
    """A device file of each kind: frames, lines, a protocol, commands."""
    names = ("cvgx48", "adxl345_text", "stim300", "kvh1750", "inertiallabs_ahrs")
    folder = resources.files("resources") / "devices"
    return {f"{name}.toml": (folder / f"{name}.toml").read_bytes() for name in names}


@_once
def plans() -> Mapping[str, bytes]:
    """A plan for the head, one for the table, one over temperature."""
    folder = resources.files("resources") / "plans"
    names = ("clbacc_24", "rate_table_up_down", "thermal_8")
    return {f"{name}.toml": (folder / f"{name}.toml").read_bytes() for name in names}


@_once
def frames(profile: str) -> bytes:
    """Sixty frames of a device."""
    return stream_of(profile, np.random.default_rng(7))
