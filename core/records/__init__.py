"""What stands on disk: legacy text files, run files, sessions, calibrations, exports.

open
    `read_any`: a session folder, a run file or a legacy file -> `Run`.
legacy
    The text files of ClbAcc, Pointer and ClbDUS, read and written.
run_file, run_head, run_table
    ``NAME.run.csv`` <-> `Run`.
cvgcom, cvgcom_name, cvgcom_writer, decimals
    CVGCom's text file of a record, its name, its writing sample by sample, its fast reading.
means
    ``means.dat``: the mean of each record, and what the fits take of it.
session
    The folder of one test: start document, journal of positions, raw bytes, legacy text.
calibration_json
    `Calibration` <-> JSON, to the last bit.
exports, export_c, export_c_effects, export_csv, export_mat
    `EXPORTS`: calibrations for firmware, spreadsheets and MATLAB.
result_format, drift_exports, thermal_exports
    Drift tables and calibrations over temperature for firmware and spreadsheets.
json_text
    Any result as JSON text.
atomic, text, names, json_fields, replicates
    Whole files or nothing; text of any lab computer; file names from device names; JSON that names
    what is wrong in it; replicates of a position.
"""
