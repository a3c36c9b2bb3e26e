"""Measuring step by step through a plan: what all measuring tabs have in common.

A tab of its own writes a `Guide` (which devices, how steps are called, how they are recognised,
which settings), a `Results` (what is made of the measurements), a form of its settings, and the
formats of its export; `MeasuringTab` joins these with everything here. Messages, preferences and
offers of unfinished sessions are kept apart by the guide's `key`.

================  ==================================================================
tab               `MeasuringTab`: puts everything together
guide             `Guide`: what is particular to one kind of test
words             `Words`: how its steps are called
head_words        those of every test on the dividing head
settings          what the operator sets in every test
site              what the laboratory states in every session
device            what a tab needs to know of a device: its layout and its sensors
nominal           what earlier calibrations tell of a device
bench             the device on the rig: is it there, what does it send
sitting           the session: plan, settings, walk, folder
walk              the walk through the plan, fed with samples; `Course`
counts            how far a plan is, by the positions that count
keeper            the session on the disk: accept, repeat, discard, undo, resume
taking            what becomes of an accumulation: taken, doubted, taken back
cues              the large line of the stage and the banner of a doubtful position
resuming          unfinished sessions
results           `Results`: Load Data, Process Data
bending           `BendingResults`: calibrated with effects that Model vs data added
formats           what every calibration can be exported to
added_table       those effects as a table
loading           files of any kind, and what to ask where they leave a choice
page              the results page as plain data
printed           its parts as JSON and back, for certificates
live              means and standard deviations of the last second
graph             Main Graph
state             everything the view shows
scene             the state put together from the parts
presenter         clicks in, `MeasuringState` out
view              the tab's widget: plan left, stage middle, results right
settings_view     the form of the settings
live_view         the table of live means
results_view      the results page
curve_view        a plot of the results page
demonstrating     what the demonstrations of the tabs are made of
================  ==================================================================
"""
