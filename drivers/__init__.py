"""Bytes to samples and back; no Qt.

events
    What a decoder or a link can say.
profile, profile_types, profile_sections, profile_commands, toml_table, expression
    A device is a TOML file, read strictly.
decoders, encode
    Which decoder a profile needs; its samples as bytes for the simulated rig.
frame, line, protocols
    Decoders of fixed frames, of text, and of what no table can describe.
stream, finder, shape, checksums, fields, columns, counter, lines
    What the decoders are made of: frames found, checked, read and numbered many at a time.
transport, ports, scan, commands
    pyserial, and who is at the other end.
reader, linkrate, pauses
    The one thread of a port, the rate of its samples, and whether it was asleep.
framing, rawlog, recorder, recording, spells, records
    Files of checked blocks; in them the bytes of a link and, in a record, its samples.
teach
    What an unknown board sends, found out from its bytes.
virtual
    The simulated rig: ``sim://`` and a process behind a pty; recordings as ``replay://``.
"""
