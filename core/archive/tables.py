"""The tables of the index, its schema version, its migrations."""

from collections.abc import Mapping

from sqlalchemy import (
    BigInteger,
    Column,
    Float,
    ForeignKey,
    Index,
    Integer,
    MetaData,
    String,
    Table,
    Text,
    UniqueConstraint,
)

VERSION = 2
MIGRATIONS: Mapping[int, tuple[str, ...]] = {
    # Degrees of freedom of uncertainties; the files that have them are read again.
    1: (
        "ALTER TABLE archive_quantities ADD COLUMN dof FLOAT",
        "UPDATE archive_entries SET signature = '' WHERE kind IN ('calibration', 'noise')",
        "UPDATE archive_folders SET mtime = 0",
    ),
}
"""By the version that they lead from: statements that make the next one of it."""

TABLES = MetaData()

META = Table(
    "archive_meta",
    TABLES,
    Column("key", String(40), primary_key=True),
    Column("value", Text, nullable=False),
)
"""One row, ``schema``: the version."""

PLACES = Table(
    "archive_places",
    TABLES,
    Column("id", String(40), primary_key=True),
    Column("name", Text, nullable=False),
    Column("path", Text, nullable=False),
    Column("seen", Text, nullable=False),
)
"""Folders that are archived; whoever writes to one touches its row first, and so waits its turn."""

FOLDERS = Table(
    "archive_folders",
    TABLES,
    Column(
        "place", String(40), ForeignKey("archive_places.id", ondelete="CASCADE"), primary_key=True
    ),
    Column("path", Text, primary_key=True),
    Column("mtime", BigInteger, nullable=False),
)
"""Times of the folders at the last look."""

ENTRIES = Table(
    "archive_entries",
    TABLES,
    Column("id", Integer, primary_key=True),
    Column(
        "place", String(40), ForeignKey("archive_places.id", ondelete="CASCADE"), nullable=False
    ),
    Column("folder", Text, nullable=False),
    Column("path", Text, nullable=False),
    Column("part", Text, nullable=False),
    Column("signature", Text, nullable=False),
    Column("kind", String(20), nullable=False),
    Column("serial", Text, nullable=False),
    Column("sensor", String(20), nullable=False),
    Column("what", Text, nullable=False),
    Column("operator", Text, nullable=False),
    Column("profile", Text, nullable=False),
    Column("measured", String(30), nullable=False),
    Column("temperature_c", Float),
    Column("verdict", String(20), nullable=False),
    Column("count", Integer, nullable=False),
    Column("remark", Text, nullable=False),
    Column("sha256", String(64), nullable=False),
    Column("words", Text, nullable=False),
    UniqueConstraint("place", "path", "part", name="archive_entries_once"),
    Index("archive_entries_measured", "measured"),
    Index("archive_entries_serial", "serial"),
    Index("archive_entries_folder", "place", "folder"),
)

QUANTITIES = Table(
    "archive_quantities",
    TABLES,
    Column(
        "entry", Integer, ForeignKey("archive_entries.id", ondelete="CASCADE"), primary_key=True
    ),
    Column("channel", Text, primary_key=True),
    Column("name", Text, primary_key=True),
    Column("symbol", Text, nullable=False),
    Column("unit", Text, nullable=False),
    Column("value", Float, nullable=False),
    Column("u", Float),
    Column("dof", Float),
    Column("rank", Integer, nullable=False),
)
