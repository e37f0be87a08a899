"""SymPy's own integrate on one integral of the corpus, in a process that is killed when its time is up."""

from __future__ import annotations

import multiprocessing
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
    """What came of it: ok, WRONG, unevaluated, timeout or error, and the seconds of the call."""

    verdict: str
    seconds: float


def integrate(integral: Integral, limit: float, required: int) -> Attempt:
    """`sp.integrate(integrand, (v, lo, hi), conds="none")` with positive symbols, given `limit` seconds."""
    context = multiprocessing.get_context("spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_attempt, args=(integral, sender), daemon=True)
    process.start()
    sender.close()
    try:
        receiver.recv()  # the imports are done: the time of the call starts here
        return _judge(integral, required, *receiver.recv()) if receiver.poll(limit) else Attempt("timeout", limit)
    except EOFError:
        return Attempt("error", limit)
    finally:
        process.kill()
        process.join()


def _attempt(integral: Integral, sender: Connection) -> None:
    variable = integral.symbols[integral.variable]
    limits = (integral.read(text) for text in integral.limits)
    integrand = integral.read(integral.integrand)
    sender.send("ready")
    start = time.perf_counter()
    try:
        result = sp.integrate(integrand, (variable, *limits), conds="none")
    except (ArithmeticError, AttributeError, NotImplementedError, RecursionError, TypeError, ValueError) as error:
        sender.send((time.perf_counter() - start, "error", repr(error)))
        return
    elapsed = time.perf_counter() - start
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
