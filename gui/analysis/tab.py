"""What the window asks of a tab, for one that has nothing to do with ports and rig."""

from PySide6.QtCore import QObject

from core.plans.plan import Plan, Step


class AnalysisTab(QObject):
    """A tab, or a page of one, that looks at what was measured."""

    def why_busy(self) -> str:
        """Why the ports cannot be let go of: nothing here uses them."""
        return ""

    def wanted(self) -> tuple[Plan, Step] | None:
        """Nothing has to be set on the rig."""
        return None
