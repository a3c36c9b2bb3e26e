"""Calibration certificates: what they state, and where they are kept.

laboratory
    What does not change from one certificate to the next: `Laboratory`, `Standard`; its file.
laboratory_file
    ``laboratory.toml``: the same written by hand, and its commented template.
certificate
    What one certificate states (ISO/IEC 17025:2017, 7.8): `Certificate`, and its JSON twin.
measured
    `Measured`: results of any kind, calibration or check, with all that must be told of them.
conformity_json
    A statement of conformity as JSON and back.
order_file
    Customer, item, surroundings and limits as a text file, for work without the window.
limits
    `judge_stated`: the numbers of the results against limits, by a stated rule.
register
    The folder of the certificates: the next number, taken once and for all by writing the twin;
    the list of them; withdrawal.
"""
