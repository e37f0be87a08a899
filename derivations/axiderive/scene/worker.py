"""Work on a text of the user's in a process of its own, with limits of time and memory."""

from __future__ import annotations

import contextlib
import gc
import math
import multiprocessing
import os
import resource
import signal
import sys
import time
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any, TypeVar

from ..exits import FAILED, CommandError

Result = TypeVar("Result")
SECONDS = 60
"""Of processor time: a busy machine does not make a derivation too long."""
PATIENCE = 5
"""How much longer it may take by the clock."""
MEGABYTES = 2048


class LimitError(CommandError):
    """The work took more time or memory than it may."""

    code = FAILED


def limited(
    function: Callable[..., Result],
    *arguments: object,
    hear: Callable[[Any], None] | None = None,
    seconds: float = SECONDS,
    megabytes: int = MEGABYTES,
) -> Result:
    """`function(*arguments)` in a fresh process.

    With `hear` the function gets one more argument, a callable; what it is called with
    in the process is what `hear` is called with here, while the process goes on.

    Raises
    ------
    LimitError
        If it takes too long, too much memory, or dies.
    CommandError
        Whatever the function itself raises, with its message.
    """
    context: Any = multiprocessing.get_context("fork" if sys.platform == "linux" else "spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(
        target=_work, args=(sender, function, arguments, hear is not None, seconds, megabytes), daemon=True
    )
    process.start()
    sender.close()
    try:
        stopped = f"stopped after {seconds:g} s; name parts of the expression, lower its powers, or use fewer breaks"
        end = time.monotonic() + PATIENCE * seconds
        kind: str = "heard"
        value: Any = None
        try:
            while kind == "heard":
                if not receiver.poll(max(end - time.monotonic(), 0.0)):
                    raise LimitError(stopped)
                kind, value = receiver.recv()
                if kind == "heard" and hear is not None:
                    hear(value)
        except EOFError:
            process.join()
            if process.exitcode == -signal.SIGXCPU:
                raise LimitError(stopped) from None
            message = f"the process died (more than {megabytes} MB?); use a shorter expression or fewer breaks"
            raise LimitError(message) from None
    finally:
        # with what it has begun beside itself
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        if process.is_alive():
            process.kill()
        process.join()
        receiver.close()
    if kind == "error":
        message, code = value
        raise CommandError(message, code)
    result: Result = value
    return result


def _work(
    sender: Connection,
    function: Callable[..., Any],
    arguments: tuple[object, ...],
    heard: bool,
    seconds: float,
    megabytes: int,
) -> None:
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    os.setpgid(0, 0)
    _limit(resource.RLIMIT_AS, megabytes * 2**20)
    _limit(resource.RLIMIT_CPU, math.ceil(seconds))
    # the process ends with its answer: collecting cost it 15 % of a derivation
    gc.disable()
    try:
        if heard:
            arguments = (*arguments, lambda value: sender.send(("heard", value)))
        answer: tuple[str, Any] = ("value", function(*arguments))
    except CommandError as error:
        answer = ("error", (str(error), error.code))
    except MemoryError:
        answer = ("error", (f"needs more than {megabytes} MB; use a shorter expression or fewer breaks", FAILED))
    except RecursionError:
        answer = ("error", ("is nested too deeply to be derived; name its parts", FAILED))
    except Exception as error:
        reason = f"{type(error).__name__}: {str(error)[:300]}"
        answer = ("error", (f"cannot be derived ({reason}); write it in another form or report it", FAILED))
    sender.send(answer)
    sender.close()
    os._exit(0)


def _limit(kind: int, size: int) -> None:
    _, hard = resource.getrlimit(kind)
    resource.setrlimit(kind, (size if hard == resource.RLIM_INFINITY else min(size, hard), hard))
