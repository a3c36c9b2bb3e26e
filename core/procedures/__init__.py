"""One file a method of the sources, and the walk through a plan that all of them share.

measuring
    `Measuring`: choose, settle, accumulate, check, accept; by hand or hands-free.
walk
    The walk made from a plan and the channels of a device.
recognise
    Does the mean fit the chosen position, or another one.
calibration, triad
    `Calibration`: what a procedure hands to exports and reports; three sensors as one `Triad`.
dividing_head
    Accelerometers on the dividing head: (1.8), (2.4) and any other set of positions.
attitude
    Pitch and roll from specific force: (2.9), (2.10) in well-conditioned forms.
"""
