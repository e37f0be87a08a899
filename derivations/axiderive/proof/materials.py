"""The elastic constants against what defines them, h_N by the point force on the graded half-space."""

from __future__ import annotations

import random
from collections.abc import Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.materials import PROFILE as PROFILE
from .domain import NotProvedError
from .evaluate import evaluate
from .evidence import Evidence, judge, residual
from .graded_half_space import h_N
from .shape import Number, Values, number
from .statement import Rule

LOST = 2


class Materials:
    """The entries, and the definitions they solve."""

    def __init__(self, entries: Mapping[str, Entry]) -> None:
        self.entries = entries

    def reciprocal(self, suffix: str) -> list[str]:
        """1/modulus is the sum over the bodies, an identity of rational functions."""
        entry = self.entries[suffix]
        return [self._equal(entry.cases[0].expr * entry.definition.rhs, sp.S.One, f"{suffix} solves its definition")]

    def graded(self) -> list[str]:
        entry, factor = self.entries["H"], self.entries["h_N"].cases[0].expr
        return [self._equal(entry.cases[0].expr, entry.definition.rhs.subs(nt.h_N, factor), "H by its definition")]

    def factor(self) -> list[str]:
        message = "h_N is compared with a solution of the equations of equilibrium, which is no exact statement"
        raise NotProvedError(message)

    @staticmethod
    def _equal(left: sp.Expr, right: sp.Expr, statement: str) -> str:
        if sp.cancel(left / right) != 1:
            message = f"{statement}: not shown"
            raise NotProvedError(message)
        return statement


RULES: dict[str, Rule] = {
    "E_star": ((), lambda proof: proof.reciprocal("E_star")),
    "G_star": ((), lambda proof: proof.reciprocal("G_star")),
    "H": (("h_N",), Materials.graded),
    "h_N": ((), Materials.factor),
}


def check(entries: Mapping[str, Entry], suffix: str, *, digits: int = 40, points: int = 6, seed: int = 0) -> Evidence:
    """An entry at random exact points."""
    entry, rows = entries[suffix], list[tuple[Values, Number]]()
    draw = random.Random(seed)
    with mp.workdps(digits + 15):
        for _ in range(points):
            values = _point(entry, draw)
            got = evaluate(entry.cases[0].expr, values, digits)
            rows.append((values, residual(got, _wanted(entry, values, digits))))
    compared = "point force on the graded half-space, equations of equilibrium" if _graded(entry) else "its definition"
    return judge(entry.key, compared, rows, seed=seed, extremes=0, digits=digits, required=digits - LOST)


def _graded(entry: Entry) -> bool:
    return nt.k in entry.parameters


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
    return values | {symbol: expr.subs(values) for symbol, expr in entry.profile.abbreviations if _graded(entry)}


def _wanted(entry: Entry, values: Values, digits: int) -> Number:
    if not _graded(entry):
        # the definition reads 1/modulus = a sum over the bodies
        return 1 / evaluate(entry.definition.rhs, values, digits)
    factor = h_N(number(values[nt.k]), number(values[nt.nu]), digits + 5)
    if entry.suffix == "h_N":
        return factor
    return evaluate(entry.definition.rhs, {**values, nt.h_N: factor}, digits)
