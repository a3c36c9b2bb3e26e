"""The Archive tab: every session and calibration by serial number.

tab.py             the tab put together
presenter.py       clicks in, `ArchiveState` out
state.py           everything that the tab shows
library.py         the open archive and the queue of work on it
findings.py        entries, comparisons, reports -> tables of the right-hand side
texts.py           numbers and words, for the tab and for ``calrig archive``
raw.py             raw logs: what their header tells, their bytes decoded again; no Qt
view.py            search and list left, history middle, findings right, actions below
entry_table.py     the list
history_plot.py    a parameter over time, with bars and limits
"""
