"""What the analysis tabs share.

tab.py        a tab, or a page of one, that needs neither ports nor rig
page.py       a page of the tab Methods: form, picture, findings, export
library.py    records of a list, read and worked out together in a worker, the newest wish last
presenter.py  a tab with such a list: adding, choosing, removing; its rows, what is refused
records.py    which record is chosen when one goes; what is told of those that cannot be used
curves.py     a curve of a plot, and its name above it
export.py     the formats under the findings
"""
