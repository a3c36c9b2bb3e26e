"""The page Gyrocompass: heading and drift of a gyro on a level base, and how long to average.

page.py          the page put together
presenter.py     clicks in, `CompassState` out
state.py         everything that the page shows
working.py       the work of a job: reading, finding north, the advice
findings.py      what was found -> tables of the right-hand side
side_view.py     what the operator decides
content_view.py  compass above, uncertainty against averaging time below
compass_view.py  the compass with the wedge of the heading's uncertainty
"""
