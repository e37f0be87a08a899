"""Rows that say what an inverse is solved for in formulas: each side against what the iteration makes of it."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from typing import Any

import mpmath as mp
import sympy as sp

from ... import notation as nt
from ...proof.evaluate import evaluate
from ...proof.shape import coefficient, number
from ..unknowns import END, FIRST, JOINT, LAST, LEADING, NAMES, NEXT, SHARE, Equation, T, Unknown, X
from .compare import DIGITS
from .evaluations import Stated, differs
from .exact import Entries, functions
from .grammar import read
from .left import bound
from .points import points_of
from .printed import Printed, Values, holds, named

DRAWN = {T: ("0.75", "1.9"), X: ("0.65", "2.3"), LAST: ("0.9", "0.8"), JOINT: ("0.7", "1.3"), SHARE: ("0.8", "1.7"),
         LEADING: ("1.1", "0.7"), NEXT: ("0.9", "2.1")}  # fmt: skip
"""Values of what is solved for, on both sides of a bend."""
LOADS = {"ad": ("d", nt.d), "aF": ("F", nt.F)}
SHARES = (sp.Rational(3, 10), sp.Rational(4, 5))
"""Loads over that of the radius of a point, and so of the last one."""
SHARPER = sp.Rational(-17, 20)
"""A grading next to which a bend would be sharp."""


def chosen(one: Stated, unknowns: Iterable[Unknown]) -> Unknown | None:
    """The unknown of a row: for the same inverses in the same range."""
    suffixes = tuple(key.rpartition(".")[2] for key in one.keys)
    return next((own for own in unknowns if (own.suffixes, own.small) == (suffixes, one.small)), None)


def equations_differ(one: Stated, own: Unknown, entries: Entries) -> bool:
    """Whether an equation is missing, or one of its sides is not worth what it has to be."""
    statements = read(one.tex)
    if len(statements) != len(own.equations):
        return True
    met = False
    quantity, load = LOADS[own.suffixes[-1]]
    places = points_of(entries[quantity], "formula", entries, 1, 7)
    gradings = ({}, {nt.k: SHARPER}) if "k" in one.small else ({},)
    for (case, values), side, grading in itertools.product(places, range(2), gradings):
        known = values | grading | {symbol: sp.Rational(texts[side]) for symbol, texts in DRAWN.items()}
        known |= {FIRST: values[nt.a] / 2, END: values[nt.a]}
        known |= {load: SHARES[side] * evaluate(case.expr, known, 2 * DIGITS)}
        with mp.workdps(2 * DIGITS):
            env = named(known) | {name: number(known[symbol]) for symbol, name in NAMES.items()}
            env |= Printed(entries, entries).kappa | functions(entries, known)
            if not holds(one.small, env):
                continue
            met = True
            for statement, equation in zip(statements, own.equations, strict=True):
                want = _worth(equation, known)
                if differs(statement.members, env, bound(_name(equation), want, env), want):
                    return True
    return not met


def _name(equation: Equation) -> str:
    """The left side as the grammar reads it, a function at its place in brackets."""
    function, _, place = equation.left.replace(r"\mathrm N", "N").replace("{N}", "N").partition("(")
    return f"{function}({place}" if place else read(function)[0].members[0].name


def _worth(equation: Equation, values: Values) -> Any:
    terms = [equation.value]
    if equation.value.has(nt.j):
        indices = range(1, int(values[nt.N]) + 1)
        terms = [equation.value.replace(nt.coefficients[nt.j], coefficient(i)).subs(nt.j, i) for i in indices]
    return min(evaluate(term, values, DIGITS) for term in terms)
