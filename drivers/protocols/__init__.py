"""Decoder classes for what no table can describe.

options
    What [protocol] of a device file may say to each of them.
inertial
    Inertial Labs / InnaLabs AHRS, IMU and INS messages.
stim300
    Sensonor STIM300 datagrams, which configure their own reading.
xsens
    Xsens MTData2: items in changing combinations.
vectornav, vectornav_ascii
    VectorNav binary messages by masks, and text lines by headers.
cvg12
    InnaLabs CVG packets of twelve bytes with changing parameters.
"""
