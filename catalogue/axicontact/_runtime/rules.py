"""Integrals over the growth of the contact, by Gauss-Legendre rules after a substitution that makes them regular.

A contact of radius a is the sum of flat punches of radius t < a, each pressed
in by g'(t) dt, where g(t) is the indentation depth.  `slope` gives g'(t); the
integrands are positive where g' is, so that nothing cancels.  Each substitution
keeps the singularities of g' and of the kernel pi/2 away from the path.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .integrals import (
    WAVES,
    Slope,
    Strip,
    difference_root,
    in_groups,
    integral,
    integral_in_strip,
    of_displacement,
    of_pressure,
    over_radii,
)
from .interface import Array


def pressure_integral(slope: Slope, r: Array, a: Array, count: int) -> Array:
    """Integral of g'(t)/sqrt(t**2 - r**2) from r to a, for g'(t)/t without singularities near."""

    def integrand(u: Array) -> Array:
        t = np.sqrt(r * r + u * u)
        return slope(t) / t

    return integral(integrand, difference_root(a, r), count)


def pressure_integral_waves(slope: Slope, r: Array, a: Array, wavelength: Array) -> Array:
    """Integral of g'(t)/sqrt(t**2 - r**2) from r to a, where g' oscillates with a wavelength."""

    def integrand(u: Array) -> Array:
        t = np.sqrt(r * r + u * u)
        return slope(t) / t

    return integral_in_strip(integrand, difference_root(a, r), wavelength, WAVES)


def falling(stop: Array, even: Array | float = 0.0) -> Callable[[Array], Array]:
    """sinh(stop - v)/sinh(stop) as a function of v, or the same of cosh where `even` is 1.

    Counted from the upper end, where the integrands are largest: an error of v in exp(v) would grow with v.
    """
    side = 1.0 - 2.0 * even
    below = 2.0 * even - side * np.expm1(-2.0 * stop)
    # a contact of no extent
    below = np.where(below > 0.0, below, np.inf)

    def fallen(v: Array) -> Array:
        return np.exp(-v) * (2.0 * even - side * np.expm1(-2.0 * (stop - v))) / below

    return fallen


@in_groups
def pressure_integral_sinh(slope: Slope, r: Array, a: Array, b: Array) -> Strip:
    """Integral of g'(t)/sqrt(t**2 - r**2) from r to a, where g' has a singularity at t**2 = -b**2."""
    scale, reach = np.sqrt(r * r + b * b), difference_root(a, r)
    stop = np.arcsinh(reach / scale)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        u = reach * fallen(v)
        t = np.sqrt(r * r + u * u)
        return slope(t) / t * np.sqrt(scale * scale + u * u)

    return integrand, stop, 1.0, True, 0.0


@in_groups
def pressure_integral_tanh(slope: Slope, r: Array, a: Array, R: Array) -> Strip:
    """Integral of g'(t)/sqrt(t**2 - r**2) from r to a, g' singular at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    scale = difference_root(R, r)
    ratio = difference_root(a, r) / difference_root(R, a)
    stop = np.arcsinh(ratio)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        side = ratio * fallen(v)
        secant = np.sqrt(1.0 + side * side)
        u, root = scale * (side / secant), scale / secant
        t = np.sqrt(r * r + u * u)
        return slope(t, root) / t * (root / secant)

    return integrand, stop, 1.0, a < R, np.inf


@over_radii(of_pressure)
@in_groups
def pressure_integral_beyond(slope: Slope, r: Array, a: Array, b: Array) -> Strip:
    """Integral of g'(t)/sqrt(t**2 - r**2) from max(r, b) to a > b; `slope` takes t and sqrt(t**2 - b**2)."""
    # on the outer side of the break, where the part below it adds nothing
    r = np.where(r == b, np.nextafter(b, np.inf), r)
    within = r < b
    outside, reach = np.where(within, 0.0, 1.0), difference_root(a, b)
    stop = np.arcsinh(np.where(within, reach, difference_root(a, r)) / np.sqrt(np.abs(r - b) * (r + b)))
    fallen = falling(stop, outside)

    def integrand(v: Array) -> Array:
        root = reach * fallen(v)
        t = np.sqrt(b * b + root * root)
        return slope(t, root) * root / t

    return integrand, stop, 1.0, a > np.maximum(r, b), 0.0


@in_groups
def peak_integral_beyond(slope: Slope, share: Array, a: Array, b: Array) -> Strip:
    """The same from r = b + share*(a - b), which next to a = b says less than the share."""
    r, reach = b + share * (a - b), difference_root(a, b)
    stop = np.arcsinh(np.sqrt((1.0 - share) * (a + r) / (share * (r + b))))
    fallen = falling(stop, 1.0)

    def integrand(v: Array) -> Array:
        root = reach * fallen(v)
        t = np.sqrt(b * b + root * root)
        return slope(t, root) * root / t

    return integrand, stop, 1.0, a > b, 0.0


@over_radii(of_displacement)
def displacement_integral(slope: Slope, parameters: tuple[Array, ...], r: Array, a: Array, count: int) -> Array:
    """Integral of g'(t) arcsin(t/r) from 0 to a, for a < r and g' without singularities near."""

    def integrand(angle: Array) -> Array:
        return slope(r * np.sin(angle), *parameters) * angle * np.cos(angle)

    return r * integral(integrand, np.arctan2(a, difference_root(r, a)), count)


def displacement_integral_waves(slope: Slope, r: Array, a: Array, wavelength: Array) -> Array:
    """Integral of g'(t) arcsin(t/r) from 0 to a < r, where g' oscillates with a wavelength."""

    def integrand(angle: Array) -> Array:
        return slope(r * np.sin(angle)) * angle * np.cos(angle)

    # the angle itself counts half a wave per radian
    width = wavelength / (r + wavelength / 2.0)
    return r * integral_in_strip(integrand, np.arctan2(a, difference_root(r, a)), width, WAVES)


@over_radii(of_displacement)
@in_groups
def displacement_integral_sinh(slope: Slope, r: Array, a: Array, b: Array) -> Strip:
    """Integral of g'(t) arcsin(t/r) from 0 to a < r, where g' has a singularity at t**2 = -b**2."""
    scale, end = b / np.sqrt(r * r + b * b), a / difference_root(r, a)
    stop = np.arcsinh(end / scale)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        tangent = end * fallen(v)
        secant = np.sqrt(1.0 + tangent * tangent)
        weight = np.sqrt(scale * scale + tangent * tangent) / (secant * secant * secant)
        return slope(r * tangent / secant) * np.arctan(tangent) * weight

    return integrand, stop, r, True, 0.0


@over_radii(of_displacement)
@in_groups
def displacement_integral_tanh(slope: Slope, r: Array, a: Array, R: Array) -> Strip:
    """Integral of g'(t) arcsin(t/r) from 0 to a < r, g' singular at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    scale = np.minimum(r, R)
    end = a / difference_root(scale, a)
    stop = np.arcsinh(end)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        side = end * fallen(v)
        secant = np.sqrt(1.0 + side * side)
        t, part = scale * (side / secant), scale / secant
        beyond = np.sqrt(difference_root(r, R) ** 2 + part * part)
        root = np.sqrt(difference_root(R, r) ** 2 + part * part)
        return slope(t, root) * np.arctan2(t, beyond) * (part / secant)

    return integrand, stop, 1.0, a < scale, np.inf


@over_radii(of_displacement)
@in_groups
def displacement_integral_beyond(slope: Slope, r: Array, a: Array, b: Array) -> Strip:
    """Integral of g'(t) arcsin(t/r) from b to a < r; `slope` takes t and sqrt(t**2 - b**2)."""
    reach, ratio = difference_root(r, b), b / r
    end = difference_root(a, b) / difference_root(r, a)
    stop = np.arcsinh(end / ratio)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        tangent = end * fallen(v)
        secant = np.sqrt(1.0 + tangent * tangent)
        root = reach * tangent / secant
        t = np.sqrt(b * b + root * root)
        weight = np.sqrt(ratio * ratio + tangent * tangent) / (secant * secant * secant)
        return slope(t, root) * root / t * np.arctan2(t, reach / secant) * weight

    return integrand, stop, reach, a > b, 0.0


def force_integral(slope: Slope, a: Array, count: int) -> Array:
    """Integral of t g'(t) from 0 to a, for g' without singularities near."""
    return integral(lambda t: t * slope(t), a, count)


@in_groups
def force_integral_beyond(slope: Slope, reach: Array, b: Array) -> Strip:
    """Integral of t g'(t) from b to sqrt(b**2 + reach**2); `slope` takes t and sqrt(t**2 - b**2)."""
    stop = np.arcsinh(reach / b)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        root = reach * fallen(v)
        t = np.sqrt(b * b + root * root)
        return slope(t, root) * root * t

    return integrand, stop, 1.0, True, 0.0
