"""The Drift tab: turn-ons in, a table for the microcontroller out.

tab.py            the tab put together
presenter.py      clicks in, `DriftState` out
state.py          everything that the tab shows
reading.py        files and folders -> turn-ons; for ``calrig drift`` too, needs no Qt
library.py        the turn-ons of the list and the work on them
knots.py          knots that are dragged, snapped, put back
findings.py       a result -> tables of the right-hand side
picture.py        a result -> curves of the plots
exporting.py      files: C header, JSON, CSV, plot
view.py           list and settings left, plots middle, findings right, actions below
settings_view.py  alignment, blocks, memory, knots, temperature of the chosen record
plots_view.py     turn-ons with the table and its knots; what is left on held-out turn-ons
demo.py           pictures for the documentation
"""
