"""How a product or a sum is arranged before it is printed.

A product is taken apart into sign, number, factors turned to be positive, and one root for all fractional powers;
then which factor is scale, which term comes first, and what two terms share stands before them.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from .. import notation as nt
from ..code.text import written

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
    if positive(base):
        return False
    if positive(-base):
        return True
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
    """(u - v)(u + v) -> u^2 - v^2, where both carry the same exponent, into what there is of that square."""
    for one, other in itertools.combinations(powers, 2):
        if not (one.is_Add and other.is_Add and len(one.args) == len(other.args) == 2 and powers[one] == powers[other]):
            continue
        twice, gap = one + other, one - other
        if not twice.is_Add and not gap.is_Add:
            square = sp.expand(one * other)
            merged = {square: powers[one] + powers.get(square, sp.S.Zero)}
            return _conjugates(merged | {b: e for b, e in powers.items() if b not in (one, other, square)})
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


ORDER = (
    "kappa", "n", "j", "mu", "E_star", "E_inf", "E", "E_1", "G_star", "H", "H_x", "eta", "p_0", "p_mean", "P", "F",
    "F_x", "dgamma", "d", "A", "C", "h", "v", "time", "t_0", "L", "a", "a_c", "c", "r", "r_zero", "r_peak", "t",
    "x", "x_zero", "e", "b", "R", "R1", "R2", "s", "wavelength", "N", "retraction", "k", "u", "psi", "theta",
)  # fmt: skip
TRIGONOMETRIC = (sp.sin, sp.cos, sp.tan)
RAISED = (*TRIGONOMETRIC, sp.sinh, sp.cosh, sp.tanh)
"""Functions whose powers are printed behind the name: sinh^2 x."""


def is_one_group(text: str) -> bool:
    r"""Whether a single \frac{..}{..} or \sqrt{..} is the whole text."""
    wanted = 2 if text.startswith((r"\frac{", r"\tfrac{")) else 1 if text.startswith(r"\sqrt{") else 0
    depth = groups = 0
    for i, c in enumerate(text):
        depth += (c == "{") - (c == "}")
        groups += c == "}" and depth == 0
        if wanted and groups == wanted:
            return i == len(text) - 1
    return False


def is_scale(base: sp.Expr) -> bool:
    """Whether a factor stands in the fraction: a symbol, number, Gamma, sum as n + 1, or tan theta."""
    if isinstance(base, TRIGONOMETRIC):
        return bool(base.args[0].is_Symbol)
    if base.is_Add:
        return {s.name for s in base.free_symbols} <= {"n", "j", "k"}
    if isinstance(base, sp.Derivative):
        return isinstance(base.expr, AppliedUndef)
    return bool(
        base.is_Symbol or base is sp.pi or isinstance(base, (sp.Indexed, sp.gamma, AppliedUndef)) or base.is_Number
    )


def is_function(base: sp.Expr) -> bool:
    """Whether a factor is neither such a scale nor a sum."""
    return not is_scale(base) and not base.is_Add


def has_fraction(base: sp.Expr) -> bool:
    """Whether a term of the sum has a denominator."""
    return any(sp.fraction(term)[1] != 1 for term in base.args)


def _rank(symbol: sp.Symbol) -> int:
    return ORDER.index(symbol.name) if symbol.name in ORDER else len(ORDER)


# a formula is set several times over until it fits, and the text of an expression is slow to make
@lru_cache(maxsize=65536)
def factor_key(factor: Factor) -> tuple[int, int, str]:
    """Key to sort factors by: numbers, pi, symbols in the order of print, angles, then functions and integrals."""
    base = factor[0]
    if base.is_Number:
        return (0, 0, "")
    if base is sp.pi:
        return (1, 0, "")
    if base.is_Symbol:
        return (2, _rank(base), base.name)
    if isinstance(base, sp.Indexed):
        return (2, ORDER.index("A"), "")
    if base.is_Add and is_scale(base):  # (n+1) F, for F (n+1) would read as a function
        return (2, ORDER.index("j"), written(base))
    if isinstance(base, sp.gamma):  # a number: before the lengths, for tan theta Gamma(x) reads as tan(theta Gamma(x))
        return (2, ORDER.index("j"), f"~{written(base)}")
    if isinstance(base, TRIGONOMETRIC):
        return (3, TRIGONOMETRIC.index(type(base)), written(base))
    kinds = (sp.Pow, sp.Add, sp.Function, sp.Sum, sp.Integral)
    return (4 + next((i for i, kind in enumerate(kinds) if isinstance(base, kind)), len(kinds)), 0, written(base))


@lru_cache(maxsize=65536)
def term_key(term: sp.Expr) -> tuple[Any, ...]:
    """Integrals last, plain numbers before them, then by falling powers in the order of the symbols."""
    powers = term.as_powers_dict()
    degrees = tuple(-float(powers.get(s, 0)) if powers.get(s, sp.S.Zero).is_number else -1.0 for s in _SYMBOLS)
    return (bool(term.atoms(sp.Integral)), term.is_number, degrees, written(term))


_SYMBOLS = tuple(nt.describe(name).symbol for name in ORDER if nt.known(name))


def samples(chain: tuple[sp.Expr, ...]) -> list[dict[sp.Symbol, sp.Rational]]:
    """Values that keep the order: evenly spread, far apart and close together."""
    if len(chain) < 2 or not all(x.is_Symbol for x in chain):
        return []
    steps = [[sp.Integer(i + 1), sp.Integer(10) ** i, 1 + sp.Rational(i, 100)] for i in range(len(chain))]
    return [dict(zip(chain, values, strict=True)) for values in zip(*steps, strict=True)]


def tidied(expr: sp.Expr) -> sp.Expr:
    """The same value; roots, differences and polynomials of the grading in the form that is read best."""
    expr = expr.replace(lambda e: e.is_Pow and not e.exp.is_number, _one_power)
    if expr.has(nt.k):
        expr = expr.replace(lambda e: e.is_Add, _by_lengths)
    return _difference(expr) if expr.has(nt.c) else expr


def _one_power(power: sp.Pow) -> sp.Expr:
    """sqrt(d R)**(k + 3) as (d R)**((k + 3)/2)."""
    factors = [factor.as_base_exp() for factor in sp.Mul.make_args(power.base)]
    if not all(e.is_Rational for _, e in factors) or any(e.is_Integer for base, e in factors if not base.is_number):
        return power
    index = sp.ilcm(1, *(e.q for _, e in factors))
    return sp.Pow(power.base**index, power.exp / index)


def _by_lengths(total: sp.Add) -> sp.Expr:
    """a**2 k + a**2 + 2 r**2 as (k + 1) a**2 + 2 r**2."""
    lengths = sorted(total.free_symbols - {nt.k}, key=str)
    if not lengths or nt.k not in total.free_symbols or not total.is_polynomial(nt.k, *lengths):
        return total
    terms = sp.Poly(total, *lengths).terms()
    return sp.Add(*(sp.factor(number) * sp.prod(x**n for x, n in zip(lengths, powers, strict=True))
                    for powers, number in terms))  # fmt: skip


def _difference(expr: sp.Expr) -> sp.Expr:
    """A state of the contact radius less the same of the stick radius: the factors of both, then the difference."""

    def factored(total: sp.Add) -> sp.Expr:
        sums = [term.as_independent(sp.Sum, as_Add=False)[1] for term in total.args]
        common = sp.factor_terms(total)
        if not all(isinstance(one, sp.Sum) for one in sums):
            return common
        scale, rest = common.as_independent(sp.Sum, as_Add=False)
        terms = [term.as_coeff_Mul() for term in sp.Add.make_args(rest)]
        function = sp.factor_terms(sum(sign * one.function for sign, one in terms))
        return scale * sp.Sum(function, *sums[0].limits)

    return expr.replace(lambda e: e.is_Add and e.has(nt.c) and len(e.args) == 2, factored)
