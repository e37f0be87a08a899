"""Integrals over the growth of the contact, by Gauss-Legendre rules after a substitution that makes them regular.

A contact of radius a is the sum of flat punches of radius t < a, each pressed
in by g'(t) dt, where g(t) is the indentation depth.  `slope` gives g'(t); the
integrands are positive where g' is, so that nothing cancels.  Each substitution
keeps the singularities of g' and of the kernel pi/2 away from the path.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from ._elementwise import BLOCK, Array
from ._nodes import gauss_legendre

Slope = Callable[..., Array]
PANELS = 4096
"""Waves in the contact beyond which the rule for a wavy profile is no longer refined."""


def integral(integrand: Callable[[Array], Array], stop: Array, count: int) -> Array:
    """Integral of `integrand` from 0 to `stop`, elementwise, with `count` nodes along a new first axis."""
    nodes, weights = (column.reshape(-1, *(1,) * np.ndim(stop)) for column in gauss_legendre(count))
    total = np.zeros_like(stop)
    step = max(1, BLOCK // max(1, np.size(stop)))
    for first in range(0, count, step):
        part = slice(first, first + step)
        total = total + np.sum(weights[part] * integrand(nodes[part] * stop), axis=0)
    return total * stop


def integral_by_panels(integrand: Callable[[Array], Array], stop: Array, width: Array, count: int) -> Array:
    """The same in equal panels no wider than about `width`; their number follows the largest `stop` of the block."""
    largest = np.max(np.where(np.isfinite(stop), stop / width, 0.0), initial=1.0)
    panels = int(np.ceil(min(float(largest), PANELS)))
    width, total = stop / panels, np.zeros_like(stop)
    for panel in range(panels):
        start = panel * width
        total = total + integral(partial(_shifted, integrand, start), width, count)
    return total


def _shifted(integrand: Callable[[Array], Array], start: Array, x: Array) -> Array:
    return integrand(start + x)


def difference_root(x: Array, y: Array) -> Array:
    """sqrt(x**2 - y**2), and zero for x < y."""
    return np.sqrt(np.maximum(x - y, 0.0) * (x + y))


def pressure_integral(slope: Slope, r: Array, a: Array, count: int) -> Array:
    """Integral of g'(t)/sqrt(t**2 - r**2) from r to a, for g'(t)/t without singularities near."""

    def integrand(u: Array) -> Array:
        t = np.sqrt(r * r + u * u)
        return slope(t) / t

    return integral(integrand, difference_root(a, r), count)


def pressure_integral_waves(slope: Slope, r: Array, a: Array, wavelength: Array, count: int) -> Array:
    """The same where g' oscillates with a wavelength."""

    def integrand(u: Array) -> Array:
        t = np.sqrt(r * r + u * u)
        return slope(t) / t

    return integral_by_panels(integrand, difference_root(a, r), wavelength, count)


def pressure_integral_sinh(slope: Slope, r: Array, a: Array, b: Array, count: int) -> Array:
    """The same where g' has a singularity at t**2 = -b**2."""
    scale = np.sqrt(r * r + b * b)

    def integrand(v: Array) -> Array:
        u = scale * np.sinh(v)
        t = np.sqrt(r * r + u * u)
        return slope(t) / t * np.cosh(v)

    return scale * integral(integrand, np.arcsinh(difference_root(a, r) / scale), count)


def pressure_integral_tanh(slope: Slope, r: Array, a: Array, R: Array, count: int) -> Array:
    """The same where g' has a singularity at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    scale = difference_root(R, r)

    def integrand(v: Array) -> Array:
        u, root = scale * np.tanh(v), scale / np.cosh(v)
        t = np.sqrt(r * r + u * u)
        return slope(t, root) / t * (root / np.cosh(v))

    stop = np.arcsinh(difference_root(a, r) / difference_root(R, a))
    return np.where(a < R, integral(integrand, stop, count), np.inf)


def pressure_integral_beyond(slope: Slope, r: Array, a: Array, b: Array, count: int) -> Array:
    """The same from max(r, b) to a, with a break of the profile at b; `slope` takes t and sqrt(t**2 - b**2)."""
    # on the outer side of the break, where the part below it adds nothing
    r = np.where(r == b, np.nextafter(b, np.inf), r)
    within = r < b
    scale = np.sqrt(np.abs(r - b) * (r + b))
    span = np.where(within, difference_root(a, b), difference_root(a, r)) / scale

    def integrand(v: Array) -> Array:
        root = scale * np.where(within, np.sinh(v), np.cosh(v))
        t = np.sqrt(b * b + root * root)
        return slope(t, root) * root / t

    return np.where(a > np.maximum(r, b), integral(integrand, np.arcsinh(span), count), 0.0)


def displacement_integral(slope: Slope, r: Array, a: Array, count: int) -> Array:
    """Integral of g'(t) arcsin(t/r) from 0 to a, for a < r and g' without singularities near."""

    def integrand(angle: Array) -> Array:
        return slope(r * np.sin(angle)) * angle * np.cos(angle)

    return r * integral(integrand, np.arctan2(a, difference_root(r, a)), count)


def displacement_integral_waves(slope: Slope, r: Array, a: Array, wavelength: Array, count: int) -> Array:
    """The same where g' oscillates with a wavelength."""

    def integrand(angle: Array) -> Array:
        return slope(r * np.sin(angle)) * angle * np.cos(angle)

    return r * integral_by_panels(integrand, np.arctan2(a, difference_root(r, a)), wavelength / r, count)


def displacement_integral_sinh(slope: Slope, r: Array, a: Array, b: Array, count: int) -> Array:
    """The same where g' has a singularity at t**2 = -b**2."""
    scale = b / np.sqrt(r * r + b * b)

    def integrand(v: Array) -> Array:
        tangent = scale * np.sinh(v)
        secant = np.sqrt(1.0 + tangent * tangent)
        return slope(r * tangent / secant) * np.arctan(tangent) * np.cosh(v) / secant**3

    return r * scale * integral(integrand, np.arcsinh(a / difference_root(r, a) / scale), count)


def displacement_integral_tanh(slope: Slope, r: Array, a: Array, R: Array, count: int) -> Array:
    """The same where g' has a singularity at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    scale = np.minimum(r, R)

    def integrand(v: Array) -> Array:
        t, part = scale * np.tanh(v), scale / np.cosh(v)
        beyond = np.sqrt(difference_root(r, R) ** 2 + part * part)
        root = np.sqrt(difference_root(R, r) ** 2 + part * part)
        return slope(t, root) * np.arctan2(t, beyond) * (part / np.cosh(v))

    stop = np.arcsinh(a / difference_root(scale, a))
    return np.where(a < scale, integral(integrand, stop, count), np.inf)


def displacement_integral_beyond(slope: Slope, r: Array, a: Array, b: Array, count: int) -> Array:
    """The same from b to a, with a break of the profile at b; `slope` takes t and sqrt(t**2 - b**2)."""
    reach = difference_root(r, b)

    def integrand(v: Array) -> Array:
        tangent = b / r * np.sinh(v)
        secant = np.sqrt(1.0 + tangent * tangent)
        root = reach * tangent / secant
        t = np.sqrt(b * b + root * root)
        return slope(t, root) * root / t * np.arctan2(t, reach / secant) * np.cosh(v) / secant**3

    stop = np.arcsinh(r / b * difference_root(a, b) / difference_root(r, a))
    return np.where(a > b, reach * (b / r) * integral(integrand, stop, count), 0.0)


def force_integral(slope: Slope, a: Array, count: int) -> Array:
    """Integral of t g'(t) from 0 to a, for g' without singularities near."""
    return integral(lambda t: t * slope(t), a, count)


def force_integral_beyond(slope: Slope, a: Array, b: Array, count: int) -> Array:
    """The same from b to a, with a break of the profile at b; `slope` takes t and sqrt(t**2 - b**2)."""

    def integrand(v: Array) -> Array:
        root = b * np.sinh(v)
        return slope(np.sqrt(b * b + root * root), root) * root * np.cosh(v)

    return b * integral(integrand, np.arcsinh(difference_root(a, b) / b), count)
