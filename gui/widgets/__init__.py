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
progress_ring     share and seconds left
pose_geometry     where the case axes point in the picture
position_picture  how the unit stands on the dividing head
step_list         the steps of a plan
action_bar        the row of actions and its keys
toggle            a switch
banner            inline message: what happened, what it means, what to do
device_strip      device, port, link, counters
================  ==================================================================

Others

================  ==================================================================
screenshots       pictures of widgets for the documentation
================  ==================================================================

A widget with a state has ``render(state)``, and tells by signals what the operator did.
"""
