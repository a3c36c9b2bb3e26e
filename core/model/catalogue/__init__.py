"""Every effect that CalRig knows.

common, gyro
    Effects of the sensors themselves.
listing
    `CATALOGUE`: all of them by identifier.
"""
