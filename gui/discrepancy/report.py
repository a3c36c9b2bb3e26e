"""The whole story as sections of HTML: for a browser, and laid out on paper as PDF."""

from datetime import datetime
from html import escape
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from core.arrays import FloatArray
from core.discrepancy.result import Step
from core.records.atomic import write_text_atomic
from core.version import SOFTWARE
from gui.certificate.html import whole_html
from gui.certificate.parts import note_html, symbols, table_html
from gui.certificate.pdf import Paper
from gui.discrepancy.cards import following_of, grade_of
from gui.discrepancy.ladder_rows import place_words, rungs_of
from gui.discrepancy.overview import after_search, found_of, gaps_of, measured_words, notes_of
from gui.discrepancy.paper_view import cause_picture, ladder_picture, plot_picture
from gui.discrepancy.picture import picture_of, where_of
from gui.discrepancy.state import NextCard
from gui.discrepancy.words import (
    effect_words,
    numbers_of,
    p_words,
    plain_words,
    printed,
    regressor_words,
    summary_words,
    unit_words,
    verdict_words,
)
from gui.discrepancy.working import Story, all_added
from gui.languages.shown import shown
from gui.widgets.number_text import fixed, significant
from gui.widgets.states import TableState

_SETTLED = ("adequate", "explained", "not_enough_data")
"""Verdicts after which a reader has nothing to measure."""


def write_report(story: Story, path: Path) -> None:
    """Write the story as HTML, or as PDF where the name ends so.

    Raises
    ------
    StorageError
        The file could not be written; an older one is left as it was.
    """
    pieces, title = sections_of(story), shown(title_of(story))
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
    files = ", ".join(path.name for path in story.paths)
    rows = ", ".join((measured_words(story), *told.channels, files))
    made = f"{datetime.now():%Y-%m-%d %H:%M}, {SOFTWARE}"
    pieces = [
        f"<h1>{_t(title_of(story))}</h1><p>{_t(rows)}<br/>{_t(made)}</p>"
        f"<h2>{_t(verdict_words(told.verdict))}</h2>{_glance(whole)}"
    ]
    rungs = rungs_of(whole)
    if rungs:
        heading = QCoreApplication.translate("Discrepancy", "The ladder")
        pieces.append(f"<h2>{_t(heading)}</h2><p>{ladder_picture(rungs)}</p>{_ladder(whole)}")
        pieces += _plots(whole)
    pieces += [_step(number, step, story.seconds) for number, step in enumerate(told.steps, 1)]
    pieces.append(_where(whole))
    pieces.append(_following(whole))
    pieces += [table_html(table) for table in grade_of(told)]
    pieces.append("".join(note_html(note) for note in notes_of(whole, "")))
    return tuple(filter(None, pieces))


def _glance(story: Story) -> str:
    """The gap, how sure each name is, what to do next."""
    told = story.told
    floors = QCoreApplication.translate("Discrepancy", "times the noise floor; 1 is the best")
    gaps = gaps_of(story)
    lines = [f"<b>{_t(gaps)}</b> {_t(floors)}"] if gaps else []
    if not told.steps:
        lines.append(_t(summary_words(told)))
    lines += [f"<b>{_t(row.name)}</b>, {_t(row.certainty)}" for row in found_of(story)]
    if told.verdict not in _SETTLED:
        lines.append(f"→ <b>{_t(after_search(story, told))}</b>")
    return f"<p>{'<br/>'.join(lines)}</p>"


def _t(text: str) -> str:
    """Words in the language of the window, for HTML."""
    return escape(printed(shown(text)))


def _ladder(story: Story) -> str:
    told = story.told
    header = (
        QCoreApplication.translate("Discrepancy", "model"),
        QCoreApplication.translate("Discrepancy", "gap"),
        QCoreApplication.translate("Discrepancy", "held out"),
        "χ²/ν",
        QCoreApplication.translate("Discrepancy", "rms, {unit}").format(unit=unit_words(told.unit)),
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
                f"+ {shown(step.name)}",
                fixed(step.gap_after, 2),
                fixed(held, 2) if held == held else "",
                significant(step.after.chi2_red, 3),
                significant(step.after.rms, 3),
            )
        )
    equation = QCoreApplication.translate(
        "Discrepancy",
        "gap: rms of the whitened residuals; 1 (dotted) is the noise floor, {size} {unit} rms; the"
        " stroke: the gap of rows that were left out of the fit",
    ).format(size=significant(told.noise.sigma, 3), unit=unit_words(told.unit))
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
                    f"<h3>{_t(heading)}</h3><p>{_t(picture.title)}</p>"
                    f"<p>{plot_picture(picture)}</p>"
                )
    legend = QCoreApplication.translate(
        "Discrepancy",
        "Points: rows. Line: their smooth structure. Band: where all means of a right model stay"
        " (95 %); those that leave it are diamonds, and their stretches are tinted.",
    )
    pieces[-1] += f"<p><i>{_t(legend)}</i></p>"
    return pieces


def _step(number: int, step: Step, seconds: FloatArray) -> str:
    lines = [_t(plain_words(step.plain))]
    if step.equation:
        lines.append(f"<i>U + {symbols(_t(step.equation))}</i>")
    lines += [_t(words) for words in numbers_of(step.parameters, seconds)]
    template = QCoreApplication.translate(
        "Discrepancy", "evidence {evidence} nats, probability {share} among the names, {p}"
    )
    lines.append(
        _t(
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
        lines.append(f"<b>{_t(template.format(names=names))}</b>")
    if step.advice:
        lines.append(_t(f"{step.advice[:1].upper()}{step.advice[1:]}."))
    return (
        f"<h2>{number}. {_t(step.name)}</h2>"
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
    rows = tuple(
        (c.title, " ".join((c.why, _parts(c))).strip(), c.facts, fixed(100 * c.chance, 0))
        for c in cards
    )
    title = QCoreApplication.translate("Discrepancy", "What to measure next")
    return table_html(TableState(title, "", header, rows, 3))


def _parts(card: NextCard) -> str:
    """What is done one after another."""
    return "; ".join(f"{number}. {part}" for number, part in enumerate(card.parts, 1))
