"""Other ways to the same numbers, each written from its definition: quadrature rules, grids, scripts, digits.

Pressure (11.23), displacement (11.26) and F(d) from (11.29), (11.20).  The
grid methods follow their descriptions, not their authors' programs: by parts
with central differences and trapezoids (Benad 2018), convolution over r**2 by
FFT (Willert 2021).
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from functools import cache

import mpmath as mp
import numpy as np
from scipy import integrate, optimize, signal, special

from .subject import RADIUS, Array, Subject

a = RADIUS


@cache
def jacobi(count: int, lower: float, upper: float) -> tuple[Array, Array]:
    """Nodes on (0, 1) and weights for x**lower (1 - x)**upper."""
    nodes, weights = special.roots_jacobi(count, upper, lower)
    return (1 + nodes) / 2, weights / 2 ** (1 + upper + lower)


def jacobi_pressure(subject: Subject, r: Array, count: int) -> Array:
    """In t**2, whose distance from the lower limit carries the power -1/2; the break is such a limit."""
    low = np.maximum(r, subject.edge)
    width, total = (a - low) * (a + low), 0.0
    for node, weight in zip(*jacobi(count, -0.5, 0.0), strict=True):
        past = width * node
        t = np.sqrt(low * low + past)
        kernel = np.sqrt(past / (past + (low - r) * (low + r)))
        total = total + weight * subject.rate(t) / (2 * t) * kernel
    return subject.modulus / np.pi * np.sqrt(width) * total


def jacobi_displacement(subject: Subject, r: Array, count: int) -> Array:
    """In t - b, with the power -1/2 that g' may have at a break; no singularity without one."""
    b = subject.edge
    power, total = (-0.5 if b else 0.0), 0.0
    for node, weight in zip(*jacobi(count, power, 0.0), strict=True):
        t = b + (a - b) * node
        total = total + weight * node**-power * float(subject.rate(t)) * np.arcsin(t / r)
    return 2 / np.pi * (a - b) * total


def jacobi_force(subject: Subject, d: Array, count: int) -> Array:
    """Depth and force over the profile with the power -1/2 at r = a; the radius by brentq."""
    b = subject.edge
    nodes, weights = jacobi(count, 0.0, -0.5)

    def moment(x: float, power: int) -> float:
        s = b + (x - b) * nodes
        return math.sqrt(x - b) * float(np.sum(weights * subject.slope(s) * s**power / np.sqrt(x + s)))

    def force(depth: float) -> float:
        return 2 * subject.modulus * moment(radius(subject, lambda x: x * moment(x, 0) - depth), 2)

    return np.array([force(float(depth)) for depth in d])


def quad_pressure(subject: Subject, r: Array, *, substituted: bool) -> Array:
    """The integral (11.23) given to scipy.integrate.quad as it stands, or in t = r cosh(v)."""

    def one(r: float) -> float:
        low = max(r, subject.edge)
        if substituted:
            ends = math.acosh(low / r), math.acosh(a / r)
            return quad(lambda v: subject.rate_scalar(r * math.cosh(v)), *ends)
        return quad(lambda t: subject.rate_scalar(t) / math.sqrt((t - r) * (t + r)), low, a)

    return subject.modulus / np.pi * np.array([one(float(x)) for x in r])


def quad_displacement(subject: Subject, r: Array) -> Array:
    def one(r: float) -> float:
        return quad(lambda t: subject.rate_scalar(t) * math.asin(t / r), subject.edge, a)

    return 2 / np.pi * np.array([one(float(x)) for x in r])


def quad_force(subject: Subject, d: Array) -> Array:
    """The script without closed forms: g by quad, its root by brentq, F by quad over g."""
    b = subject.edge

    def depth(x: float) -> float:
        low = math.asin(min(b / x, 1.0)) if b else 0.0
        return x * quad(lambda u: float(subject.slope(x * math.sin(u))), low, math.pi / 2)

    def force(given: float) -> float:
        beyond = quad(lambda t: given - depth(t), b, radius(subject, lambda x: depth(x) - given), tolerance=1e-10)
        return 2 * subject.modulus * (given * b + beyond)

    return np.array([force(float(x)) for x in d])


def trapezoid_pressure(subject: Subject, count: int) -> tuple[Array, Array]:
    """By parts, central differences and trapezoids on a uniform grid: radii and pressures."""
    x = np.linspace(0.0, a, count + 1)
    first = np.gradient(subject.depth(x), x, edge_order=2)
    second = np.gradient(first, x, edge_order=2)
    r = x[1:-1]
    kernel = np.arccosh(np.maximum(x / r[:, None], 1.0))
    kernel[:, -1] /= 2
    return r, subject.modulus / np.pi * (first[-1] * np.arccosh(a / r) - x[1] * (kernel @ second))


def trapezoid_displacement(subject: Subject, r: Array, count: int) -> Array:
    """Trapezoids over w_1D/sqrt(r**2 - x**2) on the same grid."""
    x = np.linspace(0.0, a, count + 1)
    sunk = subject.depth(np.float64(a)) - subject.depth(x)
    return 2 / np.pi * integrate.trapezoid(sunk / np.sqrt((r[:, None] - x) * (r[:, None] + x)), x, axis=1)


def trapezoid_force(subject: Subject, d: Array, count: int) -> Array:
    """A table of g on the grid, the radius by interpolation, the force by trapezoids."""
    x = np.linspace(0.0, a, count + 1)
    depth = subject.depth(x)
    below = np.concatenate([[0.0], np.cumsum((depth[1:] + depth[:-1]) / 2) * x[1]])
    first = int(np.searchsorted(x, subject.edge))
    reached = np.interp(d, depth[first:], x[first:])
    return 2 * subject.modulus * (d * reached - np.interp(reached, x, below))


def fft_pressure(subject: Subject, count: int) -> tuple[Array, Array]:
    """Convolution over r**2 with exact weights in each cell: radii and pressures.

    The density g'/(2x) is linear in a cell, or constant where it is infinite at a break.
    """
    squares = np.linspace(0.0, a * a, count + 1)
    x = np.sqrt(squares)
    rise = np.diff(subject.depth(x)) / squares[1]
    if subject.edge and not np.isfinite(_silent(subject.rate_scalar, subject.edge)):
        total = _convolution_of_steps(rise[::-1], squares[1])[::-1]
    else:
        density = np.append(rise[0], subject.rate(x[1:]) / (2 * x[1:]))
        total = _convolution(density[::-1], squares[1], count + 1)[::-1]
    return x[1:-1], subject.modulus / np.pi * total[1:-1]


def fft_displacement(subject: Subject, count: int) -> tuple[Array, Array]:
    """The same for w = 2/pi (d asin(a/r) - int g/sqrt(r**2 - x**2) dx), a < r < 2a."""
    squares = np.linspace(0.0, 4 * a * a, 4 * count + 1)
    x = np.sqrt(squares)
    near = x[: count + 1].copy()
    near[0] = 1e-8 * a
    total = _convolution(subject.depth(near) / (2 * near), squares[1], len(squares))
    w = 2 / np.pi * (subject.depth(np.float64(a)) * np.arcsin(np.minimum(a / x[1:], 1.0)) - total[1:])
    return x[count + 1 :], w[count:]


def _convolution(density: Array, cell: float, size: int) -> Array:
    """int density(y) (x - y)**(-1/2) dy from 0 to x at x = 0, cell, ..., the density linear between its nodes."""
    lag = np.arange(size, dtype=np.float64)
    zeroth, first = np.diff(2 * np.sqrt(lag)), np.diff(2 / 3 * lag**1.5)
    far, near = first - lag[:-1] * zeroth, lag[1:] * zeroth - first
    total = np.zeros(size)
    total[1:] += signal.fftconvolve(density[:-1], far)[: size - 1]
    inner = density.copy()
    inner[0] = 0.0
    total[: size - 1] += signal.fftconvolve(inner, near)[: size - 1]
    return math.sqrt(cell) * total


def _convolution_of_steps(density: Array, cell: float) -> Array:
    """The same for a density that is constant in each cell."""
    weights = np.diff(2 * np.sqrt(np.arange(len(density) + 1, dtype=np.float64)))
    total = signal.fftconvolve(density, weights)[: len(density)]
    return math.sqrt(cell) * np.append(0.0, total)


def _silent(function: Callable[[float], float], x: float) -> float:
    try:
        return function(x)
    except ZeroDivisionError:
        return math.inf


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
