"""Errors in methods that Qt calls fail the test instead of ending the process."""

from gui.widgets.override_guard import guard_overrides

guard_overrides()
