"""Displacement outside a contact on the graded half-space, from the displacement inside it.

With z = sqrt(a**2 - s**2) and q = sqrt(r**2 - a**2) the surface outside is
2/pi cos(pi k/2) q**(1 - k) times the integral of z**k (d - f(s))/(q**2 + z**2) over 0 < z < a:
the depth times the share of a flat punch, less the sag of the profile.  Up to z = a/2
in z = c sinh(v), which keeps z = i q away from the path, then in z = a sin(y).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array
from ._graded_growth import power_excess
from ._graded_rules import NODES, raised, sine_over, sinh_over, weighted
from ._integrals import difference_root, integral, integral_by_panels

Shape = Callable[[Array, Array], Array]
"""f as a function of s and z, with s**2 + z**2 = a**2."""
SPLIT = np.pi / 6.0
_SMOOTHING = 8


def _scale(k: Array) -> Array:
    """2/pi cos(pi k/2), without loss near k = -1 and 1."""
    return 2.0 / np.pi * np.sin(np.pi / 2.0 * (1.0 - np.abs(k)))


def punch_share(r: Array, a: Array, k: Array) -> Array:
    """w/d outside a flat punch, for r > a."""
    q = difference_root(r, a)
    stop = np.arcsinh(a / q)
    return _scale(k) * _from_edge(lambda s, z: np.ones_like(s), a, q, q, stop, k)


def power_sag(r: Array, a: Array, n: Array, k: Array) -> Array:
    """Of f = r**n."""
    q = difference_root(r, a)
    near = _from_edge(lambda s, z: (s / a) ** n, a, q, q, np.arcsinh(a / q / 2.0), k)

    whole = np.floor(n)
    weight = n - whole

    def smooth(x: Array) -> Array:
        # whole powers need no weight; with n in the weight the rule cancels for large n
        return sine_over(x) ** weight * np.sin(x) ** whole * _kernel(np.cos(x), np.sin(x), a / q, k)

    reach = np.pi / 2.0 - SPLIT
    far = reach**weight * reach * weighted(smooth, np.full_like(q, reach), weight)
    return _scale(k) * a**n * (near + far)


def power_displacement(r: Array, a: Array, n: Array, k: Array) -> Array:
    """The displacement of f = r**n inside and outside the contact: what d is above f(a), and f(a) above f(s)."""
    ratio = np.where(r < 0.5 * a, np.log(r / a), np.where(r < a, np.log1p((r - a) / a), 0.0))
    excess, inside = power_excess(n, k), -np.expm1(n * ratio)
    q = difference_root(r, a)
    near = _from_edge(lambda s, z: -np.expm1(n / 2.0 * np.log1p(-((z / a) ** 2))), a, q, q, np.arcsinh(a / q / 2.0), k)

    def smooth(u: Array) -> Array:
        # towards the axis the integrand ends in a power n, which this makes smooth for every n
        x = reach * u**_SMOOTHING
        fall = -np.expm1(n * np.log(np.sin(x))) * _kernel(np.cos(x), np.sin(x), a / q, k)
        return fall * _SMOOTHING * reach * u ** (_SMOOTHING - 1)

    reach = np.pi / 2.0 - SPLIT
    outside = excess * punch_share(r, a, k) + _scale(k) * (near + integral(smooth, np.ones_like(q), NODES))
    return np.where(a > 0.0, a**n * np.where(r > a, outside, excess + inside), 0.0)


def sphere_sag(r: Array, a: Array, R: Array, k: Array) -> Array:
    """Of a sphere of unit height over radius."""
    end = difference_root(R, a)
    return _smooth_sag(lambda s, z: s * s / (R + np.hypot(end, z)), r, a, k, end)


def hyperboloid_sag(r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f = sqrt(r**2 + b**2) - b."""
    return _tip_sag(lambda s, z: s * s / (b + np.hypot(s, b)), r, a, b, k)


def gaussian_sag(r: Array, a: Array, s: Array, k: Array) -> Array:
    """Of f = 1 - exp(-r**2/s**2)."""
    return _smooth_sag(lambda own, z: -np.expm1(-((own / s) ** 2)), r, a, k)


def waves_sag(r: Array, a: Array, q: Array, k: Array) -> Array:
    """Of f = 1 - cos(q r)."""
    return _wavy_sag(lambda s, z: 2.0 * np.sin(q * s / 2.0) ** 2, r, a, 2.0 * np.pi / q, k)


def rounding_sag(r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f' = r - b for r > b."""
    end = difference_root(a, b)
    return _sag_beyond(lambda s, z: ((end - z) * (end + z) / (s + b)) ** 2 / 2.0, r, a, b, k)


def rounded_sag(r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f' = r/b for r < b, 1 beyond."""
    tip = power_sag(r, a, 2.0, k) / (2.0 * b)
    outer = _sag_beyond(lambda s, z: s - b / 2.0, r, a, b, k)
    inner = _cap_sag(lambda s, z: s * s / (2.0 * b), r, a, b, k)
    return np.where(a <= b, tip, outer + inner)


def tipped_sag(r: Array, a: Array, R: Array, b: Array, end: Array, k: Array) -> Array:
    """Of the sphere R up to r = b, continued by its tangent cone."""
    height, slope = b * b / (R + end), b / end
    outer = _sag_beyond(lambda s, z: height + slope * (s - b), r, a, b, k)
    inner = _cap_sag(lambda s, z: s * s / (R + difference_root(R, s)), r, a, b, k)
    return np.where(a <= b, sphere_sag(r, np.minimum(a, b), R, k), outer + inner)


def _smooth_sag(shape: Shape, r: Array, a: Array, k: Array, c: Array | float = np.inf) -> Array:
    """Of f(s) without singularities near, but for one at z = i c."""
    q = difference_root(r, a)
    near = _from_edge(shape, a, q, np.minimum(q, c), np.arcsinh(a / np.minimum(q, c) / 2.0), k)
    return _scale(k) * (near + _to(shape, a, q, np.full_like(q, np.pi / 2.0), k))


def _tip_sag(shape: Shape, r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f(s) with a singularity at s = i b, close to the tip where b is small."""
    q = difference_root(r, a)
    near = _from_edge(shape, a, q, q, np.arcsinh(a / q / 2.0), k)
    ratio = b / a

    def smooth(x: Array) -> Array:
        y = ratio * np.sinh(x)
        value = shape(a * np.sin(y), a * np.cos(y)) * _kernel(np.cos(y), np.sin(y), a / q, k)
        return value * ratio * np.cosh(x)

    return _scale(k) * (near + integral(smooth, np.arcsinh((np.pi / 2.0 - SPLIT) / ratio), NODES))


def _wavy_sag(shape: Shape, r: Array, a: Array, wavelength: Array, k: Array) -> Array:
    """Of f(s) that oscillates with a wavelength."""
    q = difference_root(r, a)
    first = np.minimum(SPLIT, wavelength / a)
    near = _from_edge(shape, a, q, q, np.arcsinh(a * np.sin(first) / q), k)

    def smooth(y: Array) -> Array:
        sine, cosine = np.sin(first + y), np.cos(first + y)
        return shape(a * cosine, a * sine) * _kernel(sine, cosine, a / q, k)

    return _scale(k) * (near + integral_by_panels(smooth, np.pi / 2.0 - first, first, NODES))


def flank_sag(r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f' = 1 for r > b."""
    end = difference_root(a, b)
    return _sag_beyond(lambda s, z: (end - z) * (end + z) / (s + b), r, a, b, k)


def rim_sag(r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f' = r for r > b."""
    end = difference_root(a, b)
    return _sag_beyond(lambda s, z: (end - z) * (end + z) / 2.0, r, a, b, k)


def _sag_beyond(shape: Shape, r: Array, a: Array, b: Array, k: Array) -> Array:
    q, end = difference_root(r, a), difference_root(a, b)
    near = _from_edge(shape, a, q, q, np.arcsinh(np.minimum(end, a / 2.0) / q), k)
    value = _scale(k) * (near + _to(shape, a, q, np.maximum(np.arctan2(end, b), SPLIT), k))
    return np.where(a > b, value, 0.0)


def _cap_sag(shape: Shape, r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of a smooth f(s) that ends at s = b < a."""
    q, end = difference_root(r, a), difference_root(a, b)
    low, high = np.arcsinh(end / q), np.arcsinh(a / q / 2.0)
    low, high = np.maximum(low, 1e-300), np.maximum(low, high)
    middle = np.minimum(np.maximum(low, 1.0), high)

    def rise(start: Array, stop: Array) -> Array:
        def smooth(x: Array) -> Array:
            v = start * np.exp(x)
            z = q * np.sinh(v)
            return shape(difference_root(a, z), z) * np.sinh(v) ** k / np.cosh(v) * v

        return integral(smooth, np.log(stop / start), NODES)

    first = np.maximum(np.arctan2(end, b), SPLIT)
    return _scale(k) * (
        rise(low, middle) + rise(middle, high) + _to(shape, a, q, np.full_like(q, np.pi / 2.0), k, first)
    )


def _from_edge(shape: Shape, a: Array, q: Array, c: Array, stop: Array, k: Array) -> Array:
    """From z = 0 on in z = c sinh(v), in two panels of which the first carries the weight."""
    ratio = c / q

    def smooth(v: Array) -> Array:
        z = c * np.sinh(v)
        return shape(difference_root(a, z), z) * np.cosh(v) / (1.0 + (ratio * np.sinh(v)) ** 2)

    half = stop / 2.0
    first = raised(half, k) * weighted(lambda v: smooth(v) * sinh_over(v) ** k, half, k)
    second = integral(lambda v: smooth(half + v) * np.sinh(half + v) ** k, half, NODES)
    return raised(ratio, k) * (first + second)


def _to(shape: Shape, a: Array, q: Array, stop: Array, k: Array, start: Array | float = SPLIT) -> Array:
    def smooth(y: Array) -> Array:
        sine, cosine = np.sin(start + y), np.cos(start + y)
        return shape(a * cosine, a * sine) * _kernel(sine, cosine, a / q, k)

    return integral(smooth, stop - start, NODES)


def _kernel(sine: Array, cosine: Array, ratio: Array, k: Array) -> Array:
    """q**(1 - k) z**k dz/(q**2 + z**2) over dy, for z = a sin(y) and ratio = a/q."""
    return ratio * (ratio * sine) ** k * cosine / (1.0 + (ratio * sine) ** 2)
