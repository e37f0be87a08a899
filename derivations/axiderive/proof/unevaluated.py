"""Results evaluated at extreme points, those that stay definite integrals among them."""

from __future__ import annotations

import cmath
from functools import lru_cache

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case
from . import ball_rules
from .balls import NotAvailableError, enclose_value
from .evaluate import at_precision, decades
from .rules import LostError, integrate
from .shape import Number, Values, concrete, number, numeric_symbols


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
    pieces = {integral: _definite(integral, values, digits, radii) for integral in plain.atoms(sp.Integral)}
    stand_ins = {integral: sp.Dummy("I", real=True) for integral in pieces}
    known = {**values, **{stand_ins[i]: value for i, value in pieces.items()}}
    try:
        return enclose_value(plain.xreplace(stand_ins), known, digits)
    except NotAvailableError:
        return at_precision(plain.xreplace(stand_ins), known)


def _least(values: Values) -> float:
    """Exponent of what the edge of an earlier contact brings in."""
    return min((float(values.get(nt.k, 0)) - 1) / 2, -0.5)


def _images(variable: sp.Symbol, values: Values, radii: tuple[complex, ...]) -> list[complex]:
    """Where the regularised variable of (11.53) or (11.56) meets a singular point of the profile."""
    if not radii:
        return []
    k, r = float(values.get(nt.k, 0)), float(at_precision(nt.r, values))
    if variable == nt.u:
        return [0j, *(complex(z * z - r * r) ** ((1 + k) / 2) for z in radii)]
    return [cmath.pi / 2, -cmath.pi / 2, *(sign * cmath.asin(z / r) for z in radii for sign in (1, -1))]


def _definite(integral: sp.Integral, values: Values, digits: int, radii: tuple[complex, ...] = ()) -> Number:
    (variable, lower, upper), integrand = integral.limits[0], integral.function
    start, end = mp.mpf(at_precision(lower, values)), mp.mpf(at_precision(upper, values))
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
    with ball_rules.at_working_precision():
        inside, origin = ball_rules.bound(integrand, variable, known), ball_rules.ball(start)
        panel = ball_rules.sum_over_balls
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
    return list(mp.polyroots([at_precision(c, values) for c in coefficients], maxsteps=500, extraprec=2 * mp.mp.prec))
