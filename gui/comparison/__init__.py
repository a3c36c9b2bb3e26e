"""Gyros side by side: the comparison table of lab 6, a page of the tab Methods.

================  ==================================================================
page              `make_page`: puts everything together
presenter         files in, `ComparisonState` out
state             what the page shows
tables            the table with the best marked, and what is missing
side_view         the files and what their gyros are called
content_view      the table, doubts, export
================  ==================================================================
"""
