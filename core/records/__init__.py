"""What stands on disk: legacy text files, run files, sessions, calibrations, exports.

open
    `read_any`: a session folder, a run file or a legacy file -> `Run`.
legacy
    The text files of ClbAcc, Pointer and ClbDUS, read and written.
run_file
    ``NAME.run.csv`` <-> `Run`.
session
    The folder of one test: start document, journal of positions, raw bytes, legacy text.
calibration_json, exports
    A `Calibration` as JSON, C header, MATLAB file, CSV.
atomic, text, names
    Whole files or nothing; text of any lab computer; file names from device names.
"""
