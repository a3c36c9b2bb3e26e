"""The text files of ClbAcc, Pointer and ClbDUS.

layout
    `LegacyLayout` and `LEGACY_FORMATS`: the columns of every file, the only place that knows them.
rows
    Lines -> tokens -> rows of numbers.
recognise
    Which layout a file has, by the number of its columns and by their content.
reader
    `read_legacy`: a file -> `LegacyFile`.
mounts
    How the unit stood: by position number, or inferred from the passes of a ClbAcc file.
to_run
    `LegacyFile` -> `Run`.
writer
    `Run` -> text; whole files and one row at a time.
"""
