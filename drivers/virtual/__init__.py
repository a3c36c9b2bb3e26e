"""The simulated rig: a dividing head, a rate table, a chamber, and a unit bolted on.

rig
    `Rig`: the bench and its unit; `rig_of` finds the rig behind a ``sim://`` port.
bench
    What moves: head, mount, table, chamber; what acts on the unit, sample by sample.
devices
    The four units with their hidden truth.
noise
    White noise, flicker, random walk, first-order lags.
faults
    What goes wrong on the line.
fed_port, protocol_sim, protocol_replay
    Ports of pyserial that are fed by the program: ``sim://DEVICE``, ``replay://PATH``.
pty_rig
    The same rig in a process of its own behind a real pseudo-terminal.
rows
    A model that was found on the bench: rows that were measured, walked through again.
operator, session, truth
    Walks a plan at a rig as a person would; a whole session of it without a window;
    estimates beside the hidden truth.
"""
