"""The elastic constants against the equations of equilibrium: waves of load, and the point force for h_N."""

from __future__ import annotations

import random
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.evaluate import evaluate
from ..oracle.half_space import body_compliance, h_N
from ..oracle.shape import Number, Values, number
from .comparison import Comparison, Evidence, Rows, residual

LOST = 2


def check(own: Comparison, suffix: str) -> Evidence:
    """An entry at random exact points."""
    entry, rows = own.entries[suffix], Rows()
    draw = random.Random(own.seed)
    with mp.workdps(own.digits + 15):
        for _ in range(own.points):
            values = _point(entry, draw)
            got = evaluate(entry.cases[0].expr, values, own.digits)
            rows.append((values, residual(got, _wanted(entry, values, own.digits))))
    loaded = "point force on the graded half-space" if nt.k in entry.parameters else "waves of load on two half-spaces"
    return own.judge(suffix, f"{loaded}, equations of equilibrium", rows, lost=LOST)


def _point(entry: Entry, draw: random.Random) -> Values:
    """Poisson ratios between -1 and 1/2, exponents between -1 and 1 but for 0, moduli and lengths about 1."""
    values: dict[Any, Any] = {}
    for symbol in entry.parameters:
        if symbol in (nt.nu, nt.nu_1, nt.nu_2):
            values[symbol] = sp.Rational(draw.randint(-999, 499), 1000)
        elif symbol == nt.k:
            values[symbol] = sp.Rational(draw.choice((-1, 1)) * draw.randint(1, 999), 1000)
        else:
            values[symbol] = sp.Rational(draw.randint(1, 9999), 1000)
    if nt.k in entry.parameters:
        values |= {symbol: expr.subs(values) for symbol, expr in entry.profile.abbreviations}
    return values


def _wanted(entry: Entry, values: Values, digits: int) -> Number:
    if nt.k not in entry.parameters:
        bodies = [(number(values[E]), number(values[nu])) for E, nu in ((nt.young_1, nt.nu_1), (nt.young_2, nt.nu_2))]
        return 1 / mp.fsum(body_compliance(entry.suffix, E, nu, digits + 5) for E, nu in bodies)
    factor = h_N(number(values[nt.k]), number(values[nt.nu]), digits + 5)
    if entry.suffix == "h_N":
        return factor
    return evaluate(entry.definition.rhs, {**values, nt.h_N: factor}, digits)
