"""Torsion: the half-space below a punch that turns without slip, and the slip of a paraboloid from its edge.

In the oblate coordinates xi and eta of the circle, r**2 + z**2 - a**2 = xi**2 - eta**2 and z a = xi eta, nothing
cancels.  The integrals of slip are those of positive terms, in a variable that keeps singularities away.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..integrals import difference_root, integral, integral_in_strip
from ..interface import Array, Result
from ..special import arctan_gap
from .circle import SHORTEST, elliptic

NODES = 32
NEAR = 0.14
"""Of pi/2: how close the edge comes to the path over the inner half of a ring; of a narrow one, over its width."""
LEAST = 1e-9
"""Share of a stick zone below which it takes nothing of the torque: the loss falls with its third power."""


class TorsionStress(NamedTuple):
    """Circumferential shear stress on planes z and on cylinders r [Pa]."""

    tz: Result
    rt: Result


def oblate(r: Array, z: Array, a: Array) -> tuple[Array, Array, Array]:
    """xi, eta and xi**2 + eta**2."""
    whole = np.hypot(r - a, z) * np.hypot(r + a, z)
    excess = (r - a) * (r + a) + z * z
    larger = np.sqrt(0.5 * (whole + np.abs(excess)))
    smaller = np.where(larger > 0.0, z * a / np.where(larger > 0.0, larger, 1.0), 0.0)
    return np.where(excess > 0.0, larger, smaller), np.where(excess > 0.0, smaller, larger), whole


def turned_below(r: Array, z: Array, a: Array) -> Array:
    """Circumferential displacement over the angle, 2 r/pi (arccot(x) - x/(1 + x**2)) with x = xi/a."""
    xi, _, _ = oblate(r, z, a)
    far = xi > a
    y = a / np.where(far, xi, a)
    # arctan(y) - y/(1 + y**2), where y is small as y - arctan(y) tells
    outside = y * y * y / (1.0 + y * y) - arctan_gap(y)
    x = np.where(far, 0.0, xi) / a
    inside = np.pi / 2.0 - np.arctan(x) - x / (1.0 + x * x)
    return 2.0 * r / np.pi * np.where(far, outside, inside)


def on_planes(r: Array, z: Array, a: Array) -> Array:
    """Shear stress on planes z over G times the angle."""
    xi, eta, whole = oblate(r, z, a)
    return -4.0 / np.pi * (r * a / whole) * (eta * a / (a * a + xi * xi))


def on_cylinders(r: Array, z: Array, a: Array) -> Array:
    """Shear stress on cylinders r over G times the angle."""
    xi, _, whole = oblate(r, z, a)
    return -4.0 / np.pi * (xi * a / whole) * (r * a / (a * a + xi * xi)) ** 2


def turned(a: Array, c: Array) -> Array:
    """a (K - E) of the modulus sqrt(1 - c**2/a**2)."""
    kc = c / a
    deep = kc < 10.0 * SHORTEST
    share = (a - c) / a * ((a + c) / a)
    ratio = np.where(deep, 1.0, kc)
    whole = np.pi / 4.0 * share * (elliptic(ratio, 1.0) - elliptic(ratio, 0.0))
    return a * np.where(deep, np.log(4.0 / kc) - 1.0, whole)


def slipping_traction(r: Array, a: Array, c: Array) -> Array:
    """Traction over mu E_star/R: in the zone of stick that of all rings from c to a."""
    inside = r < c
    root = difference_root(c, np.where(inside, r, 0.0))
    outer = difference_root(a, np.where(inside, r, 0.0))
    stop = np.where(inside, np.log1p((a - c) / (c + root) * (1.0 + (a + c) / (outer + root))), 0.0)

    def integrand(v: Array) -> Array:
        s = c * np.cosh(v) + root * np.sinh(v)
        kc = np.minimum(s / a, 1.0)
        return a / s * elliptic(kc, kc * kc)

    held = r / np.pi * integral_in_strip(integrand, stop)
    return np.where(inside, held, 2.0 / np.pi * difference_root(a, np.minimum(r, a)))


def slipping_torque(a: Array, c: Array) -> Array:
    """Torque over mu E_star/R: of the disc that turns, and of the ring, inside and outside of half its area."""
    c = np.maximum(c, LEAST * a)
    length = difference_root(a, c)
    ratio = length / c
    half = np.sqrt(0.5)

    def arm(sine: Array, radius: Array) -> Array:
        return 0.5 * radius * np.arctan(ratio * sine) + 0.5 * c * length * sine / radius

    def inner(v: Array) -> Array:
        sine, radius = np.sinh(v) / ratio, c * np.cosh(v)
        return np.sqrt(1.0 - sine * sine) * sine * arm(sine, radius) * radius / length

    def outer(angle: Array) -> Array:
        sine, cosine = np.cos(angle), np.sin(angle)
        return cosine * cosine * sine * arm(sine, np.sqrt(c * c + (length * sine) ** 2))

    stop = np.arcsinh(half * ratio)
    ring = integral_in_strip(inner, stop, NEAR * np.clip(ratio, LEAST, 1.0))
    ring = ring + integral(outer, np.full_like(stop, np.pi / 4.0), NODES)
    return 16.0 / np.pi * (c**3 / 3.0 * turned(a, c) + length**3 * np.where(a > c, ring, 0.0))
