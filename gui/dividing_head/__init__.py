"""Accelerometers on the dividing head: the programs ClbAcc and Pointer.

================  ==================================================================
tab               `make_tab`: puts presenter and view together
bench             the device on the head: is it there, what does it send
device            what the tab needs to know of a device: its layout and its sensors
settings          what the operator sets for the test
state             everything the view shows
presenter         the tab: clicks in, `HeadState` out
scene             the state put together from the parts
sitting           the session at the head: plan, settings, walk, folder
taking            what becomes of an accumulation: taken, doubted, taken back
measure           the walk through the plan, fed with samples
counts            how far a plan is, by the positions that count
keeper            the session on the disk: accept, repeat, discard, undo, resume
cues              the large line of the stage and the banner of a doubtful position
live              means and standard deviations of the last second
resuming          unfinished sessions
results           Load Data, Process Data
processing        their work: a calibration with its tables, in a worker
nominal           what earlier calibrations tell of a device
loading           files of any kind, and what to ask where they leave a choice
exporting         Export
graph             Main Graph
tables            a calibration as tables: Tables 1.3, 1.4, 2.3, 2.7
view              the tab's widget: plan left, stage middle, results right
settings_view     the operator's settings, ClbAcc and Pointer
live_view         the table of live means
results_view      the results page
================  ==================================================================
"""
