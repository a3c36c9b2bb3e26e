"""The tab Model vs data: where they disagree, which effect is missing, how the gap shrinks.

================  ==================================================================
tab               the tab put together
presenter         clicks in, `StoryState` out
state             everything that the tab shows
working           the work of a job: reading, finding, adding; needs no Qt
record_steps      the steps of a record, added one after another
follow_up         plans of what to measure next: opened, or kept
handed            a story -> effects for the tabs that calibrate
ladder_rows       a story -> rungs of the ladder, regressors
overview          a story -> gap before and after, how sure each name is, what to do next
certainty         how sure the name of a step is
cards             a story -> proposals, next measurements, what the plan can show
rerun             the found model on the simulated bench, beside the data
scene             buttons, the judgement, the tab without a run
picture           a story -> both plots
words             names of regressors and verdicts
plan_grade        what a plan can show before anything is measured; needs no Qt
grade_view        effects as a list of lights
trial             sealed cases for practice, of four kinds, and the score; needs no Qt
trial_case        one sealed case
trial_rows        cases on the head, on the rate table, of a gyro at rest
trial_record      cases that are records
trial_presenter   a case looked at, named, opened, scored
trial_state       everything that the page of trials shows
trial_view        that page
exporting         report, results, model with the effects
report            the whole story as HTML and PDF
paper_view        ladder and plots as pictures on paper
view              ladder left, plots middle, findings right, actions below
ladder_view       rungs with their bars against the noise floor
plots_view        measured and simulated; the residual with its band
overview_view     verdict, gap, names and what to do next, above the findings
findings_view     candidates, next measurements, what the plan can show
candidate_view    one candidate with its picture and its evidence
cause_view        a small picture of each kind of cause
demo              pictures for the documentation
================  ==================================================================
"""
