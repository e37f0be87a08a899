"""Results that stay definite integrals, evaluated as they stand with mpmath."""

from __future__ import annotations

import mpmath as mp
import sympy as sp

from .evaluate import at_precision, decades
from .rules import integrate
from .shape import Number, Values, concrete, numeric_symbols


def evaluate_integral(expr: sp.Expr, values: Values, digits: int) -> Number:
    """The value of a result with one or more sp.Integral in it.

    The lower limit may be an algebraic singular point, where terms with
    x**(-1/2) cancel: twice the digits are carried.
    """
    with mp.workdps(2 * digits + 2 * decades(values) + 40):
        plain = concrete(expr, values)
        pieces = {integral: _definite(integral, values, digits) for integral in plain.atoms(sp.Integral)}
        stand_ins = {integral: sp.Dummy("I", real=True) for integral in pieces}
        reduced = plain.xreplace(stand_ins)
        return at_precision(reduced, {**values, **{stand_ins[i]: value for i, value in pieces.items()}})


def _definite(integral: sp.Integral, values: Values, digits: int) -> Number:
    (variable, lower, upper), integrand = integral.limits[0], integral.function
    start, end = at_precision(lower, values), at_precision(upper, values)
    singular = {0j, *(z - complex(start) for z in _singular_points(integrand, variable, values))}
    points = tuple(z for z in singular if z == 0 or abs(z) > 1e-14 * float(end - start))

    def f(x: Number) -> Number:
        return at_precision(integrand, {**values, variable: start + x})

    return integrate(f, mp.mpf(0), end - start, points, digits)


def _singular_points(integrand: sp.Expr, variable: sp.Symbol, values: Values) -> set[complex]:
    """Zeros of the bases of roots and reciprocals that are polynomials or fractions of the variable."""
    points: set[complex] = set()
    exact = {s: sp.Rational(str(mp.nstr(v, 40))) if isinstance(v := values[s], mp.mpf) else v for s in numeric_symbols(values)}
    for power in integrand.atoms(sp.Pow):
        if not power.base.has(variable) or (power.exp.is_Integer and power.exp > 0):
            continue
        base = sp.together(power.base.xreplace(exact))
        for part in sp.fraction(base):
            if part.has(variable) and part.is_polynomial(variable):
                points.update(complex(z) for z in sp.Poly(part, variable).nroots(n=25, maxsteps=200))
    return points
