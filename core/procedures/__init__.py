"""One file a method of the sources, and the walk through a plan that all of them share.

measuring
    `Measuring`: choose, settle, accumulate, check, accept; by hand or hands-free.
walk
    The walk made from a plan and the channels of a device.
recognise
    Does the mean fit the chosen position, or another one; `recognise_angles`: by its own angle.
calibration, triad
    `Calibration`: what a procedure hands to exports and reports; three sensors as one `Triad`.
added, compensation
    Effects beyond the plain model in a calibration; taking them out where the unit is used.
physical
    Samples in units of their input, by a calibration.
dividing_head
    Accelerometers on the dividing head: (1.8), (2.4) and any other set of positions.
attitude
    Pitch and roll from specific force: (2.9), (2.10) in well-conditioned forms.
rate_table
    Gyros on the rate table: scale factor and zero, (3.4) to (3.6); with `characteristic` (how
    straight they are), `rate_faults` (what went wrong at the table), `rate_recognition` (while it
    is measured), `rate_notes`, and `rate_calibration` (the result for exports).
g_sensitivity, rate_and_head, two_files
    Gyros on the head, (3.7) to (3.9); the whole model (3.3) from both; (3.10) and whether its two
    files are of one unit. `earth`: when the rotation of the Earth matters.
accuracy
    Pitch and roll against set angles, Tables 2.5 and 2.6; with `accuracy_plan`, `accuracy_sources`,
    `set_angles`, `angle_errors`, `accuracy_notes`, and `conformity`: limits and the decision rule.
comparison
    Gyros side by side: the table of lab 6.
six_position, thermal
    Triads in six orthogonal positions; sensors over temperature (source 002).
fourier
    One accelerometer turned through all angles (source 000).
drift
    Drift after switching on, as a table for a microcontroller (source 003).
gyrocompass, north_seeking
    Heading by a turned gyro, and how long to average for it; `slow_noise`: noise with memory.
prediction
    Which procedure, and how well, before anything is measured.
propagation
    Uncertainty of what is computed from fitted parameters.
"""
