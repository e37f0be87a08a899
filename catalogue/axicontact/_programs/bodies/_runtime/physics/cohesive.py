"""Bodies of axicontact._runtime.physics.cohesive over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, hypot

from ....._programs.bodies._runtime.integrals import difference_root
from ....._programs.bodies._runtime.inverse import inverse
from ....._runtime.plain import both, integral_in_strip
from ....._runtime.plain import sqrt, MATH as np

CLOSE = 3e-08
CLOSEST = 1e-09
EMPTY = 0.5707963267948966
EXPONENTS = (0.5, 4.0,)
INSIDE = 0.75
NARROW = 0.7
WITHIN = 0.999999


def outer_radius(q, a):
    return hypot(a, q)


def opening(slope, q, a, lengths):
    """For g' without singularities."""
    return _along(slope, np.hypot(a, q), 0.0, np.arctan2(q, a), 1.0, lengths)


def _along(slope, c, start, length, width, lengths):

    def gained(v):
        u = start + v
        cosine = np.cos(u)
        growth = slope(c * cosine)
        return (growth * u * np.sin(u), growth * cosine)
    gap, rate = both(gained, length, width, lengths)
    return (2.0 / np.pi * c * gap, 2.0 / np.pi * rate)


def work_of_zone(opened, q, a, E_star, sigma_0):
    """sigma_0 times the gap at c."""
    return sigma_0 * (opened(q, a)[0] + ring_of_zone(q, a, E_star, sigma_0))


def zone_within(opened, a, E_star, dgamma, sigma_0, largest):
    """The radius of a contact; not a number where its zone would reach beyond the largest q of a profile that ends."""
    reached = (largest > 0.0) & (work_of_zone(opened, WITHIN * largest, a, E_star, sigma_0) >= dgamma)
    return a if reached else np.nan


def zone_like(opened, a, E_star, dgamma, sigma_0, largest=np.inf):
    """About the q at which the gap at c is dgamma/sigma_0."""
    part = 0.25 * np.pi * (dgamma / sigma_0) * (E_star / sigma_0)
    wide = 0.5 / EMPTY * part
    start = wide + np.hypot(wide, np.sqrt(2.0 * a) * np.sqrt(part))
    start = np.minimum(start, INSIDE * largest)
    c, (gap, rate) = (np.hypot(a, start), opened(start, a))
    known = gap > 0.0
    grown = start / (gap if known else 1.0) * (start / c) * rate if known else 1.0
    ring = 1.0 + a / c
    blend = 0.5 * (grown + ring)
    own = ring_of_zone(start, a, E_star, sigma_0) * (sigma_0 / dgamma)
    whole = (gap * (sigma_0 / dgamma)) ** (blend / grown) + own ** (blend / ring)
    return np.minimum(start * whole ** (-1.0 / blend), WITHIN * largest)


def root_of_zone(opened, a, E_star, dgamma, sigma_0, largest=np.inf):
    """That q."""
    start = zone_like(opened, a, E_star, dgamma, sigma_0, largest)
    share, value = (4.0 / np.pi * (sigma_0 / E_star), dgamma / sigma_0)

    def curve(q):
        whole, rise = with_ring(*opened(q, a), q, a, share)
        return (whole, rise / whole)
    return inverse(curve, value, start, EXPONENTS, largest, smooth=True, noise=CLOSE * value)


def with_ring(gap, rate, q, a, share):
    v5 = hypot(a, q)
    v6 = atan2(q, a)
    v7 = q / v5
    v9 = q / (v5 + a)
    return (gap + share * q * (v6 - v9), q * v7 * (rate + share * (v6 / v7 - v7 * v9)))


def ring_of_zone(q, a, E_star, sigma_0):
    return 1.2732395447351628 * (sigma_0 / E_star) * q * (atan2(q, a) - q / (hypot(a, q) + a))


def sunk(q, E_star, sigma_0):
    return 2.0 * (sigma_0 / E_star) * q


def pull_of_zone(q, a, sigma_0):
    v3 = hypot(a, q)
    return 2.0 * sigma_0 * (v3 * v3 * atan2(q, a) + a * q)


def tension_of_zone(r, q, a, sigma_0):
    if r < a:
        v4 = a - r
        v18 = 0.6366197723675814 * atan2(q, sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (a + r)))
    else:
        v18 = 1.0 if r < hypot(a, q) else 0.0
    return sigma_0 * v18


def lift_of_zone(r, q, a, E_star, sigma_0):
    """What it takes of the displacement: as far as the load reaches, sqrt(c**2 - x**2)/sqrt(r**2 - x**2) from a on."""
    c, place = (np.hypot(a, q), np.maximum(r, a))
    wide = difference_root(place, a)
    within = place < c
    near, far = (np.minimum(place, c), np.maximum(place, c))
    reach = wide if within else q
    kc = difference_root(far, near) / far
    held = np.arctan2(a, wide) if place > a else 0.5 * np.pi
    end = np.arctan2(reach, a)
    ring = _ring(near, far, kc, end, within)
    return 4.0 / np.pi * (sigma_0 / E_star) * (q * held + ring)


def _ring(near, far, kc, end, within):
    """Integral of sqrt(c**2 - x**2)/sqrt(r**2 - x**2) from a to the nearer of c and r.

    With x = near cos(u) the longer root is far sqrt(kc**2 + (near/far)**2 sin(u)**2): next to the edge of the ring that
    is a small number beside the sine, and in u = kc sinh(v) regular.
    """
    ratio = near / far
    scale = np.maximum(kc, CLOSEST)
    last = np.arcsinh(end / scale)

    def rate(v):
        u = scale * np.sinh(v)
        sine = np.sin(u)
        root = np.hypot(kc, ratio * sine)
        return (far * root if within else near * (sine / root) * (sine * ratio)) * scale * np.cosh(v)
    return integral_in_strip(rate, last, NARROW)


def alone(opened, c, E_star, dgamma, sigma_0):
    """The depth of surfaces that attract each other up to the radius c without contact."""
    gap = 0.0 if c == 0.0 else opened(c, np.zeros_like(c))[0]
    return gap - dgamma / sigma_0 - 4.0 / np.pi * (sigma_0 / E_star) * c
