"""SymPy's own integrate on one integral of the corpus, in a process that is killed when its time is up.

Times and limits are seconds of the processor, so that they do not depend on
what else the machine is doing.
"""

from __future__ import annotations

import multiprocessing
import signal
import time
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import TYPE_CHECKING

import mpmath as mp
import sympy as sp

if TYPE_CHECKING:
    from .corpus import Integral

DIGITS = 25


@dataclass(frozen=True)
class Attempt:
    """What came of it: ok, WRONG, unevaluated, timeout or error, and the processor seconds of the call."""

    verdict: str
    seconds: float


def integrate(integral: Integral, limit: float, required: int) -> Attempt:
    """`sp.integrate(integrand, (v, lo, hi), conds="none")` with positive symbols, given `limit` seconds."""
    context = multiprocessing.get_context("spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_attempt, args=(integral, limit, sender), daemon=True)
    process.start()
    sender.close()
    try:
        return _judge(integral, required, *receiver.recv())
    except EOFError:
        process.join()
        return Attempt("timeout" if process.exitcode == -signal.SIGPROF else "error", limit)
    finally:
        process.kill()
        process.join()


def _attempt(integral: Integral, limit: float, sender: Connection) -> None:
    variable = integral.symbols[integral.variable]
    limits = (integral.read(text) for text in integral.limits)
    integrand = integral.read(integral.integrand)
    signal.setitimer(signal.ITIMER_PROF, limit)  # the default action of its signal is to end the process
    start = time.process_time()
    try:
        result = sp.integrate(integrand, (variable, *limits), conds="none")
    except (ArithmeticError, AttributeError, NotImplementedError, RecursionError, TypeError, ValueError) as error:
        sender.send((time.process_time() - start, "error", repr(error)))
        return
    elapsed = time.process_time() - start
    if result.has(sp.Integral):
        sender.send((elapsed, "unevaluated", ""))
        return
    point = {integral.symbols[name]: sp.Rational(text) for name, text in integral.point.items()}
    number = sp.N(result.subs(point), DIGITS)
    sender.send((elapsed, "value", (str(sp.re(number)), str(sp.im(number)))))


def _judge(integral: Integral, required: int, seconds: float, outcome: str, text: tuple[str, str] | str) -> Attempt:
    if outcome != "value":
        return Attempt(outcome, seconds)
    with mp.workdps(2 * DIGITS):
        reference = mp.mpf(integral.reference)
        try:
            error = abs(mp.mpc(*map(mp.mpf, text)) - reference)
        except ValueError:  # nan, zoo or a symbol that was left over
            return Attempt("WRONG", seconds)
        right = error <= mp.mpf(10) ** -required * abs(reference)
    return Attempt("ok" if right else "WRONG", seconds)
