"""Certificates: the form, the preview, the printed page.

==================  =============================================================
html                a certificate as sections of HTML
parts               parts of a results page as HTML: tables, matrices, pictures
log_plot_view       deviations over averaging times, drawn on paper
pdf                 `Paper`: the sections laid out in pages, number on every sheet
cutting             where the end of a page may cut a text
draft               what is typed, and what it makes of the results
limits              limits as they are typed
issuing             work on files in a worker: number, twin, PDF, HTML
keeping             the laboratory's file
state               everything the view shows
scene               the state put together from its parts
texts               words of the tab
presenter           clicks in, `CertificateState` out
view                form left, pages right
order_view          customer, item, surroundings
limits_view         limits, decision rule, printed parts
laboratory_view     laboratory and standards
register_view       issued certificates
preview_view        the pages, one at a time
text_form_view      a form of texts
tab                 the tab put together
demo                its part of the demonstration
==================  =============================================================
"""
