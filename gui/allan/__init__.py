"""The Allan tab: noise of records at rest.

texts.py  numbers and tables as texts, for the tab and for ``calrig allan``
"""
