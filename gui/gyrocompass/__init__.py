"""The page Gyrocompass: heading and drift of a gyro on a level base."""
