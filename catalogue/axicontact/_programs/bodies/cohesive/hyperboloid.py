"""Bodies of axicontact.cohesive.hyperboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, hypot, inf, tan

from ...._programs.bodies.normal import hyperboloid as normal
from ...._programs.bodies._runtime.integrals import difference_root
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, opening_power, outer_radius, root_of_zone, sunk, work_of_zone
from ....cohesive.hyperboloid import partial
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _opened(q, a, theta, b):
    """Gap of the normal contact at c, and its rate with c."""
    return opening_power(lambda t: normal._slope(t, theta, b), q, a, 1.0)


def _zone(a, theta, b, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0)


def _work_of_separation(a, c, theta, b, E_star, sigma_0):
    return work_of_zone(partial(_opened, theta=theta, b=b), difference_root(c, a), a, E_star, sigma_0)


def _cohesive_radius(a, theta, b, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, theta, b, E_star, dgamma, sigma_0), a)


def _pressure_of(r, q, a, theta, b, E_star, dgamma, sigma_0):
    v12 = a - r
    v17 = sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * (a + r))
    v60 = r < a
    if v60:
        v8 = r * r
        v11 = sqrt(v8 + b * b)
        v19 = asinh(v17 / v11)
        v24 = 0.0 - expm1(-2.0 * v19)
        v27 = v24 if v24 > 0.0 else inf
        v43 = tan(theta)
        v45 = b * v43
        v49 = b * b
        v54 = v11 * v11
        v58 = []
        for node, weight in RULE_0(v19 / 1.0):
            v28 = node * v19
            v37 = v17 * (exp(-v28) * (0.0 - expm1(-2.0 * (v19 - v28))) / v27)
            v38 = v37 * v37
            v40 = sqrt(v8 + v38)
            v57 = (v43 * atan(v40 / b) + v45 * v40 / (v40 * v40 + v49)) / v40 * sqrt(v54 + v38)
            v58.append(weight * v57)
        v58 = fsum(v58) * v19
        v64 = E_star / 3.141592653589793 * v58
    else:
        v64 = 0.0
    return v64 - sigma_0 * (0.6366197723675814 * atan2(q, v17) if v60 else 1.0 if r < hypot(a, q) else 0.0)


def _pressure(r, a, theta, b, E_star, dgamma, sigma_0):
    return _pressure_of(r, _zone(a, theta, b, E_star, dgamma, sigma_0), a, theta, b, E_star, dgamma, sigma_0)


def _displacement_of(r, q, a, theta, b, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, theta, b) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, theta, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, _zone(a, theta, b, E_star, dgamma, sigma_0), a, theta, b, E_star, dgamma, sigma_0)


def _without_contact_depth(c, theta, b, E_star, dgamma, sigma_0):
    depth = alone(partial(_opened, theta=theta, b=b), c, E_star, dgamma, sigma_0)
    return depth if depth <= -sunk(c, E_star, sigma_0) else np.nan


def _without_contact_force(c, theta, b, E_star, dgamma, sigma_0):
    depth = alone(partial(_opened, theta=theta, b=b), c, E_star, dgamma, sigma_0)
    return -np.pi * sigma_0 * c * c if depth <= -sunk(c, E_star, sigma_0) else np.nan
