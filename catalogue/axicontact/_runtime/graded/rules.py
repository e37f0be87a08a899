"""Integrals with an algebraic weight x**power at their lower end, for any power above -1.

On the graded half-space every integral over the growing contact carries such a
weight, with the exponent of grading in it.  The smooth factor is expanded in
Legendre polynomials at the nodes of Gauss; the moments of the weight are products
of rationals, so that the weights of the rule hold for any power and for arrays of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import numpy as np

from ..integrals import STRIPS, in_parts, summed
from ..interface import BLOCK, Array, Kept
from ..nodes import gauss_legendre

Smooth = Callable[[Array], Array]
NODES = 64


def nodes_for(length: Array) -> int:
    """Nodes of a product rule, twice those of Gauss, for singularities at a distance pi/2; see STRIPS."""
    longest = float(np.max(length, initial=0.0))
    for reached, count in STRIPS[:2]:
        if longest <= reached:
            return 2 * count
    return NODES


def weighted(smooth: Smooth, stop: Array, power: Array, count: int = NODES, above: Array | None = None) -> Array:
    """Integral of x**power smooth(x) from 0 to `stop`, over stop**(1 + power).

    `above` is 1 + power, where a rounded power would lose it: next to -1 the integral is one over it.
    """
    # from -0.5 on the plain weights do as well, but for 6 units at -0.48
    if np.all(np.asarray(power) >= -0.25):
        return _sum(smooth, stop, product_weights(power, count), count)
    # near -1 nearly all of the weight lies at the lower end, whose value is taken out
    above = 1.0 + power if above is None else above
    end = smooth(np.zeros((1, *np.shape(stop))))
    nodes, _ = gauss_legendre(count)
    weights = (product_weights(above, count).T / nodes).T
    return end[0] / above + _sum(lambda x: smooth(x) - end, stop, weights, count)


def _sum(smooth: Smooth, stop: Array, weights: Array, count: int) -> Array:
    nodes, _ = gauss_legendre(count)
    column = (-1, *(1,) * np.ndim(stop))
    weights = weights.reshape(count, *(1,) * (np.ndim(stop) + 1 - weights.ndim), *weights.shape[1:])
    size = math.prod(np.broadcast_shapes(np.shape(stop), weights.shape[1:]))
    parts = in_parts(count, BLOCK // max(1, size))
    return summed(weights[part] * smooth(nodes[part].reshape(column) * stop) for part in parts)


def over_quarter(of: Smooth, points: Array, k: Array) -> Array:
    """Integral of of(cos(y)) sin(y)**k over a quarter turn, whose nodes are the same for all `points`."""
    cosines, weights, whole = quarter(k)
    axes = np.ndim(points)
    cosines = cosines.reshape(-1, *(1,) * axes)
    weights = weights.reshape(NODES, *(1,) * (axes + 1 - weights.ndim), *weights.shape[1:])
    parts = in_parts(NODES, BLOCK // max(1, np.size(points)))
    if whole is None:
        return summed(weights[part] * of(cosines[part]) for part in parts)
    end = of(np.ones((1, *(1,) * axes)))
    return end[0] * whole + summed(weights[part] * (of(cosines[part]) - end) for part in parts)


@Kept
def quarter(k: Array) -> tuple[Array, Array, Array | None]:
    """Cosines of the nodes and their weights; near k = -1 for what vanishes at y = 0, with those of all of it."""
    k, angles = np.asarray(k, dtype=np.float64), np.pi / 2.0 * gauss_legendre(NODES)[0]
    scale, over = raised(np.pi / 2.0, k), np.power.outer(sine_over(angles), k)
    if np.all(k >= -0.25):
        return np.cos(angles), scale * product_weights(k, NODES) * over, None
    weights = (product_weights(1.0 + k, NODES).T / gauss_legendre(NODES)[0]).T
    return np.cos(angles), scale * weights * over, scale * (1.0 / (1.0 + k) + np.sum(weights * (over - 1.0), axis=0))


def product_weights(power: Array, count: int) -> Array:
    """Weights of the rule for x**power on (0, 1), along a first axis."""
    power = np.asarray(power, dtype=np.float64)
    return _weights_of_powers(power, count) if power.ndim else _weights_of_number(float(power), count)


@cache
def _weights_of_number(power: float, count: int) -> Array:
    return _weights_of_powers(np.asarray(power), count)


def _weights_of_powers(power: Array, count: int) -> Array:
    moment = 1.0 / (1.0 + power)
    moments = [moment]
    for j in range(1, count):
        moment = moment * (power + (1.0 - j)) / (power + (1.0 + j))
        moments.append(moment)
    return np.tensordot(legendre_table(count), np.stack(moments), axes=1)


@cache
def legendre_table(count: int) -> Array:
    """w_i (2 j + 1) P_j(x_i) for the nodes of Gauss on (0, 1)."""
    nodes, weights = gauss_legendre(count)
    x = 2.0 * nodes - 1.0
    columns = [np.ones_like(x), x]
    for j in range(1, count - 1):
        columns.append(((2 * j + 1) * x * columns[j] - j * columns[j - 1]) / (j + 1))
    return weights[:, None] * (2.0 * np.arange(count) + 1.0) * np.stack(columns, axis=1)


def raised(x: Array, k: Array) -> Array:
    """x**(1 + k), with no rounding of the exponent."""
    return np.where(x > 0.0, x * x**k, 0.0)


def sine_integral(angle: Array, k: Array) -> Array:
    """Integral of sin(y)**k from 0 to `angle`, at most pi/2."""
    return raised(angle, k) * sine_mean(angle, k)


def sine_mean(angle: Array, k: Array) -> Array:
    """The same over the power 1 + k of the angle."""
    return weighted(lambda y: sine_over(y) ** k, angle, k, 24)


def sine_over(y: Array) -> Array:
    """sin(y)/y."""
    return np.where(y > 0.0, np.sin(y) / np.where(y > 0.0, y, 1.0), 1.0)


def sinh_over(v: Array) -> Array:
    """sinh(v)/v."""
    return np.where(v > 0.0, np.sinh(v) / np.where(v > 0.0, v, 1.0), 1.0)
