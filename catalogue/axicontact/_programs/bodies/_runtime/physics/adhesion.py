"""Bodies of axicontact._runtime.physics.adhesion over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, inf

from ....._programs.bodies._runtime.inverse import inverse
from ....._runtime.plain import integral
from ....._runtime.plain import sqrt, MATH as np

ROUNDING = 1e-15
XI = {'force': 3.0, 'depth': 1.0}


def least_steepness(control, E_star, dgamma):
    """The sqrt(a) g'(a) beyond which the load grows with the contact radius."""
    return XI[control] * np.sqrt(np.pi * dgamma / (2.0 * E_star))


def hess_retraction(a, E_star, dgamma):
    return sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)


def pull(a, E_star, dgamma):
    return 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))


def separation(load, a, E_star):
    v3 = load / a
    return v3 * v3 / (25.132741228718345 * E_star * a)


def held(a, rate, force):
    v6 = 1.3333333333333333 * a * a * rate
    if v6 < inf:
        return v6 - force
    return inf


def tension(r, a, E_star, dgamma):
    if r <= a:
        v9 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        if v9 > 0.0:
            v13 = a - r
            return E_star * v9 / (3.141592653589793 * sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (a + r)))
        return 0.0
    return 0.0


def lift(r, a, E_star, dgamma):
    if r > a:
        v5 = r - a
        v15 = 0.6366197723675814 * atan2(a, sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (r + a)))
    else:
        v15 = 1.0
    return sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * v15


def power_law_radius(value, a_c, least, p, q, plain):
    """Stable radius where the load is A a**p - B a**q, with its minimum `least` at a_c.

    In v = (a/a_c)**q all of them are one curve, 1 + value/abs(least) = (v**m - m v)/(m - 1) + 1 with m = p/q.
    `plain` is the radius without adhesion, which remains where the pull is nothing to the load.
    """
    m = p / q + np.zeros_like(value)
    e = 1.0 - value / (least if least < 0.0 else -1.0) if least < 0.0 else np.inf
    e = 0.0 if np.abs(e) < ROUNDING else e
    s = _growth(e if e > 0.0 else 1.0, m)
    a = a_c * (1.0 + (0.0 if e == 0.0 else s)) ** (1.0 / q)
    return np.nan if e < 0.0 else a if np.isfinite(e) else plain if value >= 0.0 else np.nan


def _growth(e, m):
    """The s > 0 at which ((1 + s)**m - 1 - m s)/(m - 1) = e, for m > 1."""

    def curve(s):
        log = np.log1p(s)
        more = (1.0 + s) ** (m - 1.0) - 1.0 if (s > 1.0) & ((m - 1.0) * log > 1.0) else np.expm1((m - 1.0) * log)
        rate = m * more / (m - 1.0)
        value = near(s) if np.minimum(s, 4.0) * np.maximum(m, 2.0) < 4.0 else (1.0 + s) * rate / m - s
        return (value, s * rate / value)

    def near(s):
        s = np.minimum(s, 2.0)
        return m * s * s * integral(lambda y: (1.0 - y) * np.exp((m - 2.0) * np.log1p(s * y)), np.ones_like(s), 16)
    far = 0.0
    for _ in range(3):
        far = np.expm1(np.log1p((m - 1.0) * e + m * far) / m)
    start = np.sqrt(2.0 * e / m) if e * m < 1.0 else far
    return inverse(curve, e, start, (np.minimum(m, 2.0), np.maximum(m, 2.0)))
