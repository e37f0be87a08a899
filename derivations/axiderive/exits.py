"""Exit codes of the command line, and the error that carries one."""

from __future__ import annotations

FAILED = 1
USAGE = 2
ENVIRONMENT = 3
INCOMPLETE = 4
INTERRUPTED = 130


class CommandError(Exception):
    """Ends a command: the message says what to do, `code` is the exit code."""

    code = FAILED

    def __init__(self, message: str, code: int | None = None) -> None:
        super().__init__(message)
        self.code = self.code if code is None else code
