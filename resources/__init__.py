"""What is data, not code.

devices
    One TOML file a device: port, frames or lines, scales, commands. ``docs/device-files.md``.
plans
    One TOML file a procedure.
"""
