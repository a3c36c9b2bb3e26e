"""How a unit stands on a dividing head, by rotation matrices alone.

Room frame: s along the shaft away from the head, l = v x s, v up. The head turns the unit by
minus the dial angle about s. At dial angle zero the case axis Z is up (for Z along the shaft: X).
"""

import numpy as np

ARCSEC = np.pi / 648000.0
AXES = "XYZ"
SHAFT, SIDE, UP = np.eye(3)


def rotation(axis: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """Rodrigues' formula: matrices (n, 3, 3) of right-handed turns by `angle` (rad)."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = np.atleast_1d(np.asarray(angle, float))[:, None, None]
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * (cross @ cross)


def split(mount: str) -> tuple[int, float, float]:
    """Case axis along the shaft, +1 away from the head or -1 to it, re-index angle (rad)."""
    name, _, index = mount.partition("@")
    axis, sense = name.split("_")
    return AXES.index(axis), {"from": 1.0, "to": -1.0}[sense], np.radians(float(index or 0.0))


def bolted(mount: str) -> np.ndarray:
    """Columns: the case axes X, Y, Z in the room at dial angle zero."""
    along, sense, _ = split(mount)
    upright = 0 if along == 2 else 2
    columns = np.zeros((3, 3))
    columns[:, along] = sense * SHAFT
    columns[:, upright] = UP
    rest = 3 - along - upright
    columns[:, rest] = np.cross(columns[:, (rest + 1) % 3], columns[:, (rest + 2) % 3])
    return columns


def attitude(mounts: list[str], dial: np.ndarray, tilt: float, roll: np.ndarray) -> np.ndarray:
    """Room-from-case matrices (n, 3, 3).

    dial : true angle of the dial (rad); tilt : by how much the shaft's free end stands high;
    roll : angle (rad) by which each row's unit was bolted on too far, in the dial's sense
    """
    wedge = rotation(SIDE, -tilt)[0]
    index = np.array([split(mount)[2] for mount in mounts])
    start = {mount: bolted(mount) for mount in set(mounts)}
    base = np.array([start[mount] for mount in mounts])
    return wedge @ rotation(SHAFT, -(dial + index + roll)) @ base


def seen_from_case(room_vector: np.ndarray, room_from_case: np.ndarray) -> np.ndarray:
    """Components (n, 3) of a vector of the room along the case axes."""
    return np.einsum("nij,i->nj", room_from_case, room_vector)
