"""One accelerometer turned on the dividing head (source 000).

series
    The Fourier series (14) as effects of a model.
tumble
    `calibrate_tumble`: what a turn determines well, with the harmonics.
readings
    Angles and readings as a `Run`.
faults
    Tumbles that cannot be used.
overlap
    Angles that came again after a full turn: a free check of drift.
split
    The source's own parameters (18), where the data can separate them.
flip
    Two tumbles with the sensor turned over in its fixture: fixture and sensor apart.
pairs
    Test turns by 180 degrees: (4), (5), (8), (11).
study
    `study_tumble`: all of these for a run of one or two mounts.
"""
