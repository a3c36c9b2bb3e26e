"""The science of CalRig: no Qt, no serial ports, no threads, no printing.

units, errors
    The only conversion factors; the error family and the notes of doubt.
samples
    Blocks of samples with counter time, accumulations of them, runs of accumulations.
plans
    What the rig must do to the sensor: mounts, head angles, rates, temperatures.
model
    Stimulus, Effect, SensorModel and the one catalogue of effects.
fit
    Weighted least squares; every estimate is a FitResult with its uncertainty.
procedures
    One file a method of the sources.
allan
    Allan deviation, its confidence, noise coefficients, the live curve.
records
    Legacy files, run files, sessions, exports.
"""
