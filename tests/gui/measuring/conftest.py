"""The desk of the dividing head."""

from tests.gui.head_desk import desk, make_desk

__all__ = ["desk", "make_desk"]
