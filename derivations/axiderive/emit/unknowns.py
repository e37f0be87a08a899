"""What the iteration of an inverse solves for where `places` does not say it, each as a formula with its value."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from .. import notation as nt
from ..abel import masters
from ..entry import Entry
from ..notation import a
from .naming import LEFT
from .printer import Printer
from .shorthand import with_kappa

T, X, END, LAST = (sp.Symbol(name, positive=True) for name in ("t_unknown", "x_unknown", "a_last", "x_last"))
FIRST, JOINT, SHARE = (sp.Symbol(name, positive=True) for name in ("a_first", "t_joint", "y_unknown"))
LEADING, NEXT = (sp.Symbol(name, positive=True) for name in ("c_leading", "C_next"))
NAMES = {
    T: "t", X: "x", END: "a_1", LAST: "x_1", FIRST: "a_0", JOINT: "t_1", SHARE: "y", LEADING: "c", NEXT: "C",
}  # fmt: skip
BOTH = ("ad", "aF")
LOADS = {"ad": ("d", "g(a)", nt.d, "d"), "aF": ("F", rf"{LEFT['F']}(a)", nt.F, LEFT["F"])}
"""Quantity over the radius, its name there, the load, and its name."""
BY_LOGARITHM, BETWEEN = "by steps of its logarithm", "start between the powers of both ends"


@dataclass(frozen=True)
class Equation:
    """left = right; what both are worth, for a sum over its terms the least of these."""

    left: str
    right: str
    value: sp.Expr


@dataclass(frozen=True)
class Unknown:
    """The letter that is solved for, from which loads, in which range, and what it stands for."""

    letter: str
    suffixes: tuple[str, ...]
    small: str
    equations: tuple[Equation, ...]
    remark: str = ""
    half: bool = False


def is_worth(left: str, value: sp.Expr) -> Equation:
    return Equation(left, Printer(names=NAMES)(value), value)


def load_of(suffix: str) -> Equation:
    _, left, load, right = LOADS[suffix]
    return Equation(left, right, load)


def unknowns(entries: Mapping[str, Entry]) -> Iterator[Unknown]:
    """Of a contact on the homogeneous half-space whose radius is not over an unknown of `places`."""
    profile = entries["d"].profile
    if nt.coefficients in profile.parameters:
        for suffix in BOTH:
            yield Unknown("a", (suffix,), "", (load_of(suffix), _alone(entries, suffix)), BY_LOGARITHM)
    elif nt.wavelength in profile.parameters:
        (wave,) = entries["d"].cases[0].expr.atoms(masters.StruveH)
        yield Unknown("z", BOTH, "", (is_worth("z", wave.args[1]),), "on Taylor series of the load")
    elif profile.largest is not None:
        number, length = profile.largest.as_coeff_Mul()
        text = sp.sstr(number)
        last = Equation("a_1", rf"{text}\,{Printer()(length)}", sp.Rational(text) * length)
        yield Unknown("t", BOTH, "", (is_worth("a", END / (1 + T)), last), BETWEEN)


def smooth(start: sp.Expr) -> Unknown:
    """The radius itself, from a start at one length."""
    return Unknown("a", BOTH, "", (is_worth("a_0", start),), BY_LOGARITHM)


def _alone(entries: Mapping[str, Entry], suffix: str) -> Equation:
    """The radius at which the first term of a sum would do alone."""
    quantity, _, load, _ = LOADS[suffix]
    whole = entries[quantity].cases[0].expr
    (series,) = whole.atoms(sp.Sum)
    term = whole.subs(series, series.function)
    degree = sp.cancel(a * sp.diff(term, a) / term)
    share = load / term.subs(a, 1)
    short = with_kappa(share)
    fraction = Printer(names=short.names)(short.expr)
    right = rf"\min_{{j}} \Bigl({fraction}\Bigr)^{{{Printer().exponent(1 / degree)}}}"
    return Equation("a_0", right, share ** (1 / degree))
