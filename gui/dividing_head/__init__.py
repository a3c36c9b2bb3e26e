"""Accelerometers on the dividing head: the programs ClbAcc and Pointer.

The walk through the plan, the session and the widget are those of `gui.measuring`.

================  ==================================================================
tab               `make_tab`: puts the parts together
guide             what is particular to this test
device            which devices have accelerometers, and their layouts
settings          what the operator sets beside the common settings
settings_view     the form: base plate, tilter, free angles
results           Load Data, Process Data
processing        their work: a calibration with its page, in a worker
formats           the files of the export
tables            a calibration as tables: Tables 1.3, 1.4, 2.3, 2.7
demo              its part of the demonstration
thermal_offer     the way to the Thermal tab after a temperature cycle
================  ==================================================================
"""
