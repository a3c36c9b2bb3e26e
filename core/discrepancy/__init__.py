"""Model vs data: where they disagree, which effect is missing, and how the gap shrinks.

The ladder is immutable: `Ladder.of(run, settings)` is the plain model, `ladder.found()` has all
steps that the search finds, `ladder.with_effect(identifier)` has one more, `ladder.without_last()`
one less; each has its `explanation`. `explain(run, settings)` is the explanation of what is found.

result
    `Explanation` and its parts.
to_json
    The form that ``calrig explain --json`` gives.
"""
