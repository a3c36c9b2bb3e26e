"""A board at the end of a wire: a thread that writes frames into a pty."""

import os
import threading
import time
import tty

import numpy as np

from tests.drivers.teach.layouts import Layout, frames_of


class Board:
    """Sends the frames of a layout, with garbage between some of them, until it is closed."""

    def __init__(self, layout: Layout, rate: float = 200.0, seed: int = 1) -> None:
        self.layout = layout
        self._rate = rate
        self._rng = np.random.default_rng(seed)
        self._master, slave = os.openpty()
        tty.setraw(slave)
        self.port = os.ttyname(slave)
        self._slave = slave
        os.set_blocking(self._master, False)
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, name="board", daemon=True)
        self._thread.start()

    def close(self) -> None:
        self._stop.set()
        self._thread.join()
        os.close(self._master)
        os.close(self._slave)

    def _run(self) -> None:
        sent, begun = 0, time.monotonic()
        while not self._stop.wait(0.02):
            due = int((time.monotonic() - begun) * self._rate)
            for row in frames_of(self.layout, self._rng, sent, due - sent):
                data = row.tobytes()
                if self._rng.random() < self.layout.garbage:
                    data += self._rng.integers(0, 256, 5, np.uint8).tobytes()
                try:
                    os.write(self._master, data)
                except BlockingIOError:
                    continue
            sent = due
