"""The scripted demonstration: the real window plays whole sessions on the simulated rig.

========= ==========================================================================
file      what
========= ==========================================================================
scenes    `SCENES`: every part, its module, and which pictures of the pages it makes
playing   `demonstrate`: opens the window and plays parts one after another
stage     the window as the parts handle it
pictures  `renew`: the pictures of the documentation, each part in a window of its own
operating a part without a tab: tour, keys, preferences, distance view, messages
========= ==========================================================================

What is played stands with each tab, in its ``demo`` module.
"""
