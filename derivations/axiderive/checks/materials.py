"""The elastic constants against the equations of equilibrium: waves of load, and the point force for h_N.

What is no property of a half-space is compared with its definition.
"""

from __future__ import annotations

import random
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.evaluate import evaluate
from ..oracle.half_space import body_compliance, h_N, transverse_modulus
from ..oracle.shape import Number, Values, number
from .comparison import Comparison, Evidence, Rows, residual

LOST = 2
BODIES = "waves of load on two half-spaces, equations of equilibrium"
POINT = "point force on the graded half-space, equations of equilibrium"
COMPARED = {
    "E_star": BODIES, "G_star": BODIES, "H": POINT, "h_N": POINT,
    "E_ti": "waves of load on a transversely isotropic half-space, equations of equilibrium",
}  # fmt: skip
MODERATE = {nt.C_11: 2, nt.C_33: 2, nt.C_44: 1}
"""Elastic constants are drawn about these: where the rates of decay are far apart a deep half-space costs digits."""


def check(own: Comparison, suffix: str) -> Evidence:
    """An entry at random exact points."""
    entry, rows = own.entries[suffix], Rows()
    draw = random.Random(own.seed)
    with mp.workdps(own.digits + 15):
        for _ in range(own.points):
            values = _point(entry, draw)
            got = evaluate(entry.cases[0].expr, values, own.digits)
            rows.append((values, residual(got, _wanted(entry, values, own.digits))))
    return own.judge(suffix, COMPARED.get(suffix, "definition in mpmath"), rows, lost=LOST)


def _point(entry: Entry, draw: random.Random) -> Values:
    """Poisson ratios between -1 and 1/2, exponents between -1 and 1 but for 0, moduli and lengths about 1.

    C_13 is less than the root of C_11 C_33, and a cup is wider than the ball in it.
    """
    values: dict[Any, Any] = {}
    for symbol in entry.parameters:
        if symbol in (nt.nu, nt.nu_1, nt.nu_2):
            values[symbol] = sp.Rational(draw.randint(-999, 499), 1000)
        elif symbol in MODERATE:
            values[symbol] = MODERATE[symbol] * sp.Rational(draw.randint(500, 1500), 1000)
        elif symbol == nt.C_13:
            values[symbol] = min(values[nt.C_11], values[nt.C_33]) * sp.Rational(draw.randint(-900, 900), 1000)
        elif symbol == nt.radius_2:
            values[symbol] = values[nt.radius_1] * sp.Rational(draw.choice((-1, 1)) * draw.randint(1001, 9999), 1000)
        elif symbol == nt.k:
            values[symbol] = sp.Rational(draw.choice((-1, 1)) * draw.randint(1, 999), 1000)
        else:
            values[symbol] = sp.Rational(draw.randint(1, 9999), 1000)
    if nt.k in entry.parameters:
        values |= {symbol: expr.subs(values) for symbol, expr in entry.profile.abbreviations}
    return values


def _wanted(entry: Entry, values: Values, digits: int) -> Number:
    if entry.suffix == "E_ti":
        C_11, C_33, C_13, C_44 = (number(values[constant]) for constant in entry.parameters)
        return transverse_modulus(C_11, C_33, C_13, C_44, digits + 5)
    if nt.k not in entry.parameters and nt.young_1 not in entry.parameters:
        power = entry.definition.lhs.as_base_exp()[1]
        return evaluate(entry.definition.rhs, values, digits) ** (mp.mpf(1) / int(power))
    if nt.k not in entry.parameters:
        bodies = [(number(values[E]), number(values[nu])) for E, nu in ((nt.young_1, nt.nu_1), (nt.young_2, nt.nu_2))]
        return 1 / mp.fsum(body_compliance(entry.suffix, E, nu, digits + 5) for E, nu in bodies)
    factor = h_N(number(values[nt.k]), number(values[nt.nu]), digits + 5)
    if entry.suffix == "h_N":
        return factor
    return evaluate(entry.definition.rhs, {**values, nt.h_N: factor}, digits)
