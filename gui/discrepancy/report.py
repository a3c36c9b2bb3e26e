"""The whole story as sections of HTML: for a browser, and laid out on paper as PDF."""

from html import escape
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from core.arrays import FloatArray
from core.discrepancy.result import Step
from core.records.atomic import write_text_atomic
from gui.certificate.html import whole_html
from gui.certificate.parts import note_html, symbols, table_html
from gui.certificate.pdf import Paper
from gui.discrepancy.cards import following_of, grade_of
from gui.discrepancy.ladder_rows import place_words, rungs_of
from gui.discrepancy.paper_view import cause_picture, ladder_picture, plot_picture
from gui.discrepancy.picture import picture_of, where_of
from gui.discrepancy.words import (
    effect_words,
    numbers_of,
    p_words,
    plain_words,
    regressor_words,
    summary_words,
    verdict_words,
)
from gui.discrepancy.working import Story, all_added
from gui.widgets.number_text import fixed, significant
from gui.widgets.states import TableState


def write_report(story: Story, path: Path) -> None:
    """Write the story as HTML, or as PDF where the name ends so.

    Raises
    ------
    StorageError
        The file could not be written; an older one is left as it was.
    """
    pieces, title = sections_of(story), title_of(story)
    if path.suffix.lower() == ".pdf":
        Paper(pieces, title).save(path)
    else:
        write_text_atomic(path, whole_html(pieces, title))


def title_of(story: Story) -> str:
    """What stands at the foot of every page."""
    template = QCoreApplication.translate("Discrepancy", "Model vs data: {device}")
    return template.format(device=story.run.device)


def sections_of(story: Story) -> tuple[str, ...]:
    """The story in pieces, none of which should be cut by the end of a page.

    What was found and not yet added is told too: the report closes the gap as far as it can be.
    """
    whole = all_added(story)
    told = whole.told
    rows = QCoreApplication.translate("Discrepancy", "{count} rows of {channels}, {files}").format(
        count=len(story.run),
        channels=", ".join(told.channels),
        files=", ".join(path.name for path in story.paths),
    )
    pieces = [
        f"<h1>{escape(title_of(story))}</h1><p>{escape(rows)}</p>"
        f"<h2>{escape(verdict_words(told.verdict))}</h2><p>{escape(summary_words(told))}</p>"
    ]
    rungs = rungs_of(whole)
    if rungs:
        heading = QCoreApplication.translate("Discrepancy", "The ladder")
        pieces.append(f"<h2>{escape(heading)}</h2><p>{ladder_picture(rungs)}</p>{_ladder(whole)}")
        pieces += _plots(whole)
    pieces += [_step(number, step, story.seconds) for number, step in enumerate(told.steps, 1)]
    pieces.append(_where(whole))
    pieces.append(_following(whole))
    pieces += [table_html(table) for table in grade_of(told)]
    notes = (*story.run.notes, *told.notes)
    pieces.append("".join(note_html(note) for note in notes))
    return tuple(filter(None, pieces))


def _ladder(story: Story) -> str:
    told = story.told
    header = (
        QCoreApplication.translate("Discrepancy", "model"),
        QCoreApplication.translate("Discrepancy", "gap"),
        QCoreApplication.translate("Discrepancy", "held out"),
        "χ²/ν",
        QCoreApplication.translate("Discrepancy", "rms, {unit}").format(unit=told.unit),
    )
    plain = (
        QCoreApplication.translate("Discrepancy", "Plain model"),
        fixed(told.before.gap, 2),
        fixed(told.held_out_before, 2),
        significant(told.before.chi2_red, 3),
        significant(told.before.rms, 3),
    )
    rows = [plain]
    for step in told.steps:
        held = step.held_out_gap_after
        rows.append(
            (
                f"+ {step.name}",
                fixed(step.gap_after, 2),
                fixed(held, 2) if held == held else "",
                significant(step.after.chi2_red, 3),
                significant(step.after.rms, 3),
            )
        )
    equation = QCoreApplication.translate(
        "Discrepancy", "gap: rms of the whitened residuals; 1 is the noise floor, {size} {unit} rms"
    ).format(size=significant(told.noise.sigma, 3), unit=told.unit)
    return table_html(TableState("", equation, header, tuple(rows)))


def _plots(story: Story) -> list[str]:
    """The most significant regressor before, and the same after."""
    before = where_of(story, after=False)
    if not before:
        return []
    pieces: list[str] = []
    first = before[0]
    for after in (False, True) if story.told.steps else (False,):
        for one in where_of(story, after=after):
            if one.regressor == first.regressor:
                picture = picture_of(
                    story, one, first.shown, after=after, again=None, candidate=None
                )
                heading = (
                    QCoreApplication.translate("Discrepancy", "Residual with the effects added")
                    if after
                    else QCoreApplication.translate("Discrepancy", "Residual of the plain model")
                )
                pieces.append(
                    f"<h3>{escape(heading)}</h3><p>{escape(picture.title)}</p>"
                    f"<p>{plot_picture(picture)}</p>"
                )
    return pieces


def _step(number: int, step: Step, seconds: FloatArray) -> str:
    lines = [escape(plain_words(step.plain))]
    if step.equation:
        lines.append(f"<i>U + {symbols(escape(step.equation))}</i>")
    lines += [escape(words) for words in numbers_of(step.parameters, seconds)]
    template = QCoreApplication.translate(
        "Discrepancy", "evidence {evidence} nats, probability {share} among the names, {p}"
    )
    lines.append(
        escape(
            template.format(
                evidence=fixed(step.evidence, 1),
                share=fixed(step.probability, 2),
                p=p_words(step.p_value),
            )
        )
    )
    if step.indistinguishable_from:
        template = QCoreApplication.translate("Discrepancy", "Cannot be told from: {names}")
        names = ", ".join(effect_words(each) for each in step.indistinguishable_from)
        lines.append(f"<b>{escape(template.format(names=names))}</b>")
    lines.append(escape(step.advice))
    return (
        f"<h2>{number}. {escape(step.name)}</h2>"
        f'<table cellspacing="0" cellpadding="6"><tr><td valign="top">'
        f"{cause_picture(step.effect, step.name)}</td><td>{'<br/>'.join(lines)}</td></tr></table>"
    )


def _where(story: Story) -> str:
    header = (
        QCoreApplication.translate("Discrepancy", "regressor"),
        QCoreApplication.translate("Discrepancy", "before"),
        QCoreApplication.translate("Discrepancy", "largest"),
        QCoreApplication.translate("Discrepancy", "after"),
    )
    later = {one.regressor: one for one in where_of(story, after=True)}
    rows = tuple(
        (
            regressor_words(one.regressor),
            p_words(one.p_value),
            place_words(one),
            p_words(later[one.regressor].p_value) if one.regressor in later else "",
        )
        for one in where_of(story, after=False)
    )
    if not rows:
        return ""
    title = QCoreApplication.translate("Discrepancy", "Where the residual has structure")
    equation = QCoreApplication.translate(
        "Discrepancy", "p adjusted for all regressors together (Westfall and Young)"
    )
    return table_html(TableState(title, equation, header, rows, 4))


def _following(story: Story) -> str:
    cards = following_of(story)
    if not cards:
        return ""
    header = (
        QCoreApplication.translate("Discrepancy", "series"),
        QCoreApplication.translate("Discrepancy", "why"),
        QCoreApplication.translate("Discrepancy", "effort"),
        QCoreApplication.translate("Discrepancy", "decides, %"),
    )
    rows = tuple((c.title, c.why, c.facts, fixed(100 * c.chance, 0)) for c in cards)
    title = QCoreApplication.translate("Discrepancy", "What to measure next")
    return table_html(TableState(title, "", header, rows, 3))
