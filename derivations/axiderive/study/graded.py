"""The other ways on the graded half-space, from (11.61), (11.51), (11.53) and (11.56) for a profile without break.

With the weights of the grading: |t**2 - r**2|**((k - 1)/2) in the pressure, x**k in the displacement.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable
from typing import Any

import mpmath as mp
import numpy as np
from scipy import integrate

from .rivals import jacobi, radius
from .special_functions import Array
from .subject import RADIUS, Subject

a = RADIUS


def jacobi_pressure(subject: Subject, r: Array, count: int) -> Array:
    """In t**2, whose distance from r**2 carries the power (k - 1)/2."""
    power = (subject.exponent - 1) / 2
    width, total = (a - r) * (a + r), 0.0
    for node, weight in zip(*jacobi(count, power, 0.0), strict=True):
        t = np.sqrt(r * r + width * node)
        total = total + weight * subject.rate(t) / (2 * t)
    return subject.modulus / np.pi * width ** (1 + power) * total


def jacobi_displacement(subject: Subject, r: Array, count: int) -> Array:
    """In x with the power k."""
    k, total, depth = subject.exponent, 0.0, float(subject.depth(np.float64(a)))
    for node, weight in zip(*jacobi(count, k, 0.0), strict=True):
        x = a * node
        total = total + weight * (depth - float(subject.depth(np.float64(x)))) * ((r - x) * (r + x)) ** (-(1 + k) / 2)
    return _outside(k) * a ** (1 + k) * total


def jacobi_force(subject: Subject, d: Array, count: int) -> Array:
    """Depth and force over the profile, s = x sqrt(1 - y) with the power (k - 1)/2 of y; the radius by brentq."""
    k = subject.exponent
    nodes, weights = jacobi(count, (k - 1) / 2, 0.0)
    sines = np.sqrt(1 - nodes)

    def moment(x: float, power: int) -> float:
        return float(np.sum(weights * subject.slope(x * sines) * sines ** (power - 1))) / 2

    return _forces(subject, d, moment)


def quad_pressure(subject: Subject, r: Array, *, weighted: bool) -> Array:
    """(11.53) given to scipy.integrate.quad as it stands, or with its weight for algebraic ends."""
    power = (subject.exponent - 1) / 2

    def one(r: float) -> float:
        if weighted:
            return _quad(lambda t: subject.rate_scalar(t) * (t + r) ** power, r, a, power)
        return _quad(lambda t: subject.rate_scalar(t) * ((t - r) * (t + r)) ** power, r, a)

    return subject.modulus / np.pi * np.array([one(float(x)) for x in r])


def quad_displacement(subject: Subject, r: Array, *, weighted: bool) -> Array:
    k, depth = subject.exponent, float(subject.depth(np.float64(a)))

    def one(r: float) -> float:
        def kernel(x: float) -> float:
            return (depth - float(subject.depth(np.float64(x)))) * ((r - x) * (r + x)) ** (-(1 + k) / 2)

        return _quad(kernel, 0.0, a, k) if weighted else _quad(lambda x: x**k * kernel(x), 0.0, a)

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
    """(11.53) in u = t - r: a node that rounding takes below r would have a complex power."""
    with mp.workdps(digits):
        power = (mp.mpf(subject.exponent) - 1) / 2

        def one(r: mp.mpf) -> mp.mpf:
            return mp.quad(lambda u: subject.rate_mp(r + u) * (u * (2 * r + u)) ** power, [0, a - r])

        return [subject.modulus * one(mp.mpf(float(x))) / mp.pi for x in r]


def mpmath_displacement(subject: Subject, r: Array, digits: int) -> list[mp.mpf]:
    with mp.workdps(digits):
        k, depth = mp.mpf(subject.exponent), subject.depth_mp(mp.mpf(a))

        def one(r: mp.mpf) -> mp.mpf:
            kernel = mp.quad(
                lambda x: x**k * (depth - subject.depth_mp(x)) * ((r - x) * (r + x)) ** (-(1 + k) / 2), [0, a]
            )
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


def _outside(k: float) -> float:
    return 2 * math.cos(k * math.pi / 2) / math.pi


def _quad(integrand: Callable[[float], float], low: float, high: float, power: float | None = None) -> float:
    """With the weight (x - low)**power, where one is given."""
    weight: dict[str, Any] = {} if power is None else {"weight": "alg", "wvar": (power, 0.0)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its error estimate; what the error is, the study measures
        value, _ = integrate.quad(integrand, low, high, epsabs=0.0, epsrel=1e-13, limit=200, **weight)
    return float(value)
