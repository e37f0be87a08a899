"""Differences of two contacts whose radii c < a are close, as integrals over the growth from c to a."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array
from ._graded_punch import punch_stiffness
from ._integrals import difference_root, integral

CLOSE, NODES = 0.75, 32
Rate = Callable[..., Array]


def force_gain(
    outer: Array, inner: Array, rate: Rate, geometry: tuple[Array, ...], c: Array, a: Array, H: Array, k: Array
) -> Array:
    """F(a) - F(c), for g' without singularities near."""

    def growth(x: Array) -> Array:
        return punch_stiffness(c + x, H, k) * rate(c + x, *geometry)

    return _chosen(outer, inner, integral(growth, a - c, NODES), c > CLOSE * a)


def depth_gain(outer: Array, inner: Array, rate: Rate, geometry: tuple[Array, ...], c: Array, a: Array) -> Array:
    """g(a) - g(c)."""
    return _chosen(outer, inner, integral(lambda x: rate(c + x, *geometry), a - c, NODES), c > CLOSE * a)


def pressure_gain(
    outer: Array,
    inner: Array,
    rate: Rate,
    geometry: tuple[Array, ...],
    r: Array,
    c: Array,
    a: Array,
    H: Array,
    k: Array,
) -> Array:
    """p(r; a) - p(r; c) for r < c."""
    near, far = difference_root(c, r), difference_root(a, r)
    reach = (a - c) * (a + c) / (near + far)

    def growth(x: Array) -> Array:
        t = np.sqrt(r * r + (near + x) ** 2)
        return rate(t, *geometry) / t * (near + x) ** k

    return _chosen(outer, inner, H / np.pi * integral(growth, reach, NODES), near > CLOSE * far)


def _chosen(outer: Array, inner: Array, gain: Array, close: Array) -> Array:
    return np.where(close & np.isfinite(outer - inner), gain, outer - inner)
