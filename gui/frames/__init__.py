"""Teach a board: from raw bytes to a device file, by pointing.

================  ==================================================================
listening         the latest bytes of a port, or of a file
source            `Source`: which port or file; the picture held or following
taught            `Taught`: the description under way, and what an operator changes in it
saving            its file in the user's folder
state             what the tab shows
readings          sheet, live values and small charts of the latest bytes
texts             words
presenter         joins these
bytes_view        the bytes in rows, coloured, with a selection of columns
fields_view       the fields with their values and charts
field_form_view   the form of one field
source_view       port, file, and what was heard
definition_view   header, length, checksum, lines; name and saving
view, tab         all of it put together
demo              its part of the demonstration
================  ==================================================================
"""
