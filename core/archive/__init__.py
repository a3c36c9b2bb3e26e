"""Everything that was measured, found again: an index beside the files, which stay the truth.

entry
    `Entry` and `Quantity`: what the index holds of a file.
place
    ``archive.json``: the identity of a folder of sessions, and where its index stands.
reading
    `READERS`: session, calibration, run file, legacy file, record, means, noise -> entries.
noise_file
    The table of noise coefficients that ``calrig allan`` exports, as quantities.
scan
    Which folders have changed since the last look.
tables
    The tables of the index, its schema version, its migrations.
database
    SQLite beside the files, or PostgreSQL by URL: opened, made, migrated, set aside.
store
    `Archive`: open, refresh, rebuild, search.
search
    The questions to the index as SQL.
history
    A parameter over time: scatter from turn-on to turn-on, drift.
limits
    ``limits.toml``: what the laboratory demands of a parameter.
compare
    Two calibrations: difference over combined uncertainty.
nearest
    The calibration nearest by date and temperature; those whose files stand here.
importing
    Folders of old files copied into the archive, each once.
reprocess
    Positions decoded again from their raw bytes, beside what was stored.

Only `tables`, `database`, `search` and `store` import SQLAlchemy; who starts a window imports them
in a worker.
"""
