"""A profile at given parameter values, as the quadrature sees it: pieces with derivatives, kinks, singular points."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, TypeAlias

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..profiles.profile import Profile
from . import rules

Number: TypeAlias = mp.mpf
Values = Mapping[Any, Any]


def number(value: sp.Expr) -> Number:
    """An exact number at the working precision; a number of mpmath is taken as it is."""
    if isinstance(value, mp.mpf):
        return value
    value = sp.sympify(value)
    if value.is_Rational:
        return mp.mpf(int(value.p)) / int(value.q)
    return value._to_mpmath(int(mp.mp.prec) + 20) + mp.mpf(0)


def concrete(expr: sp.Expr, values: Values) -> sp.Expr:
    """The sum of a polynomial profile written out for the degree at hand, with a symbol for each coefficient."""
    if nt.N not in values or not expr.has(sp.Sum):
        return expr
    spelled = expr.subs(nt.N, values[nt.N]).replace(sp.Sum, lambda *args: sp.Sum(*args).doit())
    found = spelled.xreplace({term: coefficient(int(term.indices[0])) for term in spelled.atoms(sp.Indexed)})
    # expanded, because the derivative of a sum leaves r in a denominator
    return found if found.has(sp.Integral) else sp.expand(found)


def coefficient(index: int) -> sp.Symbol:
    """The symbol that stands for A_index where the sum of a polynomial is written out."""
    return sp.Symbol(f"{nt.coefficients.label}_{index}", positive=True)


def numeric_symbols(values: Values) -> tuple[sp.Symbol, ...]:
    """The symbols among the keys, sorted by name."""
    return tuple(sorted((s for s in values if isinstance(s, sp.Symbol)), key=lambda s: str(s.name)))


@lru_cache(maxsize=2048)
def _compiled(expr: sp.Expr, arguments: tuple[sp.Symbol, ...]) -> Callable[..., Number]:
    function: Callable[..., Number] = sp.lambdify(arguments, expr, "mpmath")
    return function


@dataclass(frozen=True)
class Stretch:
    """One piece lo < s < hi of the profile with its derivatives and their singular points in the complex plane."""

    lo: Number
    hi: Number
    height: Callable[[Number], Number]
    slope: Callable[[Number], Number]
    bend: Callable[[Number], Number]
    """(s f')' = f' + s f''."""
    singular: tuple[complex, ...]
    bend_ball: Callable[[Any], Any]
    """The same in the arithmetic of Arb."""
    wavelength: float
    """Length over which an exponential, a wave or a high power changes by a factor or a radian; inf without any."""


@dataclass(frozen=True)
class Shape:
    """The profile up to a: what g, F, p and w are integrals of."""

    stretches: tuple[Stretch, ...]
    kinks: tuple[tuple[Number, Number], ...]
    """(b, jump of f' at b)."""
    powers: tuple[tuple[Number, Number], ...] = ()
    """(c, n) of every term where the whole profile is a sum of c r**n; empty elsewhere."""

    def height(self, s: Number) -> Number:
        """f(s), at a break by the stretch below it; `StopIteration` beyond the last one."""
        return next(piece for piece in self.stretches if s <= piece.hi).height(s)


def _singular_points(expr: sp.Expr, values: dict[sp.Symbol, sp.Expr]) -> tuple[complex, ...]:
    """Zeros in r of everything that is raised to a power other than a natural number."""
    points: set[complex] = set()
    for power in expr.atoms(sp.Pow):
        if power.exp.is_Integer and power.exp > 0 or not power.base.has(nt.r):
            continue
        exponent = power.exp.xreplace(values)
        if exponent.is_Integer and exponent >= 0:
            continue
        base = sp.Poly(power.base.xreplace(values), nt.r)
        points.update(complex(z) for z in base.nroots(n=20))
    return tuple(sorted(points, key=lambda z: (abs(z), z.real, z.imag)))


def _wavelength(expr: sp.Expr, values: dict[sp.Symbol, sp.Expr], end: Number) -> float:
    """Of an argument c*r the length 1/c, of c*r**2 the length 1/sqrt(9 c), of a high power r**n the length 2*a/n."""
    powers = [(p.base, p.exp.xreplace(values)) for p in expr.atoms(sp.Pow) if p.base.is_polynomial(nt.r)]
    degrees = [float(e * sp.degree(base, nt.r)) for base, e in powers if e.is_number and base.has(nt.r)]
    shortest = min((2 * float(end) / degree for degree in degrees if degree > 6), default=float("inf"))
    for term in expr.atoms(sp.sin, sp.cos, sp.exp):
        argument = term.args[0].xreplace(values)
        degree = sp.degree(argument, nt.r)
        if degree > 0:
            # a gaussian grows along the imaginary axis
            shortest = min(shortest, abs(float(sp.LC(argument, nt.r))) ** (-1 / int(degree)) / (1, 3)[degree == 2])
    return shortest


def _powers(expr: sp.Expr, bound: Callable[[sp.Expr], Callable[[Number], Number]]) -> tuple[tuple[Number, Number], ...]:
    """(c, n) of the terms c r**n; empty if one of them is something else."""
    found = []
    for term in sp.Add.make_args(sp.expand_power_base(expr)):
        factor, power = term.as_independent(nt.r, as_Add=False)
        base, exponent = power.as_base_exp()
        if base != nt.r or exponent.has(nt.r):
            return ()
        found.append((bound(factor)(mp.mpf(0)), bound(exponent)(mp.mpf(0))))
    return tuple(found)


@lru_cache(maxsize=1024)
def _pieces(profile: Profile) -> tuple[tuple[sp.Expr | None, sp.Expr, sp.Expr, sp.Expr], ...]:
    rows = []
    for piece in profile.pieces:
        slope = sp.diff(piece.expr, nt.r)
        rows.append((piece.upper, piece.expr, slope, slope + nt.r * sp.diff(slope, nt.r)))
    return tuple(rows)


def shape(profile: Profile, values: Values) -> Shape:
    """The profile at these parameter values up to r = a, at the working precision."""
    symbols = tuple(s for s in numeric_symbols(values) if s != nt.r)
    arguments = [number(values[s]) for s in symbols]
    exact = {s: sp.Float(str(v), 25) if isinstance(v := values[s], mp.mpf) else v for s in symbols}
    end = number(values[nt.a])

    def bound(expr: sp.Expr) -> Callable[[Number], Number]:
        f = _compiled(expr, (nt.r, *symbols))
        return lambda s: f(s, *arguments)

    def in_balls(expr: sp.Expr) -> Callable[[Any], Any]:
        return rules.bound(expr, nt.r, dict(zip(symbols, arguments, strict=True)))

    stretches: list[Stretch] = []
    kinks: list[tuple[Number, Number]] = []
    lo = mp.mpf(0)
    for upper, *exprs in _pieces(profile):
        exprs = [concrete(expr, values) for expr in exprs]
        height, slope, bend = exprs
        hi = end if upper is None else min(end, bound(upper)(mp.mpf(0)))
        points, period = _singular_points(bend, exact), _wavelength(height, exact, end)
        stretch = Stretch(lo, hi, bound(height), bound(slope), bound(bend), points, in_balls(bend), period)
        if stretches:
            kinks.append((lo, stretch.slope(lo) - stretches[-1].slope(lo)))
        stretches.append(stretch)
        lo = hi
        if hi == end:
            break
    pieces = _pieces(profile)
    powers = _powers(concrete(pieces[0][1], values), bound) if len(pieces) == 1 else ()
    return Shape(tuple(stretches), tuple(kinks), powers)
