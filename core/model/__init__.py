"""What a sensor does to its input.

stimulus
    `Stimulus`: what acted on the sensor, row by row.
effect
    `Effect`, `Parameter`, `Sensor`: one named physical cause, written once.
sensor_model
    `SensorModel`: a sensor is a list of effects.
catalogue
    Every effect that CalRig knows; `catalogue.listing.CATALOGUE` by identifier.
"""
