"""What a scan brought, in words."""

from core.errors import Severity
from drivers.profile import Profile
from drivers.scan import ScanReport
from gui.widgets.states import BannerState


def heard_words(report: ScanReport) -> str:
    """One sentence for each port."""
    words: list[str] = []
    told: set[str] = set()
    for found in report.found:
        if found.url in told:
            words.append(f"It could also be {found.profile.name}.")
            continue
        told.add(found.url)
        heard = f"{found.frames} frames" if found.frames else "it answered"
        words.append(f"{found.url}: {found.name}, {found.baud} baud ({heard}).")
    words += [f"{error.port}: {error.why}; {error.remedy}." for error in report.refused]
    words += [f"{url}: nothing came at any baud rate." for url in report.silent]
    words += [f"{url}: bytes came that no device file explains." for url in report.strange]
    return " ".join(words)


def question_words(report: ScanReport) -> str:
    """What to ask before anything is sent; empty where there is nothing to gain."""
    heard = {found.url for found in report.found if not found.identity and _answers(found.profile)}
    mute = set(report.silent) | set(report.strange)
    if heard:
        return (
            f"Ask for the names at {', '.join(sorted(heard))}? The unit is stopped, asked and"
            " started again."
        )
    if mute:
        return (
            f"Ask at {', '.join(sorted(mute))}? Identify commands of all known devices are sent;"
            " agree only if nothing else is connected there."
        )
    return ""


def _answers(profile: Profile) -> bool:

    return any(command.expect or command.expect_bytes for command in profile.commands.values())


def asked_banner(why: str) -> BannerState:
    """What to say when the ports cannot be let go of now."""
    return BannerState(
        Severity.WARNING, "The ports are in use", why, "Stop the accumulation first."
    )
