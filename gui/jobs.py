"""Long work in a worker thread, its result back in the thread of the window.

Signals of a worker reach the window's thread only where they are connected to methods of QObjects
that live there; functions and lambdas would run in the worker. That is why a job is asked for with
a method of a QObject, and why this is the only place that starts a worker.
"""

import sys
import threading
from collections.abc import Callable

from PySide6.QtCore import QObject, Qt, Signal

from core.errors import LabError

Work = Callable[[], object]


class Job(QObject):
    """One piece of work.

    Parameters
    ----------
    work : runs in a worker thread; returns what `done` brings, or raises a `LabError`
    name : of the thread
    """

    done = Signal(object)
    """What the work returned."""
    failed = Signal(object)
    """The `LabError` that it raised."""
    broke = Signal(object)
    """Another exception: a fault of the program."""

    def __init__(self, work: Work, name: str, parent: QObject) -> None:
        super().__init__(parent)
        self._work = work
        self._thread = threading.Thread(target=self._run, name=f"calrig {name}", daemon=True)

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def wait(self, seconds: float | None = None) -> bool:
        """Wait for the end; return whether it has come."""
        self._thread.join(seconds)
        return not self._thread.is_alive()

    @property
    def running(self) -> bool:
        """Whether the work goes on."""
        return self._thread.is_alive()

    def _run(self) -> None:
        ended = False
        try:
            result = self._work()
            ended = True
            self.done.emit(result)
        except LabError as error:
            ended = True
            self.failed.emit(error)
        finally:
            if not ended:
                self.broke.emit(sys.exception())


class Jobs(QObject):
    """Starts jobs and keeps them until they have ended.

    A job that breaks is raised again in the window's thread, where the program's hook reports it.
    """

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs: list[Job] = []

    def start(
        self,
        name: str,
        work: Work,
        done: Callable[[object], None],
        failed: Callable[[LabError], None],
    ) -> Job:
        """Begin a piece of work.

        Parameters
        ----------
        name : of the thread, in words
        work : runs in a worker thread and touches nothing of the window
        done, failed : methods of a QObject of the window's thread
        """
        for method in (done, failed):
            if not isinstance(getattr(method, "__self__", None), QObject):
                raise TypeError(f"{method!r} would run in the worker: give a method of a QObject")
        self._jobs = [job for job in self._jobs if job.running]
        job = Job(work, name, self)
        queued = Qt.ConnectionType.QueuedConnection
        job.done.connect(done, queued)
        job.failed.connect(failed, queued)
        job.broke.connect(self._on_broke, queued)
        self._jobs.append(job)
        job.start()
        return job

    def close(self, seconds: float = 5.0) -> None:
        """Wait for what still runs."""
        for job in self._jobs:
            job.wait(seconds)
        self._jobs.clear()

    def _on_broke(self, fault: BaseException) -> None:
        raise fault
