"""A call that is worked on beside the rest, in a process of its own, where there is a second processor."""

from __future__ import annotations

import os
import pickle
import signal
import sys
from collections.abc import Callable
from typing import Generic, TypeVar

Result = TypeVar("Result")


class Beside(Generic[Result]):
    """`function(*arguments)`, begun now and asked for later; the result is plain data."""

    def __init__(self, function: Callable[..., Result], *arguments: object) -> None:
        self._call: Callable[[], Result] = lambda: function(*arguments)
        self._process = 0
        if sys.platform == "linux" and len(os.sched_getaffinity(0)) > 1:
            self._reader, writer = os.pipe()
            self._process = os.fork()
            if not self._process:
                self._work(writer)
            os.close(writer)

    def _work(self, writer: int) -> None:
        """In the other process, which ends here; one that fails leaves nothing."""
        try:
            os.close(self._reader)
            with os.fdopen(writer, "wb") as file:
                file.write(pickle.dumps(self._call()))
        finally:
            os._exit(0)

    def result(self) -> Result:
        """The result; what failed beside is called again here, for its error."""
        data = b""
        if self._process:
            with os.fdopen(os.dup(self._reader), "rb") as file:
                data = file.read()
            self._end()
        if not data:
            return self._call()
        found: Result = pickle.loads(data)  # from a process of ours
        return found

    def _end(self) -> None:
        process, self._process = self._process, 0
        os.close(self._reader)
        os.kill(process, signal.SIGKILL)
        os.waitpid(process, 0)

    def __del__(self) -> None:
        if self._process:
            self._end()
