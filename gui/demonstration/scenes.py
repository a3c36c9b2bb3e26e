"""Every part of the demonstration, and the pictures of the documentation that it makes."""

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Scene:
    """One part.

    Parameters
    ----------
    module : has ``play(stage) -> Told``
    pictures : those of the window that pages show; files are ``NAME-light.png``, ``NAME-dark.png``
    drawings : those of paper, which has one look; files are ``NAME.png``
    after : the part whose files this one works with; it is played before
    """

    module: str
    pictures: tuple[str, ...]
    drawings: tuple[str, ...] = ()
    after: str = ""

    @property
    def files(self) -> tuple[str, ...]:
        """Names of the files of the documentation that this part makes."""
        looks = (f"{name}-{look}.png" for name in self.pictures for look in ("dark", "light"))
        return (*looks, *(f"{name}.png" for name in self.drawings))


SCENES: dict[str, Scene] = {
    "head": Scene(
        "gui.dividing_head.demo",
        ("dividing-head-measuring", "dividing-head-results"),
    ),
    "rate": Scene("gui.rate_table.demo", ("rate-table-measuring", "rate-table-results")),
    "accuracy": Scene("gui.accuracy.demo", ("accuracy-measuring", "accuracy-roll")),
    "live": Scene("gui.live.demo", ("live-record", "live-means")),
    "allan": Scene("gui.allan.demo", ("allan-comparison",), after="live"),
    "comparison": Scene("gui.methods.comparison_demo", ("compare-gyros",), after="allan"),
    "thermal": Scene("gui.thermal.demo", ("thermal-bias", "thermal-tilt")),
    "drift": Scene("gui.drift.demo", ("drift-all", "drift-dragged")),
    "methods": Scene(
        "gui.methods.demo",
        ("methods-which-procedure", "methods-tumble", "methods-gyrocompass"),
    ),
    "discrepancy": Scene(
        "gui.discrepancy.demo",
        ("model-vs-data-found", "model-vs-data-next", "model-vs-data-closed"),
    ),
    "archive": Scene("gui.archive.demo", ("archive-history", "archive-comparison")),
    "frames": Scene("gui.frames.demo", ("teach-found", "teach-named")),
    "certificate": Scene(
        "gui.certificate.demo",
        ("certificates-draft", "certificates-limits", "certificates-issued"),
        ("certificate-page-1",),
    ),
    "operating": Scene(
        "gui.demonstration.operating",
        (
            "tour",
            "distance-view",
            "keys",
            "preferences",
            "device-properties",
            "wrong-position",
            "link-lost",
            "adc-data",
        ),
    ),
}
"""All parts by their keys, in the order of playing."""


def with_what_they_need(keys: Iterable[str]) -> tuple[str, ...]:
    """These parts and those whose files they work with, in the order of playing."""
    wanted: set[str] = set()
    for key in keys:
        while key:
            wanted.add(key)
            key = SCENES[key].after
    return tuple(key for key in SCENES if key in wanted)
