"""The other ways on the graded half-space, from (11.61), (11.51), (11.53) and (11.56); the force without break.

With the weights of the grading: |t**2 - r**2|**((k - 1)/2) in the pressure, x**k in the displacement.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import mpmath as mp
import numpy as np
from scipy import integrate

from .problems import RADIUS
from .rivals import jacobi, radius, spans
from .subject import Array, Subject

a = RADIUS


def jacobi_displacement(subject: Subject, r: Array, count: int) -> Array:
    """In x with the power k; beyond a break in x - b, with the power (1 + k)/2 of what g has risen since."""
    k, total, depth = subject.exponent, 0.0, _depth(subject)
    for low, high in _spans(subject):
        span = partial(_jacobi_displacement, r, k, low, high, count)
        if low:
            start = _g(subject, low)
            total = total + (depth - start) * span(0.0, lambda x: 1.0)
            total = total - span((1 + k) / 2, partial(_above, subject, start))
        else:
            total = total - span(k, partial(_above, subject, depth))
    return _outside(k) * total


def _jacobi_displacement(
    r: Array, k: float, low: float, high: float, count: int, power: float, height: Callable[[float], float]
) -> Array:
    """Integral of x**k height(x) (r**2 - x**2)**(-(1 + k)/2), with a power of x - low in the weight."""
    total = 0.0
    for node, weight in zip(*jacobi(count, power, 0.0), strict=True):
        x = low + (high - low) * node
        total = total + weight * node**-power * x**k * height(x) * ((r - x) * (r + x)) ** (-(1 + k) / 2)
    return (high - low) * total


def jacobi_force(subject: Subject, d: Array, count: int) -> Array:
    """Depth and force over the profile, s = x sqrt(1 - y) with the power (k - 1)/2 of y; the radius by brentq."""
    k = subject.exponent
    nodes, weights = jacobi(count, (k - 1) / 2, 0.0)
    sines = np.sqrt(1 - nodes)

    def moment(x: float, power: int) -> float:
        return float(np.sum(weights * subject.slope(x * sines) * sines ** (power - 1))) / 2

    return _forces(subject, d, moment)


def quad_weighted_pressure(subject: Subject, r: Array) -> Array:
    """(11.53) of a profile without break given to scipy.integrate.quad with its weight for algebraic ends."""
    power = subject.power

    def one(r: float) -> float:
        return _quad(lambda t: subject.rate_scalar(t) * (t + r) ** power, r, a, power)

    return subject.modulus / np.pi * np.array([one(float(x)) for x in r])


def quad_displacement(subject: Subject, r: Array, *, weighted: bool) -> Array:
    """Displacement at radii r > a by scipy's quad; `weighted` gives it the power x**k as a weight."""
    k, depth = subject.exponent, _depth(subject)

    def one(r: float) -> float:
        def kernel(x: float) -> float:
            return (depth - _g(subject, x)) * ((r - x) * (r + x)) ** (-(1 + k) / 2)

        if weighted:
            return _quad(kernel, 0.0, a, k)
        return sum(_quad(lambda x: x**k * kernel(x), *span) for span in _spans(subject))

    return _outside(k) * np.array([one(float(x)) for x in r])


def quad_force(subject: Subject, d: Array) -> Array:
    """The script without closed forms: g by quad over the angle, its root by brentq, F by quad."""
    k = subject.exponent

    def moment(x: float, power: int) -> float:
        def integrand(y: float) -> float:
            return float(subject.slope(x * math.cos(y))) * math.cos(y) ** power * math.sin(y) ** k

        return _quad(integrand, 0.0, math.pi / 2)

    return _forces(subject, d, moment)


def mpmath_pressure(subject: Subject, r: Array, digits: int) -> list[mp.mpf]:
    """(11.53) from break to break in u = t - low: a node that rounding takes below r would have a complex power."""
    with mp.workdps(digits):
        power = (mp.mpf(subject.exponent) - 1) / 2

        def rate(t: mp.mpf, low: mp.mpf) -> mp.mpf:
            # rounding takes the first nodes to a break
            return subject.rate_mp(t) if t > low or low not in breaks else mp.mpf(0)

        def span(r: mp.mpf, low: mp.mpf, high: mp.mpf) -> mp.mpf:
            return mp.quad(lambda u: rate(low + u, low) * ((u + (low - r)) * (u + low + r)) ** power, [0, high - low])

        def one(r: mp.mpf) -> mp.mpf:
            total = mp.fsum(span(r, max(r, low), high) for low, high in pieces if high > r)
            return total + subject.excess_mp() * ((a - r) * (a + r)) ** power

        pieces = [(mp.mpf(low), mp.mpf(high)) for low, high in spans(subject, a)]
        breaks = [low for low, _ in pieces if low]
        return [subject.modulus * one(mp.mpf(float(x))) / mp.pi for x in r]


def mpmath_displacement(subject: Subject, r: Array, digits: int) -> list[mp.mpf]:
    """Displacement at radii r > a by mpmath's quadrature at this many digits."""
    with mp.workdps(digits):
        k, edge = mp.mpf(subject.exponent), mp.mpf(subject.edge)
        depth = subject.depth_mp(mp.mpf(a)) + subject.excess_mp()
        ends = [0, *(high for _, high in _spans(subject))]

        def free(x: mp.mpf) -> mp.mpf:
            return depth - subject.depth_mp(x) if x > edge else depth

        def one(r: mp.mpf) -> mp.mpf:
            kernel = mp.quad(lambda x: x**k * free(x) * ((r - x) * (r + x)) ** (-(1 + k) / 2), ends)
            return 2 * mp.cos(k * mp.pi / 2) / mp.pi * kernel

        return [one(mp.mpf(float(x))) for x in r]


def mpmath_force(subject: Subject, d: Array, digits: int) -> list[mp.mpf]:
    """Depth and force by mpmath.quad over the angle, the radius by its secants."""
    with mp.workdps(digits):
        k = mp.mpf(subject.exponent)

        def moment(x: mp.mpf, power: int) -> mp.mpf:
            def integrand(y: mp.mpf) -> mp.mpf:
                cosine = abs(mp.cos(y))  # rounding takes the last nodes beyond pi/2
                return subject.slope_mp(x * cosine) * cosine**power * mp.sin(y) ** k

            return mp.quad(integrand, [0, mp.pi / 2])

        def force(depth: mp.mpf) -> mp.mpf:
            start = mp.mpf(radius(subject, lambda x: float(subject.depth(np.float64(x)) - float(depth))))
            nearby = start * (1 + mp.mpf(10) ** (-min(digits, 15) // 2))
            gap: Callable[[mp.mpf], mp.mpf] = lambda x: x * moment(x, 0) / depth - 1  # noqa: E731 - one line, one use
            root = mp.findroot(gap, (start, nearby), tol=mp.eps**1.5, verify=False)
            return 2 * subject.modulus / (1 + k) * root ** (2 + k) * moment(root, 2)

        return [force(mp.mpf(float(x))) for x in d]


def _forces(subject: Subject, d: Iterable[Any], moment: Callable[[float, int], float]) -> Array:
    """F(d) from the moments int f'(x s) s**power of a radius x, s = cos(y) with the weight sin(y)**k."""
    k = subject.exponent

    def force(depth: float) -> float:
        x = radius(subject, lambda x: x * moment(x, 0) - depth)
        return 2 * subject.modulus / (1 + k) * x ** (2 + k) * moment(x, 2)

    return np.array([force(float(x)) for x in d])


def _spans(subject: Subject) -> list[tuple[float, float]]:
    """From break to break, the flat face among them."""
    face = [(0.0, subject.edge)] if subject.edge else []
    return [*face, *spans(subject, a)]


def _g(subject: Subject, x: float) -> float:
    return float(subject.depth(np.float64(x)))


def _above(subject: Subject, start: float, x: float) -> float:
    return _g(subject, x) - start


def _depth(subject: Subject) -> float:
    return _g(subject, a) + subject.excess


def _outside(k: float) -> float:
    return 2 * math.cos(k * math.pi / 2) / math.pi


def _quad(integrand: Callable[[float], float], low: float, high: float, power: float | None = None) -> float:
    """With the weight (x - low)**power, where one is given."""
    weight: dict[str, Any] = {} if power is None else {"weight": "alg", "wvar": (power, 0.0)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its error estimate; what the error is, the study measures
        value, _ = integrate.quad(integrand, low, high, epsabs=0.0, epsrel=1e-13, limit=200, **weight)
    return float(value)
