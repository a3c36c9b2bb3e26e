"""The Live tab: watch, record, mark, measure between two cursors; CVGCom's screen.

================  ==================================================================
settings          what the operator sets: Device and Port Settings of fig. 5.3
state             what the tab shows, as plain data
trace             the samples on the screen, live or of a record
keeper            the record on the disk: start, stop, resume, discard
loading           records from the disk, in a worker
figures           statistics between cursors and means, as tables
exporting         samples of an interval as CSV and MATLAB, charts as pictures
measures          cursors, intervals, means, exports of what is on the screen
scene             words and buttons of each phase
presenter         clicks in, state out
charts_view       the page Charts with its tools
table_view        the page Table, newest on top
settings_view     the settings panel; tools_view what concerns the display alone
view, tab         all of it together
================  ==================================================================
"""
