"""Bodies of axicontact._runtime.physics.adhesion over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.integrals import difference_root
from ....._programs.bodies._runtime.inverse import inverse
from ....._runtime.physics.adhesion import ROUNDING, XI
from ....._runtime.plain import integral
from ....._runtime.plain import MATH as np


def least_steepness(control, E_star, dgamma):
    """The sqrt(a) g'(a) beyond which the load grows with the contact radius."""
    return XI[control] * np.sqrt(np.pi * dgamma / (2.0 * E_star))


def hess_retraction(a, E_star, dgamma):
    """sqrt(2 pi a dgamma/E_star); a root per factor, since the product may underflow."""
    return np.sqrt(a) * np.sqrt(2.0 * np.pi * dgamma / E_star)


def pull(a, E_star, dgamma):
    """Force of the flat punch moved by the retraction."""
    return 2.0 * E_star * a * hess_retraction(a, E_star, dgamma)


def tension(r, a, E_star, dgamma):
    """Its pressure: infinite at the edge, zero outside."""
    moved = hess_retraction(a, E_star, dgamma)
    inside = E_star * moved / (np.pi * difference_root(a, r)) if moved > 0.0 else 0.0
    return inside if r <= a else 0.0


def lift(r, a, E_star, dgamma):
    """Its surface displacement."""
    share = 2.0 / np.pi * np.arctan2(a, difference_root(r, a)) if r > a else 1.0
    return hess_retraction(a, E_star, dgamma) * share


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
