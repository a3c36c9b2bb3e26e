"""What the rig must do to the sensor.

orientation
    Mounts on the dividing head, head angle, base plate, tilter -> specific force and Earth rate.
plan
    A procedure as data: `Plan`, read from ``resources/plans/*.toml``.
plan_text
    A plan as the text of such a file.
"""
