"""What a device file says. A device is data: `load_profile` turns a TOML file into a `Profile`.

The schema stands in `docs/device-files.md`; the reading of each section in `profile_sections`.
"""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import resources
from pathlib import Path

from core.errors import FormatError
from drivers.profile_commands import read_commands
from drivers.profile_sections import (
    read_device,
    read_frame,
    read_line,
    read_params,
    read_port,
    read_protocol,
)
from drivers.profile_types import (
    Command,
    DeviceSection,
    FrameSpec,
    LineSpec,
    PortSettings,
    ProtocolSpec,
)
from drivers.protocols.options import PROTOCOL_PARAMS
from drivers.toml_table import Table

SCHEMA = 1


@dataclass(frozen=True, slots=True)
class Profile:
    """A device as its file describes it.

    Parameters
    ----------
    id : stem of the file's name
    device : name, kind, layout, notes
    port : settings of the port
    params : constants of the single unit, usable in scales
    stream : how its bytes are laid out: fixed frames, text lines, or a protocol decoder
    commands : what can be sent to it, by name
    nominal_hz : declared samples per second; 0 where the file does not say
    text : the file as it was read, to be kept with whatever was measured through it
    """

    id: str
    device: DeviceSection
    port: PortSettings
    params: Mapping[str, float]
    stream: FrameSpec | LineSpec | ProtocolSpec
    commands: Mapping[str, Command]
    nominal_hz: float
    text: str

    @property
    def name(self) -> str:
        """The device's name as the operator reads it."""
        return self.device.name

    @property
    def kind(self) -> str:
        """``"gyro"``, ``"accel"``, ``"imu"``, ``"ahrs"`` or ``"adc"``."""
        return self.device.kind

    @property
    def layout(self) -> str:
        """Old program whose session it takes on the dividing head, or empty."""
        return self.device.layout

    def option(self, name: str) -> int:
        """Return one option of [protocol]; only its decoder asks."""
        if not isinstance(self.stream, ProtocolSpec):
            raise TypeError(f"{self.id} has no [protocol] section")
        return self.stream.options[name]


def _read_stream(
    name: str, section: Table, top: Table, params: Mapping[str, float]
) -> FrameSpec | LineSpec | ProtocolSpec:
    """Read the one section that says how the bytes are laid out."""
    if name == "frame":
        return read_frame(section, top.tables("field"), params)
    if name == "line":
        return read_line(section, params)
    stream = read_protocol(section)
    for needed in PROTOCOL_PARAMS.get(stream.name, ()):
        if not params.get(needed):
            top.fail("params", f'{needed}, which "{stream.name}" needs, is missing or zero')
    return stream


def parse_profile(
    text: str, path: Path | str, params: Mapping[str, float] | None = None
) -> Profile:
    """Read a profile from its text.

    Parameters
    ----------
    text : the TOML text
    path : its file, for the id and for messages
    params : values that replace those of [params] for one unit

    Raises
    ------
    FormatError
        What is wrong, with the line where it stands.
    """
    try:
        data = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # also numbers of too many digits
        raise FormatError(path, f"is no TOML: {error}") from error
    top = Table(str(path), text, data, "")
    schema = top.integer("schema")
    if schema != SCHEMA:
        top.fail("schema", f"this program reads schema {SCHEMA}, not {schema}")
    given = [name for name in ("frame", "line", "protocol") if top.has(name)]
    for name in ("device", "port", "params", "field", "command"):
        top.has(name)
    top.done()
    if len(given) != 1:
        top.fail("", f"exactly one of [frame], [line], [protocol] is needed, not {len(given)}")
    if "field" in data and given != ["frame"]:
        top.fail("field", "[[field]] belongs to a [frame]")
    device, port = read_device(top.table("device")), read_port(top.table("port"))
    constants = read_params(top.table("params"), params or {})
    section = top.table(given[0])
    nominal_hz = section.number("nominal_hz", 0.0)
    if nominal_hz < 0:
        section.fail("nominal_hz", "must not be negative")
    stream = _read_stream(given[0], section, top, constants)
    checksum = stream.checksum if isinstance(stream, FrameSpec) else None
    commands = read_commands(top.tables("command"), checksum)
    return Profile(Path(path).stem, device, port, constants, stream, commands, nominal_hz, text)


def load_profile(path: Path | str, params: Mapping[str, float] | None = None) -> Profile:
    """Read a profile from a file; see `parse_profile`.

    Raises
    ------
    FormatError
        The file cannot be read, or what is wrong in it.
    """
    try:
        text = Path(path).read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise FormatError(path, f"cannot be read: {error}") from error
    return parse_profile(text, path, params)


def load_profiles(user_folder: Path | None = None) -> dict[str, Profile]:
    """Return all packaged profiles by id, sorted; a file of the user replaces one of its name.

    Raises
    ------
    FormatError
        A file of the user is wrong; the message names it.
    """
    profiles: dict[str, Profile] = {}
    for entry in (resources.files("resources") / "devices").iterdir():
        if entry.name.endswith(".toml"):
            profile = parse_profile(entry.read_text(encoding="utf-8"), entry.name)
            profiles[profile.id] = profile
    if user_folder is not None and user_folder.is_dir():
        for path in user_folder.glob("*.toml"):
            profile = load_profile(path)
            profiles[profile.id] = profile
    return dict(sorted(profiles.items()))
