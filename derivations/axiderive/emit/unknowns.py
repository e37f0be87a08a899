"""What the iteration of an inverse solves for where `places` does not say it, each as a formula with its value."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from .. import notation as nt
from ..abel import masters
from ..entry import Entry
from ..notation import a, k
from .graded.families import Family, family
from .graded.normal import LIMITS
from .naming import LEFT
from .printer import Printer
from .shorthand import with_kappa

T, X, END, LAST = (sp.Symbol(name, positive=True) for name in ("t_unknown", "x_unknown", "a_last", "x_last"))
NAMES = {T: "t", X: "x", END: "a_1", LAST: "x_1"}
BOTH = ("ad", "aF")
LOADS = {"ad": ("d", "g(a)", nt.d, "d"), "aF": ("F", rf"{LEFT['F']}(a)", nt.F, LEFT["F"])}
"""Quantity over the radius, its name there, the load, and its name."""
BY_LOGARITHM, BETWEEN = "by steps of its logarithm", "start between the powers of both ends"
SHARP = sp.Rational(3, 10)
"""First powers of a load next to an edge from which on the unknown has a bend; below it is another one."""


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


def _is(left: str, value: sp.Expr) -> Equation:
    return Equation(left, Printer(names=NAMES)(value), value)


def _load(suffix: str) -> Equation:
    _, left, load, right = LOADS[suffix]
    return Equation(left, right, load)


def unknowns(entries: Mapping[str, Entry]) -> Iterator[Unknown]:
    """Of a contact on the homogeneous half-space whose radius is not over an unknown of `places`."""
    profile = entries["d"].profile
    if nt.coefficients in profile.parameters:
        for suffix in BOTH:
            yield Unknown("a", (suffix,), "", (_load(suffix), _alone(entries, suffix)), BY_LOGARITHM)
    elif nt.wavelength in profile.parameters:
        (wave,) = entries["d"].cases[0].expr.atoms(masters.StruveH)
        yield Unknown("z", BOTH, "", (_is("z", wave.args[1]),), "on Taylor series of the load")
    elif profile.largest is not None:
        number, length = profile.largest.as_coeff_Mul()
        text = sp.sstr(number)
        last = Equation("a_1", rf"{text}\,{Printer()(length)}", sp.Rational(text) * length)
        yield Unknown("t", BOTH, "", (_is("a", END / (1 + T)), last), BETWEEN)


def smooth(start: sp.Expr) -> Unknown:
    """The radius itself, from a start at one length."""
    return Unknown("a", BOTH, "", (_is("a_0", start),), BY_LOGARITHM)


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


def graded_unknowns(entries: Mapping[str, Entry]) -> Iterator[Unknown]:
    """Of a compact contact on the graded half-space; none for a power law, whose inverse is closed."""
    own = family(entries["d"].profile)
    if own.power is not None:
        return
    profile = own.profile
    lengths = [*profile.parameters, *(symbol for symbol, _ in profile.abbreviations)]
    if own.has("gaussian"):
        yield _on_the_bump(lengths[-1])
    elif not own.root:
        yield smooth(next((sp.Rational(3, 2) * x for x in lengths if x in (nt.b, nt.wavelength)), sp.S.One))
    elif profile.truncated:
        yield from (_beyond(own, suffix) for suffix in BOTH)
    elif own.has("sphere"):
        yield from (_below(profile.chain[-1], suffix) for suffix in BOTH)
    else:
        yield from _across(own)


def _on_the_bump(s: sp.Expr) -> Unknown:
    """The share of the height of the bump, with that of the last radius moved to infinity."""
    unknown, share = _is("t", X / (1 - X / LAST)), _is("x", 1 - sp.exp(-(a**2) / s**2))
    last = _is("x_1", 1 - sp.exp(-(END**2) / s**2))
    return Unknown("t", BOTH, "", (unknown, share, last, Equation("g'(a_1)", "0", sp.S.Zero)))


def _powers(shape: str, suffix: str) -> tuple[sp.Expr, sp.Expr]:
    """With which powers of the root the load of a flat face begins and ends."""
    first, last = LIMITS[shape]
    begins = sp.Integer(int(float(first.removesuffix(" + k"))))
    return begins + k, sp.Integer(int(last)) + (1 + k if suffix == "aF" else 0)


def _beyond(own: Family, suffix: str) -> Unknown:
    """A radius beyond a flat face, over a length that grows like the load at both ends."""
    (term,) = own.terms
    first, last = _powers(term.shape, suffix)
    place = _is("a", own.profile.breaks[0] * sp.sqrt(1 + T**2))
    small = rf"k\ge {float(SHARP - 1):g}" if first == 1 + k else ""
    return Unknown("x", (suffix,), small, (_load(suffix), place, _bent(first, last)))


def _bent(first: sp.Expr, last: sp.Expr) -> Equation:
    """x**(1/first) below one and x**(1/last) beyond it, joined without a kink."""
    printer = Printer()
    if first == last:
        return _is("t", X ** (1 / first))
    value = sp.sqrt(sp.Max(X, 1) ** (2 / last) - 1 + first / last) * sp.Min(X, 1) ** (1 / first)
    far = rf"\max(x,1)^{{{printer.exponent(2 / last)}}}" if last != 2 else r"\max(x,1)"
    near = rf"\min(x,1)^{{{printer.exponent(1 / first)}}}"
    above, below = sp.fraction(sp.together(first / last - 1))
    share = printer(abs(above) if above.is_number else above)
    rest = share if below == 1 else rf"\frac{{{share}}}{{{printer(below)}}}"
    return Equation("t", rf"{near} \sqrt{{{far}{'-' if above.is_negative else '+'}{rest}}}", value)


def _below(end: sp.Expr, suffix: str) -> Unknown:
    """A radius below the one of a vertical flank, over a length that ends like the load there, for either sign of k."""
    tip = 2 if suffix == "ad" else 3 + k
    place = _is("a", end * T / sp.sqrt(1 + T**2))
    power = Printer(names=NAMES)(1 + T**tip)
    exponent = Printer().exponent(-k / tip)
    like = Equation("x", rf"\frac{{1-({power})^{{{exponent}}}}}{{k}}", (1 - (1 + T**tip) ** (-k / tip)) / k)
    return Unknown("x", (suffix,), "", (_load(suffix), place, like))


def _across(own: Family) -> Iterator[Unknown]:
    """Both sides of a break; what is found where the load bends at it is a power of the t of this row."""
    b, (end, *_) = own.profile.breaks[0], own.profile.parameters
    if own.has("tipped"):
        v = sp.atanh(a / end)
        like = Equation("x", rf"\frac{{1-\exp(-k {Printer()(v)})}}{{k}}", (1 - sp.exp(-k * v)) / k)
        yield Unknown("x", BOTH, f"a<{b}", (like,))
    yield Unknown("t", BOTH, f"a>{b}", (_is("a", b * sp.sqrt(1 + T**2)),))
