"""The only conversion factors.

Stored units: specific force in m/s^2, angle in degrees, rate in deg/s, temperature in degC, time
in s; raw outputs stay in the device's own unit (``"code"``, ``"V"``) until a calibration turns
them. Local gravity is always an argument: there is no default g in this package.
"""

import math

DEG_PER_RAD = 180.0 / math.pi
RAD_PER_DEG = math.pi / 180.0
ARCSEC_PER_DEG = 3600.0
ARCMIN_PER_DEG = 60.0
RAD_PER_ARCSEC = RAD_PER_DEG / ARCSEC_PER_DEG
DPH_PER_DPS = 3600.0
"""deg/h in one deg/s."""
DEG_PER_RT_H_PER_DEG_PER_RT_S = 60.0
"""deg/sqrt(h) in one deg/sqrt(s)."""
EARTH_RATE_DPS = 7.292115e-5 * DEG_PER_RAD
"""Rotation of the Earth, deg/s (WGS 84)."""
STANDARD_GRAVITY = 9.80665
"""m/s^2 in the unit "g" of a device that reports g; never a substitute for local gravity."""
PPM = 1e-6
MILLI = 1e-3
MICRO = 1e-6
