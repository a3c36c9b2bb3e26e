"""Bytes to samples and back; no Qt.

events
    What a decoder or a link can say.
profile, checksums, frame, line, decoders
    A device is a TOML file; its decoder turns bytes into events.
protocols
    Decoder classes for what no table can describe.
transport, ports, scan, commands
    pyserial, and who is at the other end.
reader, linkrate
    The one thread of a port, and the rate of its samples.
framing, rawlog
    Files of checked blocks, and the bytes of a link in one.
virtual
    The simulated rig: ``sim://`` and a process behind a pty; recordings as ``replay://``.
"""
