"""The tab Methods: the other calibration methods, one page each.

tab.py   the tab put together; `PAGES` names the pages
view.py  what a page is; list of the pages left, the chosen one beside it
demo.py, comparison_demo.py
         their parts of the demonstration
"""
