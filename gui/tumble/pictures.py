"""A study -> the pictures of the page."""

import numpy as np
from PySide6.QtCore import QCoreApplication

from core.procedures.fourier.study import TumbleStudy
from core.samples.run import Run
from gui.tumble.state import BarsState, HarmonicBar, PolarSeries, PolarState

_FUNCTIONS = ("sin", "cos")


def polar_of(study: TumbleStudy, run: Run) -> PolarState:
    """Residuals of every realisation of every mount."""
    series: list[PolarSeries] = []
    for place, (tumble, rows) in enumerate(zip(study.tumbles, study.rows, strict=True)):
        fit = tumble.fit
        passes = run.run[list(rows)]
        u95 = fit.residual_limits()
        for number in np.unique(passes):
            chosen = passes == number
            name = QCoreApplication.translate("TumblePictures", "pass {number}")
            words = name.format(number=int(number))
            if len(study.tumbles) > 1:
                words = f"{study.mounts[place]}, {words}"
            series.append(
                PolarSeries(words, tumble.alpha_deg[chosen], fit.residuals[chosen], u95[chosen])
            )
    return PolarState(tuple(series), run.unit)


def bars_of(study: TumbleStudy, unit: str) -> BarsState:
    """Sine and cosine of every harmonic of the first mount, with what noise alone would reach."""
    bars: list[HarmonicBar] = []
    for harmonic in study.tumbles[0].harmonics:
        order = "" if harmonic.order == 1 else str(harmonic.order)
        both = zip(_FUNCTIONS, (harmonic.sine, harmonic.cosine), strict=True)
        bars += [
            HarmonicBar(f"{name} {order}α", found.value, found.expanded(0.99))
            for name, found in both
        ]
    return BarsState(tuple(bars), unit)
