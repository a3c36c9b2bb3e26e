"""The application: one folder a tab, each with a presenter and a view.

================  ==================================================================
main              entry: no subcommand opens the window, a subcommand runs headless
commands          the subcommands of ``calrig``; no Qt
widgets           what all tabs are built of; knows no presenter
================  ==================================================================
"""
