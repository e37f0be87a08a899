"""Adhesive contact by the rule of Hess: the contact without adhesion less a flat punch moved by the retraction.

At pull-off the force (xi = 3) or the depth (xi = 1) is stationary in the contact
radius, and the retraction is 2 a g'(a)/xi with the depth g(a) without adhesion.
Where the load is no power of the radius, `branches` are searched for.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..integrals import difference_root, integral
from ..interface import Array, Result
from ..inverse import inverse

XI = {"force": 3.0, "depth": 1.0}
"""The retraction at pull-off is 2 a g'(a)/xi, by what is held."""
ROUNDING = 1e-15
"""A load this close below pull-off, relative to it, counts as pull-off."""


class PullOff(NamedTuple):
    """The state at which the contact breaks."""

    radius: Result
    force: Result
    depth: Result


def require_control(control: str) -> str:
    if control not in XI:
        message = f"control = {control!r} must be 'force' or 'depth': what is held while the contact is unloaded"
        raise ValueError(message)
    return control


def least_steepness(control: str, E_star: Array, dgamma: Array) -> Array:
    """The sqrt(a) g'(a) beyond which the load grows with the contact radius."""
    return XI[control] * np.sqrt(np.pi * dgamma / (2.0 * E_star))


def hess_retraction(a: Array, E_star: Array, dgamma: Array) -> Array:
    """sqrt(2 pi a dgamma/E_star); a root per factor, since the product may underflow."""
    return np.sqrt(a) * np.sqrt(2.0 * np.pi * dgamma / E_star)


def pull(a: Array, E_star: Array, dgamma: Array) -> Array:
    """Force of the flat punch moved by the retraction."""
    return 2.0 * E_star * a * hess_retraction(a, E_star, dgamma)


def separation(load: Array, a: Array, E_star: Array) -> Array:
    """Work of separation of a contact whose force is `load` less than without adhesion."""
    return (load / a) ** 2 / (8.0 * np.pi * E_star * a)


def held(a: Array, rate: Array, force: Array) -> Array:
    """Tension at which a contact of this radius comes off, over the modulus as its `force` without adhesion is."""
    pulled = 4.0 / 3.0 * a * a * rate
    return np.where(pulled < np.inf, pulled - force, np.inf)


def tension(r: Array, a: Array, E_star: Array, dgamma: Array) -> Array:
    """Its pressure: infinite at the edge, zero outside."""
    moved = hess_retraction(a, E_star, dgamma)
    inside = np.where(moved > 0.0, E_star * moved / (np.pi * difference_root(a, r)), 0.0)
    return np.where(r <= a, inside, 0.0)


def lift(r: Array, a: Array, E_star: Array, dgamma: Array) -> Array:
    """Its surface displacement."""
    share = np.where(r > a, 2.0 / np.pi * np.arctan2(a, difference_root(r, a)), 1.0)
    return hess_retraction(a, E_star, dgamma) * share


def power_law_radius(value: Array, a_c: Array, least: Array, p: Array, q: float, plain: Array) -> Array:
    """Stable radius where the load is A a**p - B a**q, with its minimum `least` at a_c.

    In v = (a/a_c)**q all of them are one curve, 1 + value/abs(least) = (v**m - m v)/(m - 1) + 1 with m = p/q.
    `plain` is the radius without adhesion, which remains where the pull is nothing to the load.
    """
    m = p / q + np.zeros_like(value)
    e = np.where(least < 0.0, 1.0 - value / np.where(least < 0.0, least, -1.0), np.inf)
    e = np.where(np.abs(e) < ROUNDING, 0.0, e)
    s = _growth(np.where(e > 0.0, e, 1.0), m)
    a = a_c * (1.0 + np.where(e == 0.0, 0.0, s)) ** (1.0 / q)
    return np.where(e < 0.0, np.nan, np.where(np.isfinite(e), a, np.where(value >= 0.0, plain, np.nan)))


def _growth(e: Array, m: Array) -> Array:
    """The s > 0 at which ((1 + s)**m - 1 - m s)/(m - 1) = e, for m > 1."""

    def curve(s: Array) -> tuple[Array, Array]:
        log = np.log1p(s)
        # the rounding of a logarithm of 60 would be felt in its exponential
        more = np.where((s > 1.0) & ((m - 1.0) * log > 1.0), (1.0 + s) ** (m - 1.0) - 1.0, np.expm1((m - 1.0) * log))
        rate = m * more / (m - 1.0)
        value = np.where(np.minimum(s, 4.0) * np.maximum(m, 2.0) < 4.0, near(s), (1.0 + s) * rate / m - s)
        return value, s * rate / value

    def near(s: Array) -> Array:
        # an integral of positive terms, up to where the difference is a third of its own; at s = 1/2 it is an eighth
        s = np.minimum(s, 2.0)
        return m * s * s * integral(lambda y: (1.0 - y) * np.exp((m - 2.0) * np.log1p(s * y)), np.ones_like(s), 16)

    # (1 + s)**m = 1 + (m - 1) e + m s, twice with the last s on the right
    far = 0.0
    for _ in range(3):
        far = np.expm1(np.log1p((m - 1.0) * e + m * far) / m)
    start = np.where(e * m < 1.0, np.sqrt(2.0 * e / m), far)
    return inverse(curve, e, start, (np.minimum(m, 2.0), np.maximum(m, 2.0)))
