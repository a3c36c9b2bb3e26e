"""What was added to the plain model of a calibration, for its page of results."""

from core.procedures.calibration import Calibration
from gui.widgets.number_text import value_and_uncertainty
from gui.widgets.states import TableState

_LEVEL = 0.95


def added_names(calibration: Calibration) -> tuple[str, ...]:
    """Every added effect by its name, with the outputs that it acts on."""
    channels: dict[str, list[str]] = {}
    for name, own in zip(calibration.channels, calibration.effects, strict=False):
        for one in own:
            channels.setdefault(one.name, []).append(name)
    return tuple(
        f"{effect}: {', '.join(dict.fromkeys(names))}" for effect, names in channels.items()
    )


def added_table(calibration: Calibration) -> TableState | None:
    """Parameters of the added effects, and where they are taken out; None where there are none."""
    rows: list[tuple[str, ...]] = []
    for name, fit, own in zip(
        calibration.channels, calibration.fits, calibration.effects, strict=False
    ):
        half = fit.expanded(_LEVEL)
        for one in own:
            for place in one.places:
                parameter = fit.parameters[place]
                rows.append(
                    (
                        name,
                        parameter.symbol,
                        *value_and_uncertainty(float(fit.values[place]), float(half[place])),
                        parameter.unit.replace("^2", "²").replace("^3", "³"),
                        one.name,
                        "taken out in use" if one.in_use else "this test alone",
                    )
                )
    if not rows:
        return None
    return TableState(
        "Effects that were added to the model",
        "U = plain model + e(input)",
        ("Sensor", "Parameter", "Value", "±U (95 %)", "Unit", "Effect", "Where"),
        tuple(rows),
        2,
    )
