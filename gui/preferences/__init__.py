"""Preferences: what holds for every tab.

================  ==================================================================
presenter         what is remembered, and who is told of it
view              the panel below the device strip
================  ==================================================================
"""
