"""The simulated rig beside the window: only there when the port is simulated.

================  ==================================================================
presenter         `RigPresenter`: orders to the rig, its state, the automatic operator
view              the dock's content
dial_view         the dividing head as a dial to turn
================  ==================================================================
"""
