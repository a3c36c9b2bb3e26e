"""The Thermal tab: a temperature cycle, or a record of a standing unit, in; compensation out.

tab.py            the tab put together
presenter.py      clicks in, `ThermalState` out
state.py          everything that the tab shows
library.py        sessions and records of the list and the work on them
working.py        what is computed of a cycle and of a record; needs no Qt
findings.py       a cycle -> tables of the right-hand side
record_findings.py  the same of a record
texts.py          numbers and units as texts
pictures.py       results -> curves of the plots
exporting.py      files: JSON, C header, CSV, plots
view.py           list and settings left, plots middle, findings right, actions below
settings_view.py  orders, reference, g, outputs
plots_view.py     one plot a sensor, heating and cooling apart
demo.py           pictures for the documentation
"""
