"""A product taken apart for print: sign, number, factors turned to be positive, one root for all fractional powers."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from .. import notation as nt

Factor = tuple[sp.Expr, sp.Expr]
"""Base and exponent."""

LOADS = {nt.d, nt.F, nt.P}
"""A sum in which one of these stands beside lengths is read as what exceeds them: d - 2 h."""
LARGEST_RADICAND = 999
"""Numbers beyond this are not gathered under a root: sqrt[7](35 F/(192 A E)) is read, 352947000000**(1/7) is not."""


@dataclass(frozen=True)
class Root:
    """The `index`-th root of number * factors, all exponents integers."""

    index: int
    number: sp.Rational
    factors: tuple[Factor, ...]


@dataclass(frozen=True)
class Product:
    """sign * number * factors * root; number > 0, every factor with an integer or symbolic exponent."""

    sign: int
    number: sp.Rational
    factors: tuple[Factor, ...]
    root: Root | None = None


def taken_apart(expr: sp.Expr, positive: Callable[[sp.Expr], bool]) -> Product:
    """The product behind an expression; `positive` says which sums are known to be positive."""
    number, primes, powers = _gathered(expr)
    sign = 1
    oriented: dict[sp.Expr, sp.Expr] = {}
    for base, exponent in powers.items():
        turned = base
        if base.is_Add and exponent.is_Integer and _points_down(base, positive):
            turned, sign = -base, sign * (-1) ** int(exponent)
        oriented[turned] = oriented.get(turned, sp.S.Zero) + exponent
    if number < 0:
        sign, number = -sign, -number
    merged = _conjugates(oriented)
    fractional = [e.q for e in (*primes.values(), *merged.values()) if e.is_Rational and not e.is_Integer]
    if not fractional:
        return Product(sign, number, tuple(merged.items()))
    return _rooted(sign, number, primes, merged, int(sp.ilcm(1, *fractional)))


def _gathered(expr: sp.Expr) -> tuple[sp.Rational, dict[int, sp.Rational], dict[sp.Expr, sp.Expr]]:
    """Rational number, fractional powers of primes, and powers of everything else, equal bases together."""
    number: sp.Rational = sp.S.One
    primes: dict[int, sp.Rational] = {}
    powers: dict[sp.Expr, sp.Expr] = {}

    def put(base: sp.Expr, exponent: sp.Expr) -> None:
        nonlocal number
        if base.is_Rational and exponent.is_Integer:
            number *= base**exponent
        elif base.is_Rational and exponent.is_Rational:
            for prime, count in (base.factors() if not base.is_Integer else sp.factorint(base)).items():
                primes[prime] = primes.get(prime, sp.S.Zero) + count * exponent
        elif base.is_Pow and base.exp.is_Rational and exponent.is_Rational:
            put(base.base, base.exp * exponent)
        elif base.is_Mul and exponent.is_Rational:
            for factor in base.args:
                put(factor, exponent)
        else:
            powers[base] = powers.get(base, sp.S.Zero) + exponent

    for factor in sp.Mul.make_args(expr):
        put(factor, sp.S.One) if isinstance(factor, sp.exp) else put(*factor.as_base_exp())
    return number, primes, {base: exponent for base, exponent in powers.items() if exponent != 0}


def _points_down(base: sp.Expr, positive: Callable[[sp.Expr], bool]) -> bool:
    """Whether -base reads better: it is known to be positive, or its largest coefficient is."""
    if positive(base) or positive(-base):
        return positive(-base)
    loads = [term.as_coeff_Mul()[0] for term in base.args if LOADS & set(sp.Mul.make_args(term))]
    if loads and len(loads) < len(base.args):
        return all(c < 0 for c in loads)
    coefficients = [term.as_coeff_Mul()[0] for term in base.args]
    largest = max(abs(c) for c in coefficients)
    leading = [c for c in coefficients if abs(c) == largest]
    plain = not base.atoms(sp.Function) and all(p.exp.is_Integer for p in base.atoms(sp.Pow))
    if len(leading) == 1 and plain:
        return bool(leading[0] < 0)
    return all(c < 0 for c in coefficients)


def _conjugates(powers: dict[sp.Expr, sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """(u - v)(u + v) -> u^2 - v^2, where both carry the same exponent."""
    for one, other in itertools.combinations(powers, 2):
        if not (one.is_Add and other.is_Add and len(one.args) == len(other.args) == 2 and powers[one] == powers[other]):
            continue
        twice, gap = one + other, one - other
        if not twice.is_Add and not gap.is_Add:
            merged = {sp.expand(one * other): powers[one]}
            return _conjugates(merged | {b: e for b, e in powers.items() if b not in (one, other)})
    return powers


def _rooted(
    sign: int, number: sp.Rational, primes: dict[int, sp.Rational], powers: dict[sp.Expr, sp.Expr], index: int
) -> Product:
    inside = {b: e * index for b, e in powers.items() if e.is_Rational and not e.is_Integer}
    outside = tuple((b, e) for b, e in powers.items() if b not in inside)
    exponents = {p: e for p, e in primes.items() if e != 0}
    for p, count in sp.factorrat(number).items():
        exponents[p] = exponents.get(p, sp.S.Zero) + count
    exponents.pop(1, None)
    broken = any(not e.is_Integer for e in exponents.values())
    lengths = any(not base.is_number for base in inside)
    everything = _number({p: e * index for p, e in exponents.items()})
    if broken and lengths and max(everything.p, everything.q) <= LARGEST_RADICAND:
        return Product(sign, sp.S.One, outside, Root(index, everything, tuple(inside.items())))
    whole = {p: sp.floor(e) for p, e in exponents.items()}
    rest = _number({p: (e - whole[p]) * index for p, e in exponents.items()})
    if rest.p <= LARGEST_RADICAND or not lengths:
        return Product(sign, _number(whole), outside, Root(index, rest, tuple(inside.items())))
    return _power_in_root(sign, exponents, inside, outside, index)


def _power_in_root(
    sign: int,
    exponents: dict[int, sp.Rational],
    inside: dict[sp.Expr, sp.Expr],
    outside: tuple[Factor, ...],
    index: int,
) -> Product:
    """The numbers that belong to a power under the root go into its bracket: (70 F/(3 E))^6.

    For the power k every prime p^e is shared out as e = (k x + index y)/index with the smallest x.
    """
    power = max(abs(int(e)) for e in inside.values())
    into, outer = {}, {}
    for p, e in exponents.items():
        target = int(e * index)
        x = min((x for x in range(-index, index + 1) if (target - power * x) % index == 0), key=lambda x: (abs(x), -x))
        into[p], outer[p] = sp.Integer(x), sp.Integer((target - power * x) // index)
    group = _number(into)
    for base, e in inside.items():
        if abs(e) == power:
            group *= base ** sp.sign(e)
    kept = tuple((b, e) for b, e in inside.items() if abs(e) != power)
    return Product(sign, _number(outer), outside, Root(index, sp.S.One, (*kept, (group, sp.Integer(power)))))


def _number(exponents: dict[int, sp.Expr]) -> sp.Rational:
    return sp.Mul(*(sp.Integer(p) ** e for p, e in exponents.items()))


def common_out(root: Root) -> Root:
    """R (b^2/R + d/R) under a root as b^2 + d: symbols that a sum shares with its other factors."""
    powers: dict[sp.Expr, sp.Expr] = {}
    for base, exponent in root.factors:
        shared = sp.Mul.make_args(sp.factor_terms(base) if base.is_Add and exponent == 1 else base)
        for factor in shared if all(f.is_Add or f.as_base_exp()[0].is_Symbol for f in shared) else (base,):
            own, power = factor.as_base_exp()
            powers[own] = powers.get(own, sp.S.Zero) + power * exponent
    kept = tuple((b, e) for b, e in powers.items() if e != 0)
    return Root(root.index, root.number, kept) if len(kept) < len(root.factors) else root


def common_power(base: sp.Expr) -> tuple[sp.Expr, int]:
    """(root, j) with base = root**j for the largest j: x**4 y**4/16 is (x y/2)**4, if x and y are not negative."""
    number, rest = base.as_coeff_Mul()
    powers = [factor.as_base_exp() for factor in sp.Mul.make_args(rest)]
    if not base.is_Mul or not number.is_positive or not all(exponent.is_Integer for _, exponent in powers):
        return base, 1
    for j in reversed(sp.divisors(sp.igcd(0, *(exponent for _, exponent in powers)))):
        (top, whole_top), (bottom, whole_bottom) = (sp.integer_nthroot(x, j) for x in (number.p, number.q))
        if whole_top and whole_bottom:
            return sp.Rational(top, bottom) * sp.Mul(*(x ** (exponent // j) for x, exponent in powers)), j
    return base, 1
