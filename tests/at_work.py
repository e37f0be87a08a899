"""What workers of tests are given to do, apart from all that a test imports: each worker is a new process."""

from __future__ import annotations

import os


def numbered(number: int) -> tuple[str | None, int, int]:
    """The seed of hashes, the process, and the number."""
    return os.environ.get("PYTHONHASHSEED"), os.getpid(), number


def ended(number: int) -> None:
    """The process ends without a word."""
    os._exit(9)
