"""Signals, pseudo-terminals and limits are those of Linux and macOS; readers are tried anywhere."""

import sys

collect_ignore = ["test_fault_matrix.py"] if sys.platform == "win32" else []
