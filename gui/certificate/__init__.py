"""Certificates: the form, the preview, the printed page.

=========  ==================================================================
html       a certificate with its results page as sections of HTML
parts      parts of a results page as HTML: tables, matrices, pictures
pdf        the sections laid out on paper, with number and page on every sheet
=========  ==================================================================
"""
