"""The Archive tab: every session and calibration by serial number.

tab.py             the tab put together
presenter.py       clicks in, `ArchiveState` out
state.py           everything that the tab shows
library.py         the open archive and the queue of work on it
questions.py       what is asked of the archive, in the worker
findings.py        answers -> tables of the right-hand side and the picture
actions.py         the row of actions
failures.py        what could not be done, and what to do
exporting.py       the tables as a file
texts.py           numbers and words, for the tab and for ``calrig archive``
opening.py         in which tab an entry can be worked with; no Qt
raw.py             raw logs: what their header tells, their bytes decoded again; no Qt
view.py            search and list left, history middle, findings right, actions below
entries_view.py    the list
history_view.py    a parameter over time, with bars and limits
date_ticks.py      where an axis of dates has its ticks
demo.py            its part of the demonstration
"""
