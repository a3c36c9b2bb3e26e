"""A whole session on the simulated rig without a window.

An operator walks the plan hands-free and every position goes the way of a real one: frames,
decoder, accumulation, recognition, journal.
"""

import time
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from core.errors import LinkError
from core.plans.orientation import LEVEL, BaseOrientation
from core.plans.plan import Plan
from core.procedures.measuring import Measuring, Outcome
from core.procedures.walk import walk_of
from core.records.legacy.layout import legacy_for
from core.records.session.start import SessionStart
from core.records.session.store import Session
from core.samples.block import SampleBlock
from core.samples.run import Conditions, Run
from drivers.decoders import make_decoder
from drivers.events import Ended
from drivers.rawlog import RawLog
from drivers.reader import Reader
from drivers.transport import opener
from drivers.virtual.address import rig_of
from drivers.virtual.operator import Operator

RAW_NAME = "raw.calrec"
_PAUSE_S = 0.001
_UNDERWAY_S = 2.0
"""More than what is read and not yet decoded."""
_PATIENCE_S = 300.0
"""Seconds of the rig in which a step must succeed."""
_TOLD_BY_NOTHING = "static_positions"
"""Gyros at rest do not tell one position from another; the operator starts each by hand."""


@dataclass(frozen=True, slots=True)
class Order:
    """What to measure on the rig.

    Parameters
    ----------
    url : the rig, e.g. ``sim://pointer?speed=max&seed=3``
    plan : the steps; all are measured at every temperature of the plan
    sensor : ``"accelerometer"`` or ``"gyro"``
    conditions : what the laboratory states
    base : how the base plate stands
    setting_arcsec : standard deviation of the angles that the operator really sets
    seed : of the operator
    replicates : how often the whole plan is walked
    """

    url: str
    plan: Plan
    sensor: str
    conditions: Conditions
    base: BaseOrientation = LEVEL
    setting_arcsec: float = 0.0
    seed: int = 0
    replicates: int = 1


def simulate_session(order: Order, folder: Path) -> Run:
    """Walk the plan and leave a finished session in `folder`.

    Raises
    ------
    LinkError
        The rig cannot be opened, or a step does not succeed.
    StorageError
        The folder cannot be written, or holds a session.
    """
    rig = rig_of(order.url)
    rig.tilt_base(order.base)
    decoder = make_decoder(rig.profile)
    start = SessionStart(
        device=rig.identity.get("serial", rig.profile.name),
        sensor=order.sensor,
        channels=rig.channels,
        rate=rig.rate_hz,
        plan=order.plan,
        started=datetime.now().astimezone().isoformat(timespec="seconds"),
        profile=rig.profile.id,
        profile_text=rig.profile.text,
        operator="simulated",
        conditions=order.conditions,
        base=order.base,
        legacy=_legacy_key(rig.profile.layout, order.plan),
    )
    with Session.create(folder, start) as session:
        header = {"port": order.url, "profile": rig.profile.id, "profile_text": rig.profile.text}
        reader = Reader(opener(order.url), decoder, RawLog(folder / RAW_NAME, header))
        reader.start()
        try:
            _walk_all(order, session, reader)
        finally:
            reader.close()
        run = session.run()
        session.finish()
    return run


def simulate_record(url: str, seconds: float, path: Path) -> None:
    """Record what the unit on the rig sends while nothing is done to it.

    Parameters
    ----------
    url : the rig, e.g. ``sim://cvg25?speed=max&seed=3``
    seconds : of the rig
    path : of the recording, ``NAME.calrec``

    Raises
    ------
    LinkError
        The rig cannot be opened, or ends.
    StorageError
        The recording cannot be written.
    """
    rig = rig_of(url)
    header = {"port": url, "profile": rig.profile.id, "profile_text": rig.profile.text}
    reader = Reader(opener(url), make_decoder(rig.profile), RawLog(path, header))
    end = rig.state.time_s + seconds
    reader.start()
    try:
        while rig.state.time_s < end:
            for _ in _blocks(url, reader):
                pass
    finally:
        reader.close()


def _legacy_key(program: str, plan: Plan) -> str:
    layout = legacy_for(program, plan.test, plan) if program else None
    return layout.id if layout is not None else ""


def _walk_all(order: Order, session: Session, reader: Reader) -> None:
    rig = rig_of(order.url)
    operator = Operator(rig, order.plan, seed=order.seed, setting_arcsec=order.setting_arcsec)
    g = order.conditions.g_mps2
    for temperature in order.plan.temperatures_c or (rig.state.chamber_c,):
        rig.be_at(temperature)
        for _ in range(order.replicates):
            walk = walk_of(order.plan, rig.channels, rig.rate_hz, g, order.base)
            for outcome in _outcomes(order, walk, operator, reader):
                session.accept(
                    outcome.step,
                    outcome.accumulation,
                    temperature_c=outcome.accumulation.of_role("temp"),
                    set_temperature_c=temperature,
                )
                walk.accept(outcome)


def _outcomes(
    order: Order, walk: Measuring, operator: Operator, reader: Reader
) -> Iterator[Outcome]:
    """Yield what is taken of each step; the caller accepts each before the next is sought."""
    fresh = True
    while (step := walk.status.step) is not None:
        rest_s = operator.goto(step)
        by_hand = order.plan.test == _TOLD_BY_NOTHING
        if fresh or by_hand:
            # A walk that knows no position yet would take what was sent before the unit came to
            # rest for the position itself.
            _pass_over(order, reader, rest_s + (order.plan.settle_s if by_hand else 0.0))
            fresh = False
        if by_hand:
            walk.start()
        else:
            walk.set_hands_free(True)
        waited = 0.0
        outcome = None
        while outcome is None:
            for block in _blocks(order.url, reader):
                waited += len(block.index) / block.rate
                found = walk.feed(block)
                if found is not None and (found.acceptable or (by_hand and found.whole)):
                    outcome = found
                    break
                if found is not None:
                    walk.reject(found)
            if waited > _PATIENCE_S:
                raise LinkError(order.url, f"{step.group}, step {step.number}: {walk.status.text}")
        yield outcome


def _pass_over(order: Order, reader: Reader, seconds: float) -> None:
    """Let the rig's time go on, and drop what comes meanwhile."""
    rig = rig_of(order.url)
    end = rig.state.time_s + seconds + _UNDERWAY_S
    while rig.state.time_s < end:
        for _ in _blocks(order.url, reader):
            pass


def _blocks(url: str, reader: Reader) -> Iterator[SampleBlock]:
    for event in reader.drain():
        if isinstance(event, SampleBlock):
            yield event
        elif isinstance(event, Ended):
            raise event.error or LinkError(url, "the rig ended")
    time.sleep(_PAUSE_S)
