"""The page Fourier tumble: one accelerometer through a full turn of the dividing head.

page.py            the page put together
presenter.py       clicks in, `TumbleState` out
state.py           everything that the page shows
findings.py        a study -> tables of the right-hand side
pictures.py        a study -> residuals over the turn, and bars
side_view.py       what the operator decides
content_view.py    the two pictures
polar_view.py      residuals round the turn
harmonics_view.py  bars with their thresholds
"""
