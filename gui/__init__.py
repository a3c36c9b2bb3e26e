"""The application: one folder a tab, each with a presenter and a view.

================  ==================================================================
main              entry: no subcommand opens the window, a subcommand runs headless
commands          the subcommands of ``calrig``; no Qt
devices           which devices at which ports, and the links to them
jobs              long work in a worker thread
messages          the banner and the log
settings          what is remembered from one start to the next
widgets           what the tabs are built of; knows no presenter
================  ==================================================================
"""
