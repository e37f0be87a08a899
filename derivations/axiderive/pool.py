"""Tasks in worker processes: none outlives an interrupt, and a dead worker is an error, not a hang."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import TypeVar

from .exits import ENVIRONMENT, CommandError

Result = TypeVar("Result")


class WorkerError(CommandError):
    """A worker process died."""

    code = ENVIRONMENT


def run(function: Callable[..., Result], tasks: Sequence[tuple[object, ...]], jobs: int) -> Iterator[Result]:
    """`function(*task)` for every task, in order of completion; in this process for one job or one task."""
    if jobs == 1 or len(tasks) <= 1:
        yield from (function(*task) for task in tasks)
        return
    context = multiprocessing.get_context("spawn")
    executor = ProcessPoolExecutor(min(jobs, len(tasks)), mp_context=context, initializer=_end_with_parent)
    try:
        with _worker_environment():
            futures = [executor.submit(function, *task) for task in tasks]
        for future in as_completed(futures):
            yield future.result()
    except BrokenProcessPool as error:
        message = "a worker process died (out of memory?); finished profiles are kept, try again with --jobs 1"
        raise WorkerError(message) from error
    except BaseException:
        executor.shutdown(wait=False, cancel_futures=True)
        for process in multiprocessing.active_children():
            process.terminate()
        raise
    executor.shutdown()


@contextmanager
def _worker_environment() -> Iterator[None]:
    """Workers inherit a fixed hash seed and an ignored SIGINT: Ctrl-C is the parent's business alone."""
    seed = os.environ.get("PYTHONHASHSEED")
    os.environ["PYTHONHASHSEED"] = "0"
    in_main = threading.current_thread() is threading.main_thread()
    handler = signal.signal(signal.SIGINT, signal.SIG_IGN) if in_main else None
    try:
        yield
    finally:
        if in_main:
            signal.signal(signal.SIGINT, handler)
        if seed is None:
            del os.environ["PYTHONHASHSEED"]
        else:
            os.environ["PYTHONHASHSEED"] = seed


def _end_with_parent() -> None:
    """A killed parent cannot stop its workers, so they watch it."""
    parent = multiprocessing.parent_process()
    if parent is None:
        return

    def watch() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()
