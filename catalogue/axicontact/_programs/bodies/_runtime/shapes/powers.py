"""Bodies of axicontact._runtime.shapes.powers over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import exp, expm1, fsum, inf, isfinite

from ....._programs.bodies._runtime.integrals import of_displacement
from ....._runtime.integrals import Course
from ....._runtime.plain import at_many_radii, integral
from ....._runtime.plain import log, log1p, sqrt, rule, MATH as np

NODES = 64
STEEP = 6.0
RULE_0 = rule(((16.0, 64), (inf, 128)))


def of_pressure(a, n):
    """Up to the axis, for powers that panels resolve."""
    return (Course(0.0, a * a, True, a) if n < STEEP else None, 0.0, a)


@at_many_radii(of_pressure)
def power_pressure(r, a, n):
    """Integral of t**(n - 1)/sqrt(t**2 - r**2) dt from r to a, over a**(n - 1)."""
    centre = 1.0 / np.abs(n - 1.0) if n > 1.0 else np.inf
    largest = 1.0 if n > 1.0 else (r / a) ** n * (a / r)
    return largest * _fallen_pressure(_log_ratio(a, r), n) if r > 0.0 else centre


def _fallen_pressure(depth, n):
    if depth > 0.0:
        v3 = n > 1.0
        v5 = abs(n - 1.0)
        v10 = depth - 42.0 / (v5 if v5 > 0.001 or v5 != v5 else 0.001)
        v12 = v10 if v10 > 0.0 or v10 != v10 else 0.0
        v13 = sqrt(depth)
        v18 = v13 - sqrt(v12) if v3 else sqrt(depth - v12)
        v22 = 2.0 * v13
        v27 = -v5
        v42 = []
        for node, weight in RULE_0(v18 / 1.0):
            v20 = node * v18
            if v3:
                v30 = v13 - v20
                v32 = v30 if v30 > 0.0 or v30 != v30 else 0.0
            else:
                v32 = v20
            v41 = exp(v27 * (v20 * (v22 - v20) if v3 else v20 * v20)) * (2.0 * v32 / sqrt(-expm1(-2.0 * v32 * v32)))
            v42.append(weight * v41)
        v42 = fsum(v42) * v18
        return v42
    return 0.0


@at_many_radii(of_displacement)
def power_displacement(r, a, n):
    """Integral of n t**(n - 1) arcsin(t/r) dt from 0 to a < r, over a**n."""
    start, reach = _span(r, a, n)

    def integrand(step):
        s = start + step
        fall = step * (2.0 * start + step)
        ratio = a / r * np.exp(-fall)
        return np.arctan2(ratio, np.sqrt(-np.expm1(-2.0 * s * s))) * np.exp(-n * fall) * 2.0 * s
    return n * integral(integrand, reach, NODES) if a > 0.0 else 0.0


def _log_ratio(x, y):
    v3 = (x - y) / y
    if isfinite(v3):
        return log1p(v3)
    return log(x) - log(y)


def _span(r, a, n):
    v4 = (r - a) / a
    v11 = sqrt(log1p(v4) if isfinite(v4) else log(r) - log(a))
    v15 = 42.0 / (n + 1.0)
    return (v11, v15 / (sqrt(v11 * v11 + v15) + v11))
