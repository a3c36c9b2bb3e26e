"""Gyros on the rate table and at rest on the dividing head: the program ClbDUS.

The walk through the plan, the session and the widget are those of `gui.measuring`.

================  ==================================================================
tab               `make_tab`: puts the parts together
guide             what is particular to this test; how rates are recognised
words             how rates are called; whole turns in an accumulation
device            which devices have gyros
settings          what the operator sets beside the common settings
settings_view     the form: uncertainty of the table, the Earth, free lists
free              free lists of rates
results           Load Data, Process Data; a table run and a head run together
processing        their work, in a worker: fits and the page
tables            the tables and plots: Tables 3.2 to 3.7
formats           the files of the export
demo              its part of the demonstration
================  ==================================================================
"""
