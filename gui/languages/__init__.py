"""The languages of the window.

choice      which language is spoken; installs it, at the start and while the program runs
shown       words of states, notes and errors in the language of the window, and its decimal mark
plural      words behind numbers: 1 рядок, 2 рядки, 5 рядків
anchors     labels of the old programs, which stay English
gui_texts   texts that the sources give to Qt, found without running them
plain_texts English sentences with numbers in them, found as templates
ts_file     the XML of Qt Linguist
update      the command that brings the translations up to the sources

Below the views everything is said in English: states, logs, errors and files. A view translates
what it shows. docs/languages.md tells how, and how to add a language.
"""
