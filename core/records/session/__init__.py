"""The folder of one test.

::

    session.json            what was known before: plan, profile, device, operator, conditions
    positions.jsonl         the journal: one checked line an event, only ever appended to
    OpticalDividingHead_YYYYMMDDhhmm.txt
                            the legacy text of the rows that count now
    NAME.run.csv            the same as a run file, once the session is finished
    *.calrec                raw bytes, written by the drivers, named in the journal
    session.lock            held by the program that measures

start
    `SessionStart` <-> ``session.json``.
journal
    Lines that are durable when `append` returns, and that are checked when read.
events
    `Position` and `Event`: accepted, rejected, discarded, restored...; which positions count.
store
    `Session`: create, open, accept, discard, restore, finish.
record
    `SessionRecord`: a session as data, also of one that another program holds; as a `Run`.
find
    `unfinished`: sessions that wait to be continued; names of new folders.
lock
    One program at a time.
"""
