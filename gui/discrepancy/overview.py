"""What stands above all: the gap before and after, how sure each name is, what to do next."""

from PySide6.QtCore import QCoreApplication

from core.discrepancy.result import Explanation
from core.errors import Note
from gui.discrepancy.certainty import certainty_words, tone_of
from gui.discrepancy.state import StepRow
from gui.discrepancy.working import RECORD, Story
from gui.widgets.number_text import fixed, grouped


def measured_words(story: Story) -> str:
    """The unit, and how much was measured."""
    run, count = story.run, len(story.told.channels)
    if run.test == RECORD:
        template = QCoreApplication.translate("Discrepancy", "{device}: {rows} samples")
    elif count == 1:
        template = QCoreApplication.translate("Discrepancy", "{device}: {rows} rows")
    else:
        template = QCoreApplication.translate(
            "Discrepancy", "{device}: {rows} rows × {count} outputs"
        )
    return template.format(device=run.device, rows=grouped(len(run)), count=count)


def notes_of(story: Story, summary: str) -> tuple[Note, ...]:
    """Every doubt once, without what the summary says already."""
    # A record is explained as a whole: before Find nothing of that is told.
    unsaid = story.known is not None and story.proposed is None
    found = story.run.notes
    if not unsaid:
        found = (*found, *(story.proposed or story.told).notes)
    said = summary.lower()
    kept = {note.text: note for note in found if note.text.lower().rstrip(".") not in said}
    return tuple(kept.values())


def gaps_of(story: Story) -> str:
    """The gap now, or before and after all that was found; empty where nothing can be said."""
    best = story.proposed or story.told
    before, after = best.before.gap, best.after.gap
    if before != before:
        return ""
    return f"{fixed(before, 2)} → {fixed(after, 2)}" if best.steps else fixed(before, 2)


def found_of(story: Story) -> tuple[StepRow, ...]:
    """Each step that was found, with how sure its name is."""
    best = story.proposed or story.told
    added = len(story.told.steps)
    return tuple(
        StepRow(tone_of(step), step.name, certainty_words(step), place < added)
        for place, step in enumerate(best.steps)
    )


def advice_of(story: Story, *, rejected: bool, alone: str) -> str:
    """What the operator does next.

    Parameters
    ----------
    rejected : the plain model does not hold
    alone : what stands there in place of data; see `DiscrepancyPresenter.alone`
    """
    if alone == "plan":
        return ""
    if alone:
        return QCoreApplication.translate(
            "Discrepancy", "Look at the residuals, and answer on the page Practice."
        )
    record = story.run.test == RECORD
    if story.told.verdict == "not_enough_data":
        if record:
            return QCoreApplication.translate("Discrepancy", "Record for longer.")
        return QCoreApplication.translate(
            "Discrepancy",
            "Measure more positions, and each twice; then load both files together.",
        )
    if story.proposed is None:
        if rejected:
            return QCoreApplication.translate("Discrepancy", "Find (Space) looks for the reason.")
        return QCoreApplication.translate("Discrepancy", "Find (Space) looks closer.")
    return after_search(story, story.proposed)


def after_search(story: Story, best: Explanation) -> str:
    """What is to be done by what was found."""
    record = story.run.test == RECORD
    if best.verdict == "adequate":
        return QCoreApplication.translate(
            "Discrepancy",
            "Nothing to add. “What can be seen” tells how small an effect would have been named.",
        )
    if best.verdict == "excess_noise":
        return QCoreApplication.translate(
            "Discrepancy", "Measure once more: noise goes another way then, a cause does not."
        )
    if best.verdict == "data_fault" and best.steps[0].remedy:
        words = best.steps[0].remedy
        return f"{words[:1].upper()}{words[1:]}."
    if best.next_measurements:
        first = best.next_measurements[0]
        template = QCoreApplication.translate(
            "Discrepancy",
            "Measure next: {title}, {minutes} min; it decides with {chance} %. Then load both files"
            " together.",
        )
        if record:
            template = QCoreApplication.translate(
                "Discrepancy", "Record next: {title}, {minutes} min; it decides with {chance} %."
            )
        return template.format(
            title=first.title,
            minutes=fixed(first.minutes, 0),
            chance=fixed(100.0 * first.probability, 0),
        )
    if best.verdict == "unexplained_structure":
        return QCoreApplication.translate(
            "Discrepancy",
            "Look at rig and sensor where the curve is largest, and measure more densely there.",
        )
    if best.verdict == "ambiguous":
        return QCoreApplication.translate(
            "Discrepancy",
            "No series that was tried would decide; only knowledge from elsewhere can.",
        )
    return _named(story, record=record)


def _named(story: Story, *, record: bool) -> str:
    if story.proposals:
        return QCoreApplication.translate(
            "Discrepancy", "Add to Model (Ctrl+Return); a new series then confirms the name."
        )
    if record:
        return QCoreApplication.translate(
            "Discrepancy", "Report (Ctrl+E); a second record confirms the name."
        )
    return QCoreApplication.translate(
        "Discrepancy",
        "Use in Calibration (F7); a new series with other angles or order confirms the name.",
    )
