"""The Live tab: watch, record, mark, measure between two cursors; CVGCom's screen.

================  ==================================================================
settings          what the operator sets: Device and Port Settings of fig. 5.3
state             what the tab shows, as plain data
trace             the samples on the screen, live or of a record
keeper            the record on the disk: start, stop, resume, discard
loading           records from the disk, in a worker
space             room on the disk, and how long it lasts
interrupted       records that a crash interrupted, offered at the start
figures           statistics between cursors as a table
sample_files      samples of an interval as CSV and MATLAB
exporting         samples, means and charts into files
measures          cursors, intervals, means, exports of what is on the screen
means             means as a table, handed over to the fits
scene             words and buttons of each phase
presenter         clicks in, state out
charts_view       the page Charts with its tools
table_view        the page Table, newest on top
means_view        the page Means
settings_view     the settings panel; tools_view what concerns the display alone
view, tab         all of it together
================  ==================================================================
"""
