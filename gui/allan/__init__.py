"""The Allan tab: noise of records at rest.

tab.py            the tab put together
presenter.py      clicks in, `AllanState` out
state.py          everything that the tab shows
library.py        the records of the list and the queue of work on them
live.py           the curve of the running device, by streaming accumulation
texts.py          numbers and tables as texts, for the tab and for ``calrig allan``
findings.py       a study -> tables of the right-hand side
picture.py        studies -> curves of the plot
exporting.py      files: plot, tables, Kalibr, MATLAB
certified.py      a record's noise as a certificate takes it
view.py           list left, plot middle, findings right, actions below
settings_view.py  what the operator decides about the chosen record
plot_view.py      the log-log plot with its cursor
"""
