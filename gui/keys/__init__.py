"""The sheet of keys, F1: read from the buttons, menus and widgets of the window as they are.

================  ==================================================================
sheet             `KeySheet`: what can be pressed where, collected from the window
own_keys          keys that widgets answer themselves, without a button or a menu
key_html          the sheet as HTML, for the screen and for paper
view              its window
showing           opens it, and writes it as PDF
================  ==================================================================
"""
