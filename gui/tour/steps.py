"""What the tour shows, in which order."""

from dataclasses import dataclass
from enum import Enum

from PySide6.QtCore import QCoreApplication


class Place(Enum):
    """What a callout points at."""

    STRIP = "strip"
    STEPS = "steps"
    STAGE = "stage"
    SETTINGS = "settings"
    ACTIONS = "actions"
    RIG = "rig"
    TABS = "tabs"
    MENU = "menu"


@dataclass(frozen=True, slots=True)
class TourStep:
    """One callout."""

    place: Place
    title: str
    text: str


def tour_steps() -> tuple[TourStep, ...]:
    """The steps in the language of the window."""
    return (
        TourStep(
            Place.STRIP,
            QCoreApplication.translate("Tour", "The device"),
            QCoreApplication.translate(
                "Tour",
                "A simulated sensor unit is connected; a real one is found by Properties, Scan."
                " This line tells whether samples come, how fast, and whether any are bad or lost.",
            ),
        ),
        TourStep(
            Place.STEPS,
            QCoreApplication.translate("Tour", "The plan"),
            QCoreApplication.translate(
                "Tour",
                "Every position that this test wants, with its picture. The marked one is next;"
                " a click, a digit, or the arrows and Enter pick another.",
            ),
        ),
        TourStep(
            Place.STAGE,
            QCoreApplication.translate("Tour", "What to do now"),
            QCoreApplication.translate(
                "Tour",
                "The order of the moment in large letters: turn, wait, measuring, done. F11 gives"
                " it the whole screen, so that it is read from the dividing head.",
            ),
        ),
        TourStep(
            Place.RIG,
            QCoreApplication.translate("Tour", "The simulated rig"),
            QCoreApplication.translate(
                "Tour",
                "Drag the hand of the dial, or let Operator turns it for me do it. Faults can be"
                " tried as well: unplug the cable, and see that nothing is lost.",
            ),
        ),
        TourStep(
            Place.ACTIONS,
            QCoreApplication.translate("Tour", "Measuring"),
            QCoreApplication.translate(
                "Tour",
                "Space accumulates, here and in every tab. Backspace repeats the last position,"
                " Ctrl+Z takes it back, Esc stops. Switch Hands-free on, and a turned and resting"
                " head is enough. At the end Process Data (F5), then Export.",
            ),
        ),
        TourStep(
            Place.SETTINGS,
            QCoreApplication.translate("Tour", "Settings of the test"),
            QCoreApplication.translate(
                "Tour",
                "Times, local gravity and its uncertainty, uncertainty of the head. What holds"
                " for the whole laboratory stands in Preferences (Ctrl+,).",
            ),
        ),
        TourStep(
            Place.TABS,
            QCoreApplication.translate("Tour", "The other tabs"),
            QCoreApplication.translate(
                "Tour",
                "Gyros on the rate table, a check of the accuracy, live charts, noise, thermal"
                " tests, drift tables; Archive finds everything again by serial number. Ctrl and a"
                " digit open a tab.",
            ),
        ),
        TourStep(
            Place.MENU,
            QCoreApplication.translate("Tour", "Menu and help"),
            QCoreApplication.translate(
                "Tour",
                "Light or dark, sounds, preferences, and this tour again. F1 shows all keys. That"
                " is all: press Space at any position, and the first calibration begins.",
            ),
        ),
    )
