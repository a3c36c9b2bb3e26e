"""The page Which procedure?: plans for a sensor and a rig, and how well they would do.

page.py       the page put together
presenter.py  clicks in, `AdvisorState` out
state.py      everything that the page shows
working.py    the work of a job: comparing plans, predicting one
words.py      parameters and steps in words
findings.py   a prediction -> table and doubts of the right-hand side
side_view.py  the sensor and the rig
plan_view.py  the plans to choose from, and the steps of the chosen one
"""
