"""Work elsewhere: tasks in processes or by any executor, a user's text under limits, a call beside others.

None outlives an interrupt, and a dead worker is an error, not a hang.
"""

from __future__ import annotations

import contextlib
import gc
import importlib
import math
import multiprocessing
import os
import pickle
import platform
import resource
import signal
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future, ProcessPoolExecutor, as_completed
from contextlib import contextmanager
from functools import cache
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, Generic, TypeAlias, TypeVar

from ..exits import ENVIRONMENT, FAILED, USAGE, CommandError
from ..store.cache import digest
from ..store.sources import source_digest
from .work import installed

Result = TypeVar("Result")


class WorkerError(CommandError):
    """A worker died, or what runs the workers failed."""

    code = ENVIRONMENT


Jobs: TypeAlias = int | Executor
"""So many processes of this machine, or whatever runs the tasks, here or on other machines."""


def run(
    function: Callable[..., Result], tasks: Sequence[tuple[object, ...]], jobs: Jobs, *, ordered: bool = False
) -> Iterator[Result]:
    """`function(*task)` for every task, in order of completion or of the tasks; here for one job or one task.

    Raises
    ------
    WorkerError
        If a process died, or an executor failed: what a task raises is raised as it is.
    """
    if isinstance(jobs, Executor):
        yield from _gathered(jobs, engine(), function, tasks, ordered)
    elif jobs == 1 or len(tasks) <= 1:
        yield from (function(*task) for task in tasks)
    else:
        with _processes(min(jobs, len(tasks))) as executor:
            yield from _gathered(executor, "", function, tasks, ordered)


def _gathered(
    executor: Executor,
    made_of: str,
    function: Callable[..., Result],
    tasks: Sequence[tuple[object, ...]],
    ordered: bool,
) -> Iterator[Result]:
    """What comes back, to this process alone; an executor that knows how runs again what a lost worker had begun."""
    futures: list[Future[Result | Exception]] = []
    try:
        with _blamed(executor), _worker_environment():
            futures += [executor.submit(_answer, made_of, function, *task) for task in tasks]
        for future in futures if ordered else as_completed(futures):
            with _blamed(executor):
                answer = future.result()
            if isinstance(answer, Exception):
                raise answer
            yield answer
    except BaseException:
        for future in futures:
            future.cancel()
        raise


@contextmanager
def _blamed(executor: Executor) -> Iterator[None]:
    """What goes wrong in here is no error of a task, which comes back as an answer."""
    try:
        yield
    except Exception as error:
        said = f"{type(executor).__name__} failed, {type(error).__name__}: {error} (a worker out of memory?)"
        message = f"{said}; finished profiles are kept, the same command continues, and with --jobs 1 in one process"
        raise WorkerError(message) from error


_TURN = threading.RLock()
"""Threads of a worker take turns: the precision of mpmath and the notation are those of a process."""


def _answer(made_of: str, function: Callable[..., Result], *task: object) -> Result | Exception:
    """What a task gives or raises, in a worker; that of another engine would be stored as that of this one."""
    if made_of and engine() != made_of:
        message = f"axicontact on {platform.node()}, or what it stands on, is another; install the same on all machines"
        return WorkerError(message)
    try:
        with _TURN:
            return function(*task)
    except Exception as error:
        error.add_note(traceback.format_exc())
        return error


@cache
def engine() -> str:
    """Digest of all that derives here: the sources of engine and catalogue, the versions of the packages."""
    versions = [installed(name) for name in ("sympy", "mpmath", "python-flint", "numpy", "jinja2")]
    return digest([source_digest("axiderive", "axicontact"), versions])


@contextmanager
def workers(named: str, jobs: int) -> Iterator[Jobs]:
    """What runs the tasks of a command: so many processes, or the executor that a named callable returns.

    Raises
    ------
    CommandError
        If `named` is no `module:callable`, or the callable returns no executor.
    """
    if not named:
        yield jobs
        return
    module, _, name = named.partition(":")
    sys.path.append(str(Path.cwd()))  # where a command does not look for modules
    try:
        executor = getattr(importlib.import_module(module), name)()
        if not isinstance(executor, Executor):
            message = f"it returns {executor!r}"
            raise TypeError(message)
    except Exception as error:
        said = f"--executor {named!r} cannot be used, {type(error).__name__}: {error}"
        message = f"{said}; name a module, and a callable in it that returns a concurrent.futures.Executor"
        raise CommandError(message, USAGE) from error
    try:
        yield executor
    except BaseException:
        executor.shutdown(wait=False)
        raise
    executor.shutdown()


@contextmanager
def _processes(count: int) -> Iterator[Executor]:
    """An executor of processes, which an error or an interrupt ends."""
    context = multiprocessing.get_context("spawn")
    executor = ProcessPoolExecutor(count, mp_context=context, initializer=_end_with_parent)
    try:
        yield executor
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
    # a process of many threads, as a worker of others is, is not forked
    plain = sys.platform == "linux" and threading.current_thread() is threading.main_thread()
    context: Any = multiprocessing.get_context("fork" if plain else "spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(
        target=_work, args=(sender, function, arguments, hear is not None, seconds, megabytes), daemon=True
    )
    if (own := multiprocessing.current_process()).daemon:
        own.daemon = False  # as the workers of Dask are, who could start no process; this one ends before they go on
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
