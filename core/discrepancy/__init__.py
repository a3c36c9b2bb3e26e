"""Model vs data: where they disagree, which effect is missing, and how the gap shrinks.

The ladder is immutable: `Ladder.of(run, settings)` is the plain model, `ladder.found()` has all
steps that the search finds, `ladder.with_effect(identifier)` has one more, `ladder.without_last()`
one less; each has its `explanation`. `explain(run, settings)` is the explanation of what is found.

ladder
    `Ladder`, `explain`.
result, to_json
    `Explanation` and its parts; the form that ``calrig explain --json`` gives.
settings
    What the operator may choose, and what is taken where nothing is stated.
problem, smooth
    A run with its plain model; regressors without their rounding.
components, reml, floor
    Parts of the noise, their sizes from replicates, the noise floor.
space, evidence, bank, curves, features, relabels, slots
    Whitened residual space; evidence; all effects, unknown curves, single features that no name
    describes, relabelled rows in it; states.
views
    The same under all sizes that the noise of few rows may have.
search, engine, sets
    Names compete; the rounds of a search and its threshold; what cannot be told apart.
two_levels, weighed
    A bias between two levels; what was found against what stands in no catalogue.
gaps, locate, power, steps, verdict
    How far, where, what could have been seen, rungs with their numbers, the verdict in words.
record
    `explain_record`: the same for a long record, one row a sample.
record_problem, record_floor, record_engine, record_telegraph
    Means of blocks, their noise, the search on them, paths between two levels.
record_search, record_refined, record_shapes, record_sets, record_spread
    Sets of names, pairs and all; their best shapes; columns made once; what is tied with what;
    uncertainties with the noise and the shapes as they could be.
record_facts, record_spectrum, record_doubts
    Faults of the data; lines and noise terms at the full rate; lines and levels that are neither.
record_followups, record_advise
    What record to make next.
rivals, followups, tailored, outcomes, advise
    What is tied; series that can be done, and rows chosen for what is tied; how they would come
    out; what to measure next.
"""
