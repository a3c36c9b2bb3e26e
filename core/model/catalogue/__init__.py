"""Every effect that CalRig knows.

common, gyro
    What belongs to every calibration: bias, scale factor, cross axes, g-sensitivity.
nonlinear, history, gyro_static
    Further effects of the sensors themselves.
rig, table
    Effects of the dividing head, of mounting, and of the rate table.
timeline
    Drift, temperature, warm-up, jumps, offsets of runs, pick-up.
record, record_slow, record_facts
    Temperature with memory and the channels of a vibratory gyro in long records; wider forms of
    effects that runs have as well; noise terms and faults of the data.
faults, relabelling
    Mistakes of the operator and faults of the data; rows that mean something else than they say.
terms
    Scaled inputs, neighbours in time and groups, which the effects are made of.
listing
    `CATALOGUE`: all of them by identifier.
"""
