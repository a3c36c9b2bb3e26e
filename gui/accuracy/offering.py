"""A check without a calibration: the nearest one of the archive is offered."""

from PySide6.QtCore import QObject, Signal

from core.archive.nearest import Usable
from core.errors import LabError, Severity
from gui.accuracy.checking import NEAREST, is_triad, near_of
from gui.accuracy.results import AccuracyResults
from gui.accuracy.texts import say
from gui.jobs import Jobs
from gui.messages import Messages
from gui.services import Nearest
from gui.widgets.states import BannerAction, BannerState

SOURCE = "accuracy calibration"
_USE = "use"


class Offering(QObject):
    """Looks up the archive in a worker, and offers what it finds; a button takes it.

    Parameters
    ----------
    results : the checks
    jobs : where the archive is asked
    messages : where the offer stands
    near : returns the nearest calibrations of the archive
    """

    accepted = Signal()
    """The nearest calibration is to be used."""

    def __init__(
        self,
        results: AccuracyResults,
        jobs: Jobs,
        messages: Messages,
        near: Nearest,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._results = results
        self._jobs = jobs
        self._messages = messages
        self._near = near
        self._asked: tuple[str, str] | None = None
        results.changed.connect(self._on_results)
        messages.action.connect(self._on_action)

    def _on_results(self) -> None:
        """Ask once for each check that has raw codes and nothing to judge them by."""
        checked = self._results.state
        if checked is None or not checked.wants_calibration:
            self._asked = None
            self._messages.clear(SOURCE)
            return
        asked = (checked.source, checked.request.calibration)
        # The nearest was looked for already where it is the choice.
        if asked == self._asked or checked.request.calibration == NEAREST:
            return
        self._asked = asked
        run, near = checked.run, self._near
        self._jobs.start(
            "nearest calibration",
            lambda: next((one for one in near_of(run, near) if is_triad(one.path)), None),
            self._on_found,
            self._on_failed,
        )

    def _on_found(self, found: object) -> None:
        checked = self._results.state
        if not isinstance(found, Usable) or checked is None or not checked.wants_calibration:
            return
        what = say("Nearest in the archive: {words}")
        banner = BannerState(
            Severity.INFO,
            what.format(words=found.words),
            say("The check has no calibration: only the unit's own angles are judged."),
            say("Use judges the raw codes too, by this calibration."),
            (BannerAction(_USE, say("Use")),),
        )
        self._messages.show(SOURCE, banner)

    def _on_failed(self, error: LabError) -> None:
        """An offer is welcome, not needed."""
        self._messages.log(Severity.INFO, str(error), SOURCE)

    def _on_action(self, source: str, key: str) -> None:
        if (source, key) == (SOURCE, _USE):
            self._messages.clear(SOURCE)
            self.accepted.emit()
