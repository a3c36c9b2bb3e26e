"""Tells what stands on a screen, as a screen reader hears it; for `newcomer.py`.

Run by Debian's own Python, which has the packages ``python3-gi`` and ``gir1.2-atspi-2.0``:

    /usr/bin/python3 tests/fresh_machine/eyes.py

For every line that comes in, a line goes out: a JSON list of what with a name the program of that
name shows, each ``[role, name, x, y, width, height, states, text]`` in pixels of the screen.
"""

import json
import sys

import gi  # pyright: ignore[reportMissingImports]

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, GLib  # noqa: E402  # pyright: ignore[reportMissingImports]

_STATES = ("FOCUSED", "CHECKED", "ENABLED", "SELECTED")
_FIELDS = ("text", "spin button")
_WIDEST = 400
"""Children looked at: a table of a million samples would never end."""


def seen(part, found):
    """Add what an accessible object and those inside it show; each question asks the program."""
    states = part.get_state_set()
    role = part.get_role_name()
    if not states.contains(Atspi.StateType.SHOWING):
        if role != "application":
            return
    elif name := part.get_name():
        place = part.get_extents(Atspi.CoordType.SCREEN)
        text = ""
        if role in _FIELDS:
            text = part.get_text(0, min(part.get_character_count(), 200))
        told = [one for one in _STATES if states.contains(getattr(Atspi.StateType, one))]
        found.append([role, name, place.x, place.y, place.width, place.height, told, text])
    for number in range(min(part.get_child_count(), _WIDEST)):
        child = part.get_child_at_index(number)
        if child is not None:
            seen(child, found)


def look(name):
    """Return all that the program shows; what vanishes meanwhile is left out."""
    found = []
    desktop = Atspi.get_desktop(0)
    for number in range(desktop.get_child_count()):
        program = desktop.get_child_at_index(number)
        try:
            if program is not None and program.get_name() == name:
                seen(program, found)
        except GLib.Error:
            continue
    return found


def main():
    Atspi.init()
    loop = GLib.MainLoop()

    def answer(_source, _condition):
        line = sys.stdin.readline()
        if not line:
            loop.quit()
            return False
        # A cache of names would tell what stood there before.
        Atspi.get_desktop(0).clear_cache()
        print(json.dumps(look(line.strip())), flush=True)
        return True

    # The loop also takes in what programs tell unasked; left lying it would fill the bus.
    GLib.io_add_watch(0, GLib.PRIORITY_DEFAULT, GLib.IO_IN | GLib.IO_HUP, answer)
    loop.run()


if __name__ == "__main__":
    main()
