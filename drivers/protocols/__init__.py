"""Decoder classes for what no table can describe.

options
    What [protocol] of a device file may say to each of them.
inertial
    Inertial Labs / InnaLabs AHRS, IMU and INS messages.
"""
