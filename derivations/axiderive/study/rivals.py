"""Other ways to the same numbers.

Other ways to the radius of an adhesive contact at a given depth: g by quadrature less the retraction (11.63).

Other ways to the same numbers, each written from its definition: quadrature rules, scripts, digits.

Pressure (11.23), displacement (11.26) and F(d) from (11.29), (11.20); with the
edge term of (11.107) where the depth is free.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from functools import cache

import mpmath as mp
import numpy as np
from scipy import integrate, optimize, special

from .. import notation as nt
from .problems import RADIUS
from .subject import Array, Subject

a = RADIUS


@cache
def jacobi(count: int, lower: float, upper: float) -> tuple[Array, Array]:
    """Nodes on (0, 1) and weights for x**lower (1 - x)**upper."""
    nodes, weights = special.roots_jacobi(count, upper, lower)
    return (1 + nodes) / 2, weights / 2 ** (1 + upper + lower)


def punch_pressure(subject: Subject, r: Array) -> Array:
    """The edge term of (11.107), (11.47), of a depth beyond that of the profile."""
    return subject.excess * subject.modulus / np.pi * ((a - r) * (a + r)) ** subject.power if subject.excess else 0.0


def punch_displacement(subject: Subject, r: Array) -> Array:
    """Displacement at r > a of the excess depth of a complete contact, as of a flat punch; 0 without one."""
    return subject.excess * 2 / np.pi * np.arcsin(a / r) if subject.excess else 0.0


def jacobi_pressure(subject: Subject, r: Array, count: int) -> Array:
    """In t**2, whose distance from the lower limit carries the power (k - 1)/2; a break is such a limit."""
    return subject.modulus / np.pi * sum(
        _jacobi_pressure(subject, r, low, high, count) for low, high in spans(subject, a)
    ) + punch_pressure(subject, r)


def _jacobi_pressure(subject: Subject, r: Array, start: float, end: float, count: int) -> Array:
    low = np.clip(r, start, end)
    width, total, power = (end - low) * (end + low), 0.0, subject.power
    for node, weight in zip(*jacobi(count, power, 0.0), strict=True):
        past = width * node
        t = np.sqrt(low * low + past)
        kernel = (past / (past + (low - r) * (low + r))) ** -power
        total = total + weight * subject.rate(t) / (2 * t) * kernel
    return width ** (1 + power) * total


def jacobi_displacement(subject: Subject, r: Array, count: int) -> Array:
    """In t - b, with the power -1/2 that g' may have at a break; no singularity without one."""
    total = 0.0
    for low, high in spans(subject, a):
        power = -0.5 if low else 0.0
        for node, weight in zip(*jacobi(count, power, 0.0), strict=True):
            t = low + (high - low) * node
            total = total + (high - low) * weight * node**-power * float(subject.rate(t)) * np.arcsin(t / r)
    return 2 / np.pi * total + punch_displacement(subject, r)


def jacobi_force(subject: Subject, d: Array, count: int) -> Array:
    """Depth and force over the profile with the power -1/2 at r = a; the radius by brentq."""

    def moment(x: float, power: int) -> float:
        return sum(_jacobi_moment(subject, x, power, low, high, count) for low, high in spans(subject, x))

    def force(depth: float) -> float:
        return 2 * subject.modulus * moment(radius(subject, lambda x: x * moment(x, 0) - depth), 2)

    return np.array([force(float(depth)) for depth in d])


def _jacobi_moment(subject: Subject, x: float, power: int, low: float, high: float, count: int) -> float:
    """Integral of f'(s) s**power/sqrt(x**2 - s**2) from one break to the next, or to x."""
    nodes, weights = jacobi(count, 0.0, -0.5 if high == x else 0.0)
    s = low + (high - low) * nodes
    scale = math.sqrt(x - low) if high == x else (high - low) / np.sqrt(x - s)
    return float(np.sum(scale * weights * subject.slope(s) * s**power / np.sqrt(x + s)))


def quad_pressure(subject: Subject, r: Array, *, substituted: bool) -> Array:
    """The integral (11.23), (11.53) given to scipy.integrate.quad as it stands; from break to break.

    On the homogeneous half-space also `substituted`, in t = r cosh(v).
    """
    power = subject.power

    def span(r: float, low: float, high: float) -> float:
        if substituted:
            ends = math.acosh(low / r), math.acosh(high / r)
            return quad(lambda v: subject.rate_scalar(r * math.cosh(v)), *ends)
        return quad(lambda t: subject.rate_scalar(t) * ((t - r) * (t + r)) ** power, low, high)

    def one(r: float) -> float:
        return sum(span(r, max(r, low), high) for low, high in spans(subject, a) if high > r)

    return subject.modulus / np.pi * np.array([one(float(x)) for x in r]) + punch_pressure(subject, r)


def quad_displacement(subject: Subject, r: Array) -> Array:
    """Displacement at radii r > a by scipy's quad over g', from break to break."""

    def one(r: float) -> float:
        return sum(quad(lambda t: subject.rate_scalar(t) * math.asin(t / r), *span) for span in spans(subject, a))

    return 2 / np.pi * np.array([one(float(x)) for x in r]) + punch_displacement(subject, r)


def quad_force(subject: Subject, d: Array) -> Array:
    """The script without closed forms: g by quad, its root by brentq, F by quad over g."""
    b = subject.edge

    def depth(x: float) -> float:
        return sum(
            x * quad(lambda u: float(subject.slope(x * math.sin(u))), math.asin(low / x), math.asin(high / x))
            for low, high in spans(subject, x)
        )

    def force(given: float) -> float:
        reached = radius(subject, lambda x: depth(x) - given)
        parts = [quad(lambda t: given - depth(t), *span, tolerance=1e-10) for span in spans(subject, reached)]
        return 2 * subject.modulus * (given * b + sum(parts))

    return np.array([force(float(x)) for x in d])


def mpmath_pressure(subject: Subject, r: Array, digits: int, *, substituted: bool) -> list[mp.mpf]:
    """The integral (11.23) given to mpmath.quad from the break on, as it stands or in t = r cosh(v)."""

    def rate(t: mp.mpf, low: mp.mpf) -> mp.mpf:
        # rounding takes the first nodes to a break or below it
        return subject.rate_mp(t) if t > low or low > subject.edge else mp.mpf(0)

    def one(r: mp.mpf) -> mp.mpf:
        low = max(r, mp.mpf(subject.edge))
        if substituted:
            return mp.quad(lambda v: rate(r * mp.cosh(v), low), [mp.acosh(low / r), mp.acosh(a / r)])
        return mp.quad(lambda t: subject.rate_mp(t) / mp.sqrt(t * t - r * r), [low, a])

    with mp.workdps(digits):
        return [subject.modulus * one(mp.mpf(float(x))) / mp.pi for x in r]


def mpmath_displacement(subject: Subject, r: Array, digits: int) -> list[mp.mpf]:
    """Displacement at radii r > a by mpmath's quadrature at this many digits."""
    with mp.workdps(digits):
        radii = [mp.mpf(float(x)) for x in r]
        return [
            2 * mp.quad(lambda t, r=r: subject.rate_mp(t) * mp.asin(t / r), [subject.edge, a]) / mp.pi for r in radii
        ]


def mpmath_force(subject: Subject, d: Array, digits: int) -> list[mp.mpf]:
    """Depth and force by mpmath.quad over the angle, the radius by its secants."""

    def moment(x: mp.mpf, power: int) -> mp.mpf:
        ends = [mp.asin(subject.edge / x), mp.pi / 2]
        return mp.quad(lambda u: subject.slope_mp(x * mp.sin(u)) * (x * mp.sin(u)) ** power, ends)

    def force(depth: mp.mpf) -> mp.mpf:
        # a start from double precision, as for any iteration with many digits
        start = mp.mpf(radius(subject, lambda x: float(subject.depth(np.float64(x)) - float(depth))))
        nearby = start * (1 + mp.mpf(10) ** (-min(digits, 15) // 2))
        root = mp.findroot(lambda x: x * moment(x, 0) / depth - 1, (start, nearby), tol=mp.eps**1.5, verify=False)
        return 2 * subject.modulus * moment(root, 2)

    with mp.workdps(digits):
        return [force(mp.mpf(float(x))) for x in d]


def spans(subject: Subject, end: float) -> list[tuple[float, float]]:
    """From break to break up to a radius."""
    return [(low, min(high, end)) for low, high in subject.spans if low < end]


def radius(subject: Subject, gap: Callable[[float], float]) -> float:
    """The root between the edge and the largest radius, by brentq."""
    low = subject.edge * (1 + 1e-14) if subject.edge else 1e-9 * a
    return float(optimize.brentq(gap, low, subject.largest * (1 - 1e-9), xtol=1e-300, rtol=1e-14))


def quad(integrand: Callable[[float], float], low: float, high: float, tolerance: float = 1e-13) -> float:
    """scipy.integrate.quad without its warnings."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its error estimate; what the error is, the study measures
        value, _ = integrate.quad(integrand, low, high, epsabs=0.0, epsrel=tolerance, limit=200)
    return float(value)


def quad_radius(subject: Subject, d: Array) -> Array:
    """g by quad, the radius by brentq."""

    def depth(x: float) -> float:
        free = x * quad(lambda u: float(subject.slope(x * math.sin(u))), 0.0, math.pi / 2)
        return free - math.sqrt(2 * math.pi * x * subject.values[nt.dgamma] / subject.modulus)

    def one(given: float) -> float:
        return radius(subject, lambda x: depth(x) - given)

    return np.array([one(float(x)) for x in d])


def table_radius(subject: Subject, d: Array, count: int) -> Array:
    """A table of d(a) on a uniform grid from a/2 on, read by linear interpolation."""
    x = np.linspace(RADIUS / 2, RADIUS, count + 1)
    return np.interp(d, subject.depth(x), x)


def mpmath_radius(subject: Subject, d: Array, digits: int) -> list[mp.mpf]:
    """Contact radius with adhesion at each depth: mpmath's quadrature and secant method at this many digits."""
    with mp.workdps(digits):
        dgamma, modulus = (mp.mpf(x) for x in (subject.values[nt.dgamma], subject.modulus))

        def depth(x: mp.mpf) -> mp.mpf:
            free = x * mp.quad(lambda u: subject.slope_mp(x * mp.sin(u)), [0, mp.pi / 2])
            return free - mp.sqrt(2 * mp.pi * x * dgamma / modulus)

        def one(given: mp.mpf) -> mp.mpf:
            start = mp.mpf(radius(subject, lambda x: float(subject.depth(np.float64(x)) - float(given))))
            nearby = start * (1 + mp.mpf(10) ** (-min(digits, 15) // 2))
            return mp.findroot(lambda x: depth(x) / given - 1, (start, nearby), tol=mp.eps**1.5, verify=False)

        return [one(mp.mpf(float(x))) for x in d]
