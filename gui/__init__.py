"""The application: one folder a tab, each with a presenter and a view.

================  ==================================================================
main              entry: no subcommand opens the window, a subcommand runs headless
app               makes every part and joins them; the table of tabs
main_window       device strip, tabs, banner, log, the rig's dock
tab_maker         the tab on the screen first, the others behind it
hooks             faults of the program, orders of the system
guidance          what helps beside the tabs: the following four
distance          the step of a tab over the whole window
keys              the sheet of keys, read from the window
preferences       what holds for every tab
tour              callouts over the window on the simulated rig
demonstration     the window plays by itself, and makes the pictures of the documentation
commands          the subcommands of ``calrig``; no Qt
measuring         step by step through a plan: what all measuring tabs share
analysis          records of a list worked out together: what analysis tabs share
dividing_head     accelerometers on the dividing head: ClbAcc and Pointer
drift             turn-ons in, a table for the microcontroller out
rate_table        gyros on the rate table and on the head: ClbDUS
thermal           sensors over temperature, from a cycle or a record
live              watching and recording: CVGCom
rig               the dock of the simulated rig
exporting         a proposed file name, and the writing of every format
services          what every tab is given
devices           which devices at which ports, and the links to them
garbage           cyclic garbage is collected in the window's thread alone
jobs              long work in a worker thread
messages          the banner and the log
settings          what is remembered from one start to the next
widgets           what the tabs are built of; knows no presenter
================  ==================================================================
"""
