"""Bytes to samples and back; no Qt.

events
    What a decoder or a link can say.
profile, checksums, frame, line, decoders
    A device is a TOML file; its decoder turns bytes into events.
protocols
    Decoder classes for what no table can describe.
transport, ports, scan, commands
    pyserial, and who is at the other end.
reader, rawlog, replay
    The one thread of a port, the bytes as they came, and their replay.
virtual
    The simulated rig: ``sim://`` and a process behind a pty.
"""
