"""Which procedure, and how well, before anything is measured.

bench
    `Bench`: the sensor, the rig and the laboratory's statements.
design
    `predict`: uncertainty of each parameter from the design matrix of a plan and the noise.
catalogue
    `METHODS`: what each method gives, what it needs, and its model.
propose
    `propose`: plans for the sensor and the rig at hand; plans with positions dropped or added.
unseen
    `unseen`: what a plan cannot see, in words.
"""
