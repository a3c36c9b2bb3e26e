"""Sensors against temperature (source 002, and the list Temperatures of the dividing head).

over_temperature
    An effect whose parameters are polynomials of the temperature.
plateaus
    Which rows were measured at one temperature, and how it was reached.
orders
    The order of the polynomials, by cross-validation over temperatures.
points
    Bias and scale factor at each plateau; hysteresis.
cycle
    `calibrate_thermal`: all rows of a temperature cycle at once.
record
    `fit_record`: the output of a standing unit while the chamber goes through its cycle.
joined
    Several sessions of one cycle as one run.
split
    The parameters of source 002 at each temperature.
tilt
    Errors of roll and pitch before and after compensation.
export
    The compensated calibration as a C header, a document, a table.
simulated
    A triad taken through a cycle, for trying out and for tests.
"""
