"""Accuracy of pitch and roll: the Accuracy window of the program Pointer.

Measuring is that of every test on the head (`gui.measuring`); here is what is particular.

================  ==================================================================
tab               `make_tab`: puts everything together
guide             which units can be checked, how steps are called and recognised
settings          what the operator sets: limit, decision rule, calibration
settings_view     the form of these
results           Load Data, Process Data, and the verdict after every angle
checking          their work: a judged check, in a worker
offering          the nearest calibration offered to a check that has none
page              the results page as plain data
picture           the graph: which values on which page
state             graph, verdicts and traces as plain data
tables            readouts, Tables 2.5 and 2.6, errors, the decision rule in words
texts             words that several parts use
written           the files of a check
results_view      the results page
graph_view        the graph
================  ==================================================================
"""
