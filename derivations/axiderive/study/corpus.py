"""The corpus of Abel integrals: what the engine answers, and what SymPy's integrate does beside it.

The integrals are data (tests/data/cas_corpus.json): text of the integrand, limits, sample point and a reference value,
and the profile whose reduced quantities contain the integral.  Times and limits are seconds of the processor, so that
they do not depend on what else the machine is doing.
"""

from __future__ import annotations

import json
import re
import statistics
import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import mpmath as mp
import sympy as sp
from sympy.core.cache import clear_cache

from ..abel.form import Chain, Form, Order
from ..abel.masters import MASTERS
from ..abel.moments import outside_kernel
from ..abel.reduce import Reduced, parse
from ..build.pool import Jobs, LimitError, limited, run
from ..build.work import project_root
from ..exits import ENVIRONMENT, FAILED, CommandError
from ..notation import a
from ..profiles.profile import Piece
from ..store.index import nearest
from . import LIMIT

REQUIRED = 15
"""Digits from which an answer counts as right."""
WORKING, HELD = 50, 30
"""Digits that are carried, and that the references have."""


@dataclass(frozen=True)
class Integral:
    """One definite integral as one would type it, and the reduced quantities that answer it."""

    id: str
    profile: str
    quantity: str
    kind: str
    """elem, ell (elliptic), sp (special function), Li2, or open: neither elementary nor elliptic."""
    integrand: str
    variable: str
    limits: list[str]
    positive: list[str]
    facts: list[list[str]]
    """[b, a] says b < a."""
    point: dict[str, str]
    reference: str
    pieces: list[list[Any]]
    """Upper end, null for none, and f."""
    grading: str
    answer: str

    @cached_property
    def symbols(self) -> dict[str, sp.Symbol]:
        """Those of its texts, all of them positive."""
        names = {*self.positive, self.variable, "a", "r", "b", "k"}
        return {name: sp.Symbol(name, positive=True) for name in sorted(names)}

    def read(self, text: str) -> sp.Expr:
        """Text of the corpus as an expression in positive symbols."""
        return sp.sympify(text, locals=self.symbols)

    def chain(self) -> Chain:
        """The lengths that the facts compare, in ascending order; the sample point fulfils the facts."""
        compared = {name for low, high in self.facts if {low, high} <= set(self.point) for name in (low, high)}
        ascending = sorted(compared | {"a"}, key=lambda name: sp.Rational(self.point.get(name, 0)))
        return tuple(self.symbols[name] for name in ascending)


@lru_cache(maxsize=1)
def corpus() -> dict[str, Integral]:
    """All integrals by id.

    Raises
    ------
    CommandError
        If the data file is missing, as in an installed package without the tests.
    """
    path = project_root() / "tests" / "data" / "cas_corpus.json"
    try:
        rows = json.loads(path.read_text())["integrals"]
    except FileNotFoundError as error:
        message = f"{path} does not exist; the corpus comes with the source checkout, run the command there"
        raise CommandError(message, ENVIRONMENT) from error
    return {row["id"]: Integral(**row) for row in rows}


def solve(name: str) -> sp.Expr:
    """The closed form of one integral, from the reduced quantities of its profile."""
    integral = corpus()[name]
    pieces = [Piece(integral.read(upper) if upper else None, integral.read(text)) for upper, text in integral.pieces]
    reduced = parse(pieces, integral.read(integral.grading))
    known = _quantities(integral.answer, reduced, Order(integral.chain()))
    return sp.sympify(integral.answer, locals=integral.symbols | known)


def _quantities(answer: str, reduced: Reduced, order: Order) -> dict[str, sp.Expr]:
    """What the names in an answer stand for."""
    forms = {
        "g": lambda: reduced.depth(order),
        "F": lambda: reduced.force(order),
        "p": lambda: reduced.pressure(order),
        "w": lambda: reduced.displacement(order),
        "punch": lambda: outside_kernel(reduced.k),
    }
    words = set(re.findall(r"[A-Za-z]\w*", answer))
    known = {name: _closed(name, derive()) for name, derive in forms.items() if name in words}
    if "dg" in words:
        known["dg"] = sp.diff(_closed("g", reduced.depth(order)), a)
    return known


def _closed(name: str, form: Form | None) -> sp.Expr:
    if form is None:
        message = f"the engine has no closed form of {name}; take the answer from other quantities"
        raise ValueError(message)
    return form.expr()


def value(name: str, expr: sp.Expr) -> mp.mpf:
    """An answer at the sample point, with 50 digits carried."""
    integral = corpus()[name]
    symbols = [integral.symbols[s] for s in integral.point]
    own = {master.__name__: master.numeric for master in MASTERS}
    with mp.workdps(WORKING):
        return mp.mpmathify(sp.lambdify(symbols, expr, [own, "mpmath"])(*map(mp.mpf, integral.point.values())))


def agreement(name: str, number: mp.mpf) -> float:
    """Digits in which a number agrees with the reference, at most those that the reference has."""
    with mp.workdps(WORKING):
        reference = mp.mpf(corpus()[name].reference)
        error = abs(number - reference) / abs(reference)
        return float(min(HELD, -mp.log10(error))) if error else float(HELD)


@dataclass(frozen=True)
class Attempt:
    """What came of it: ok, WRONG, unevaluated, timeout or error, and the processor seconds of the call."""

    verdict: str
    seconds: float


def integrate(integral: Integral, limit: float) -> Attempt:
    """`sp.integrate(integrand, (v, lo, hi), conds="none")` with positive symbols, in a process of `limit` seconds."""
    try:
        return limited(_attempt, integral, seconds=limit)
    except LimitError:
        return Attempt("timeout", limit)


def _attempt(integral: Integral) -> Attempt:
    clear_cache()
    limits = (integral.read(text) for text in integral.limits)
    integrand = integral.read(integral.integrand)
    start = time.process_time()
    try:
        result = sp.integrate(integrand, (integral.symbols[integral.variable], *limits), conds="none")
    except Exception:  # of whatever kind: it has no answer
        return Attempt("error", time.process_time() - start)
    seconds = time.process_time() - start
    if result.has(sp.Integral):
        return Attempt("unevaluated", seconds)
    point = {integral.symbols[name]: sp.Rational(text) for name, text in integral.point.items()}
    parts = sp.N(result.subs(point), WORKING).as_real_imag()
    try:
        with mp.workdps(WORKING):
            right = agreement(integral.id, mp.mpc(*(mp.mpf(str(part)) for part in parts))) >= REQUIRED
    except ValueError:  # nan, zoo or a symbol that was left over
        right = False
    return Attempt("ok" if right else "WRONG", seconds)


def compare(ids: Sequence[str], *, sympy: bool = False, limit: float = LIMIT, jobs: Jobs = 1) -> int:
    """Print one row per integral and the totals; the exit code is that of the engine's own answers."""
    integrals = corpus()
    for name in ids:
        if name not in integrals:
            raise nearest(name, "integral", integrals)
    right, seconds, peers = 0, [], []
    asked = list(ids or integrals)
    found = run(_attempted, [(name, sympy, limit) for name in asked], jobs, ordered=True)
    for name, (elapsed, digits, peer) in zip(asked, found, strict=True):
        right += digits >= REQUIRED
        seconds.append(elapsed)
        row = f"{name:18s} {integrals[name].kind:5s} {elapsed * 1e3:8.1f} ms {digits:5.1f} digits"
        if peer:
            peers.append(peer)
            row += f"   SymPy {peers[-1].seconds:8.3f} s  {peers[-1].verdict}"
        print(row, flush=True)
    print(f"engine: {right} of {len(seconds)} within {REQUIRED} digits; {_times(seconds)}")
    if peers:
        print(f"SymPy {sp.__version__}: {_verdicts(peers)}; {_times([peer.seconds for peer in peers])}")
    return 0 if right == len(seconds) else FAILED


def _attempted(name: str, sympy: bool, limit: float) -> tuple[float, float, Attempt | None]:
    """Seconds and digits of the engine, and what SymPy does, if that is asked for."""
    return *_timed(name), integrate(corpus()[name], limit) if sympy else None


def _timed(name: str) -> tuple[float, float]:
    """Processor seconds for the answer with SymPy's caches empty, and its digits."""
    clear_cache()
    start = time.process_time()
    answer = solve(name)
    elapsed = time.process_time() - start
    number = value(name, answer)
    return elapsed, agreement(name, number)


def _times(seconds: list[float]) -> str:
    return f"total {sum(seconds):.3f} s, median {statistics.median(seconds) * 1e3:.1f} ms, longest {max(seconds):.3f} s"


def _verdicts(attempts: list[Attempt]) -> str:
    counted = [attempt.verdict for attempt in attempts]
    return ", ".join(f"{counted.count(verdict)} {verdict}" for verdict in dict.fromkeys(["ok", "WRONG", *counted]))
