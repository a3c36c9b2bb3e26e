"""Durable writing: whole files or nothing, and lines of growing files whole or not at all."""

import contextlib
import errno
import os
from collections.abc import Generator
from pathlib import Path
from typing import BinaryIO

from core.errors import StorageError


def write_text_atomic(path: Path, text: str, *, encoding: str = "utf-8") -> None:
    """Replace `path` by `text`; line ends are written as they stand in it.

    Raises
    ------
    StorageError
        It could not be written; what stood there before is untouched.
    """
    write_bytes_atomic(path, text.encode(encoding))


def write_bytes_atomic(path: Path, content: bytes) -> None:
    """Replace `path` by `content`, durable when the function returns.

    Raises
    ------
    StorageError
        It could not be written; what stood there before is untouched.
    """
    with atomic_file(path) as file:
        file.write(content)


@contextlib.contextmanager
def atomic_file(path: Path) -> Generator[BinaryIO, None, None]:
    """Open a file that replaces `path` once the block has ended well, for what comes in pieces.

    Raises
    ------
    StorageError
        It could not be written; what stood there before is untouched.
    """
    # The process id keeps two programs that save the same file out of each other's draft.
    draft = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        with draft.open("wb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        draft.replace(path)
        sync_folder(path.parent)
    except OSError as error:
        raise not_stored(path, error, "what stood there before is untouched") from error
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


def make_folder(folder: Path) -> None:
    """Make a folder with those above it; one that is there already is as good.

    Raises
    ------
    StorageError
        It cannot be made.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(f"{folder}: cannot be made ({error.strerror})") from error


def append_durable(handle: int, content: bytes) -> None:
    """Append to an open file, durable when the function returns.

    Raises
    ------
    OSError
        It could not be written; the part that got through has been taken back.
    """
    before = os.fstat(handle).st_size
    try:
        rest = memoryview(content)
        while rest:
            rest = rest[os.write(handle, rest) :]
        os.fsync(handle)
    except OSError:
        with contextlib.suppress(OSError):
            os.ftruncate(handle, before)
        raise


def sync_folder(folder: Path) -> None:
    """Make a new name in `folder` durable; without it a power cut can take the whole file."""
    if os.name == "nt":  # Windows cannot open a folder; NTFS journals the name itself.
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    except OSError as error:
        # Some network folders know no such thing; their server keeps the name.
        if error.errno not in (errno.EINVAL, errno.ENOTSUP):
            raise
    finally:
        os.close(handle)


def not_stored(path: Path, error: OSError, saved: str) -> StorageError:
    """Return the error that tells what failed, what is safe and what to do."""
    return StorageError(f"{path}: cannot be written ({error.strerror or error}); {saved}; {REMEDY}")


REMEDY = "free some disk space or choose another folder, then save again"
