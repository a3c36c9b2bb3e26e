"""The tour of the window on the simulated rig: callouts that point at real widgets.

================  ==================================================================
steps             what is shown, in which order, and the words
tour              `Tour`: offers it once, goes through the steps, ends at any time
view              the callout and the frame around what it speaks of
================  ==================================================================
"""
