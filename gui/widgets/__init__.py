"""The pieces that all tabs are built of. None knows a presenter, none computes physics.

States and looks

================  ==================================================================
states            what the widgets show, as plain data; no QtWidgets, for presenters
colours           the table of the light and the dark look
theme             `apply_theme`, `current_theme`, the shipped fonts
style_sheet       the few rules beside the palette
icons             signs of tones, steps and severities
number_text       digits by uncertainty, aligned decimals
================  ==================================================================

Parts of the measuring tabs

================  ==================================================================
stage             the line that is read from three metres, with its picture
distance_view     the same over the whole window
progress_ring     share and seconds left
pose_geometry     where the case axes point in the picture
position_picture  how the unit stands on the dividing head
table_picture     how the rate table turns
step_list         the steps of a plan
action_bar        the row of actions and its keys
toggle            a switch
decision_form     what the forms of settings share
export_foot       format, file name and button under results
page_scroll       a page that scrolls up and down
side_scroll       a column of settings as wide as it needs
fields            numbers and choices that no wheel changes by accident
banner            inline message: what happened, what it means, what to do
device_strip      device, port, link, counters
old_label_tip     what the old programs call the thing under the mouse
================  ==================================================================

Charts of samples over time

================  ==================================================================
pyramid           extremes of any stretch of a record, exact; no Qt
moments           mean, scatter, trend of any stretch; no Qt
history           all channels with their gaps; no Qt
chart_scale       round ticks, ranges with hysteresis; no Qt
strip_view        window of time and ranges that the charts show; no Qt
strip_painter     drawing of the stacked charts on any painter
polyline          arrays of points as polygons
strip_canvas      painting and what mouse and keys do
strip_charts      the widget that tabs use
================  ==================================================================

Results and analysis

================  ==================================================================
records_page      frame of an analysis of several records: list, picture, findings
analysis_page     frame of an analysis page: picture, findings, actions
panes             panes side by side over the row of actions
hint_label        what to do, where a picture will stand
field_form        fields, each behind its name
noise_fields      N, B and K of a sensor, typed or from a record
findings_view     tables, doubts, and what can be exported: the right-hand side
result_table      texts under a title and an equation; clipboard
kept_columns      wide tables whose first columns stay
table_model       rows under a header, for the views of tables
table_text        tables as TSV and CSV
painted_view      drawn whole by one method, on the screen and for export
matrix_view       a matrix in brackets, its uncertainties and its equation
residual_plot     residuals by position inside their band
plot              curves, bands, points with bars, logarithmic axes (pyqtgraph)
legend            names of curves above a plot
fast_axis         opaque grid and decades (pyqtgraph)
chart_export      any of the charts as SVG, PNG, PDF
================  ==================================================================

Others

================  ==================================================================
log_drawer        what happened since the start
window_menu       where to go, look, sounds, help
sound             start tick, done, error
override_guard    a Python error in a method that Qt calls does not end the program
screenshots       pictures of widgets for the documentation
================  ==================================================================

A widget with a state has ``render(state)``, and tells by signals what the operator did.
"""
