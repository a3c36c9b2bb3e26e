"""The version that is written into every result (tests keep it equal to pyproject.toml)."""

VERSION = "0.1.0"
SOFTWARE = f"CalRig {VERSION}"
