"""Results evaluated with mpmath to a stated number of digits, at exact points, those that stay integrals among them.

Two working precisions must agree, and the lower one starts above twice the
decades of the point: 1 - t**2 rounds to 1 for t = 1e-107 at 30, 60 and 120
digits alike, and three agreeing values of a hypergeometric function were 6 %
wrong there.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import lru_cache
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel.masters import MASTERS
from ..entry import Case, Entry
from ..profiles.profile import Profile
from . import rules
from .balls import NotAvailableError, enclose_value
from .rules import LostError, integrate
from .shape import Number, Values, concrete, number, numeric_symbols

HIGHEST = 2000
"""Digits at which an evaluation that still does not settle is given up."""


COMPARING = 400
"""Digits at which lengths are compared."""


def decades(values: Values) -> int:
    """How far apart, or how close, two lengths of the point are, in powers of ten."""
    lengths = [s for s in numeric_symbols(values) if nt.known(str(s)) and nt.describe(s).dimension == nt.LENGTH]
    with mp.workdps(COMPARING):
        sizes = [size for size in (number(values[s]) for s in lengths) if size]
        ratios = [x / y for x, y in itertools.combinations(sizes, 2)]
        measures = [*ratios, *(1 - ratio for ratio in ratios if ratio != 1)]
    return max((math.ceil(abs(mp.mag(x)) * math.log10(2)) for x in measures), default=0)


def evaluate(expr: sp.Expr, values: Values, digits: int) -> Number:
    """The value of expr, the same to `digits` digits at two precisions.

    Raises
    ------
    ArithmeticError
        If the value does not settle below HIGHEST digits.
    """
    precision = digits + 10 + 2 * decades(values)
    previous: Number | None = None
    while precision < HIGHEST:
        with mp.workdps(precision):
            value = mp.mpmathify(evaluated(expr, values))
            if previous is not None and abs(value - previous) <= mp.mpf(10) ** -digits * abs(value):
                return _real(value, digits, expr)
        previous = value
        precision += max(20, precision // 4)
    message = f"{expr} does not settle to {digits} digits below {HIGHEST}; the point may be a zero of it"
    raise ArithmeticError(message)


def evaluated(expr: sp.Expr, values: Values, integral: Callable[..., Any] = lambda f, *ends: mp.quad(f, ends)) -> Any:
    """The value of a result at the working precision, for which nothing is checked; integrals in it by a rule."""
    function, symbols, integrals = _prepared(concrete(sp.sympify(expr), values), numeric_symbols(values))
    known = values
    for stand_in, (variable, *ends), body in integrals:
        limits = (evaluated(end, values) for end in ends)
        known = {**known, stand_in: integral(of_one_variable(body, variable, values), *limits)}
    return function(*(number(known[s]) for s in symbols))


def of_one_variable(body: sp.Expr, variable: sp.Symbol, values: Values) -> Callable[[Any], Any]:
    """A formula without integrals with everything but its variable fixed, looked up once and not at every node."""
    function, symbols, _ = _prepared(concrete(body, values), (variable, *numeric_symbols(values)))
    fixed = {s: number(values[s]) for s in symbols if s != variable}
    return lambda x: function(*(fixed.get(s, x) for s in symbols))


Integrals = tuple[tuple[sp.Symbol, tuple[sp.Expr, ...], sp.Expr], ...]
"""What stands for the value of each integral of a result, its variable and limits, and its integrand."""


@lru_cache(maxsize=8192)
def _prepared(
    plain: sp.Expr, known: tuple[sp.Symbol, ...]
) -> tuple[Callable[..., Any], tuple[sp.Symbol, ...], Integrals]:
    """A result as a function, the symbols that it takes, and the integrals whose values it takes."""
    missing = plain.free_symbols - set(known)
    if missing:
        message = f"no value for {sorted(map(str, missing))} in {plain}; give every symbol of the result a value"
        raise ValueError(message)
    integrals = stand_ins(plain.atoms(sp.Integral), "integral", real=True)
    rest = plain.xreplace(integrals)
    symbols = tuple(s for s in (*known, *integrals.values()) if rest.has(s))
    own = {master.__name__: master.numeric for master in MASTERS}
    function = sp.lambdify(symbols, rest, modules=[own, "mpmath"], cse=True)
    within = tuple((name, whole.limits[0], whole.function) for whole, name in integrals.items() if rest.has(name))
    return function, symbols, within


def stand_ins(parts: Iterable[sp.Expr], name: str, **known: bool) -> dict[sp.Expr, sp.Symbol]:
    """A symbol for each of these parts by their text: Dummy symbols are added up in the order of their making."""
    return {part: sp.Symbol(f"{name}{i}", **known) for i, part in enumerate(sorted(parts, key=str))}


def _real(value: Number, digits: int, expr: sp.Expr) -> Number:
    if isinstance(value, mp.mpc):
        if abs(value.imag) > mp.mpf(10) ** -digits * abs(value):
            message = f"{expr} has the complex value {mp.nstr(value, 8)}; the point lies outside its domain"
            raise ArithmeticError(message)
        return value.real
    return value


def holds(case: Case, values: Values) -> bool:
    """Whether the region of the case contains the point; lengths without a value are not compared."""
    with mp.workdps(COMPARING):
        known = [evaluated(x, values) for x in case.chain if not (x.free_symbols - set(values))]
    return all(lo < hi for lo, hi in zip(known, known[1:], strict=False))


def case_at(entry: Entry, values: Values) -> Case:
    """The case of the entry that holds at a point.

    Raises
    ------
    LookupError
        If none does.
    """
    for case in entry.cases:
        if holds(case, values):
            return case
    point = ", ".join(f"{s} = {values[s]}" for s in numeric_symbols(values))
    message = f"{entry.key}: no case holds at {point}; a point on a border belongs to no case"
    raise LookupError(message)


def value_of(expr: sp.Expr, values: Values, digits: int) -> Number:
    """The value to about so many digits: the middle of an enclosure; by mpmath where an integral stays.

    The enclosure is tried first, as it needs no compiled function; for a C0 it takes a hundredth of the time.
    """
    if not expr.has(sp.Integral):
        with suppress(NotAvailableError):
            return enclose_value(expr, values, digits)
    with mp.workdps(digits):
        return mp.re(evaluated(expr, values))


def height(profile: Profile, values: Values, place: Any) -> Number:
    """f at a place, at the working precision; at a break by the piece below it.

    Raises
    ------
    LookupError
        If no piece reaches the place.
    """
    at = number(place)
    for piece in profile.pieces:
        if piece.upper is None or at <= evaluated(piece.upper, values):
            return evaluated(piece.expr, {**values, nt.r: at, nt.x: at})
    message = f"{profile.name}: no piece of the profile reaches r = {place}"
    raise LookupError(message)


def evaluate_case(case: Case, values: Values, digits: int) -> Number:
    """The middle of an enclosure; mpmath's value where a lower limit is a branch point, which boxes pass too slowly.

    A C0 next to a border takes mpmath seconds and Arb milliseconds.
    """
    if any(integral.limits[0][1] != 0 for integral in case.expr.atoms(sp.Integral)):
        return evaluate_integral(case.expr, values, digits)
    return enclose_value(case.expr, values, digits)


def evaluate_integral(expr: sp.Expr, values: Values, digits: int, radii: tuple[complex, ...] = ()) -> Number:
    """The value of a result with one or more sp.Integral in it; `radii` are singular points of the profile.

    The lower limit may be an algebraic singular point, where terms with
    x**((k - 1)/2) cancel: twice the digits are carried for k = 0, more for k < 0.
    """
    carried = int(digits / (1 + _least(values))) + 2 * decades(values) + 40
    plain = concrete(expr, values)
    for precision in (carried, 2 * carried):
        try:
            with mp.workdps(precision):
                return _evaluated(plain, values, digits, radii)
        except LostError:
            continue  # nodes next to a branch point that a difference of near lengths makes out
    message = f"{expr} has no value to {digits} digits with {2 * carried}; the point may be a branch point of it"
    raise ArithmeticError(message)


def _evaluated(plain: sp.Expr, values: Values, digits: int, radii: tuple[complex, ...]) -> Number:
    pieces = stand_ins(plain.atoms(sp.Integral), "piece", real=True)
    known = {**values, **{name: _definite(own, values, digits, radii) for own, name in pieces.items()}}
    rest = plain.xreplace(pieces)
    try:
        return enclose_value(rest, known, digits)
    except NotAvailableError:
        return evaluated(rest, known)


def _least(values: Values) -> float:
    """Exponent of what the edge of an earlier contact brings in."""
    return min((float(values.get(nt.k, 0)) - 1) / 2, -0.5)


def _images(variable: sp.Symbol, values: Values, radii: tuple[complex, ...]) -> list[complex]:
    """Where the regularised variable of (11.53) or (11.56) meets a singular point of the profile."""
    if not radii or variable not in (nt.u, nt.psi):
        return [*radii]
    k, r = float(values.get(nt.k, 0)), float(evaluated(nt.r, values))
    if variable == nt.u:
        return [0j, *(complex(z * z - r * r) ** ((1 + k) / 2) for z in radii)]
    return [cmath.pi / 2, -cmath.pi / 2, *(sign * cmath.asin(z / r) for z in radii for sign in (1, -1))]


def _definite(integral: sp.Integral, values: Values, digits: int, radii: tuple[complex, ...] = ()) -> Number:
    (variable, lower, upper), integrand = integral.limits[0], integral.function
    start, end = mp.mpf(evaluated(lower, values)), mp.mpf(evaluated(upper, values))
    shifted = [z - start for part in _zeros_of(integrand, variable) for z in _roots(part, values)]
    # what the lower limit itself is a root of comes out as rounding
    negligible = (end - start) * mp.mpf(10) ** (-mp.mp.dps // 2)
    # a feature behind the branch point, on another sheet, still asks for geometric panels down to its scale
    behind = -float(end - start) * 10.0 ** (-2 * decades(values))
    # the limits may be images themselves, to the precision of a float; an earlier contact does not feel what is beyond
    shifted += [
        z - complex(start)
        for z in _images(variable, values, radii)
        if min(abs(z - complex(start)), abs(z - complex(end))) > 1e-13 * max(1.0, abs(start))
    ]
    shifted = [-z if abs(z.imag) == 0 and 0 < z.real < end - start else z for z in map(complex, shifted)]
    # inside, the end of a sphere that a break cuts off is singular on another sheet only: its distance counts
    points = (0j, complex(behind), *(complex(z) for z in shifted if abs(z) > negligible))

    known = {s: number(values[s]) for s in numeric_symbols(values) if integrand.has(s) and s != variable}
    with rules.at_working_precision():
        inside, origin = rules.bound(integrand, variable, known), rules.ball(start)
        panel = rules.sum_over_balls
        return integrate(lambda x: inside(origin + x), mp.mpf(0), end - start, points, digits, _least(values), panel)


@lru_cache(maxsize=256)
def _zeros_of(integrand: sp.Expr, variable: sp.Symbol) -> tuple[tuple[sp.Expr, ...], ...]:
    """Coefficients of the polynomials in the variable that stand under roots and in denominators."""
    polynomials: set[tuple[sp.Expr, ...]] = set()
    for power in integrand.atoms(sp.Pow):
        if not power.base.has(variable) or (power.exp.is_Integer and power.exp > 0):
            continue
        for part in sp.fraction(sp.together(power.base)):
            if part.has(variable) and part.is_polynomial(variable):
                polynomials.add(tuple(sp.Poly(part, variable).all_coeffs()))
    return tuple(polynomials)


def _roots(coefficients: tuple[sp.Expr, ...], values: Values) -> list[Number]:
    return list(mp.polyroots([evaluated(c, values) for c in coefficients], maxsteps=500, extraprec=2 * mp.mp.prec))
