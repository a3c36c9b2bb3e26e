"""``session.json``: everything that is known before the first position."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field, fields

from core.errors import FormatError
from core.plans.orientation import LEVEL, BaseOrientation
from core.plans.plan import Plan
from core.records.json_fields import (
    Fields,
    Json,
    dump,
    load_document,
    number_to_json,
    numbers_to_json,
)
from core.records.legacy.layout import LEGACY_FORMATS
from core.records.session.events import step_from_json, step_to_json
from core.samples.block import Channel
from core.samples.run import Conditions
from core.version import SOFTWARE

SCHEMA, VERSION = "calrig-session", 1

Scalars = Mapping[str, str | float | bool]


def _no_scalars() -> Scalars:
    return {}


@dataclass(frozen=True, slots=True, eq=False)
class SessionStart:
    """The start document of a session.

    Parameters
    ----------
    device : name or serial number that the device tells
    sensor : ``"accelerometer"`` or ``"gyro"``: what the test calibrates
    channels : (c,) what the device sends
    rate : its samples per second
    plan : the steps
    profile, profile_text : identifier and full text of the device's profile
    operator : who measures
    conditions : what the laboratory states
    base : how the head's base plate stands
    tilter, settings : further choices of the operator, kept as they are
    legacy : key of `LEGACY_FORMATS` for the text file beside the journal; empty for none
    started : ISO 8601 local time with its offset from UTC
    software : program and version
    """

    device: str
    sensor: str
    channels: tuple[Channel, ...]
    rate: float
    plan: Plan
    started: str
    profile: str = ""
    profile_text: str = ""
    operator: str = ""
    conditions: Conditions = field(default_factory=Conditions)
    base: BaseOrientation = LEVEL
    tilter: Scalars = field(default_factory=_no_scalars)
    settings: Scalars = field(default_factory=_no_scalars)
    legacy: str = ""
    software: str = SOFTWARE

    @property
    def profile_sha256(self) -> str:
        """Hash of the profile's text; empty if there is none."""
        return hashlib.sha256(self.profile_text.encode()).hexdigest() if self.profile_text else ""


def start_to_text(start: SessionStart) -> str:
    """The start document as JSON text."""
    plan = start.plan
    document: dict[str, Json] = {
        "schema": SCHEMA,
        "schema_version": VERSION,
        "software": start.software,
        "started": start.started,
        "device": start.device,
        "operator": start.operator,
        "sensor": start.sensor,
        "channels": [
            {"name": channel.name, "unit": channel.unit, "role": channel.role}
            for channel in start.channels
        ],
        "rate": start.rate,
        "legacy": start.legacy,
        "conditions": _numbers_of(start.conditions),
        "base": _numbers_of(start.base),
        "tilter": dict(start.tilter),
        "settings": dict(start.settings),
        "plan": {
            "id": plan.id,
            "title": plan.title,
            "test": plan.test,
            "source": plan.source,
            "accumulation_s": plan.accumulation_s,
            "settle_s": plan.settle_s,
            "temperatures_c": numbers_to_json(plan.temperatures_c),
            "steps": [step_to_json(step) for step in plan.steps],
        },
        "profile": {
            "id": start.profile,
            "sha256": start.profile_sha256,
            "text": start.profile_text,
        },
    }
    return dump(document) + "\n"


def start_from_text(text: str, path: str) -> SessionStart:
    """Read a start document.

    Raises
    ------
    FormatError
        It is damaged, or from a newer program.
    """
    document = load_document(text, path, SCHEMA, VERSION)
    profile = document.object("profile")
    legacy = document.text("legacy")
    if legacy and legacy not in LEGACY_FORMATS:
        raise document.wrong("legacy", f"one of {', '.join(LEGACY_FORMATS)} or empty", legacy)
    channels = tuple(
        Channel(item.text("name"), item.text("unit"), item.text("role"))
        for item in document.objects("channels")
    )
    start = SessionStart(
        device=document.text("device"),
        sensor=document.text("sensor"),
        channels=channels,
        rate=document.number("rate"),
        plan=_plan(document.object("plan")),
        started=document.moment("started"),
        profile=profile.text("id"),
        profile_text=profile.text("text"),
        operator=document.text("operator"),
        conditions=Conditions(**_floats(document.object("conditions"), Conditions)),
        base=BaseOrientation(**_floats(document.object("base"), BaseOrientation)),
        tilter=document.scalars("tilter"),
        settings=document.scalars("settings"),
        legacy=legacy,
        software=document.text("software"),
    )
    if start.profile_sha256 != profile.text("sha256"):
        raise FormatError(path, "profile.text does not have the stored hash: it was changed")
    return start


def _numbers_of(values: Conditions | BaseOrientation) -> dict[str, Json]:
    return {item.name: number_to_json(getattr(values, item.name)) for item in fields(values)}


def _floats(found: Fields, kind: type[Conditions] | type[BaseOrientation]) -> dict[str, float]:
    """The numbers of a dataclass of numbers; one that is not there keeps its default."""
    return {item.name: found.number(item.name) for item in fields(kind) if item.name in found.data}


def _plan(found: Fields) -> Plan:
    return Plan(
        id=found.text("id"),
        title=found.text("title"),
        test=found.text("test"),
        source=found.text("source"),
        accumulation_s=found.number("accumulation_s"),
        settle_s=found.number("settle_s"),
        temperatures_c=tuple(found.numbers("temperatures_c").tolist()),
        steps=tuple(step_from_json(step) for step in found.objects("steps")),
    )
