"""What the program reads and does not compute.

plans/
    Calibration plans: which positions, how long, in which order.
devices/
    Device profiles: port settings, frame layout, scales, commands.

Read them by ``importlib.resources.files("resources")``, which works from the tree and from an
installed package alike.
"""
