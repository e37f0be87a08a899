"""Integrals of a concentric wave over the turn of a contact on the graded half-space, near and far out."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np

from ..integrals import integral_by_panels
from ..interface import Array
from .rules import raised, sine_over, weighted

FAR, NEAR, DEEP = 30.0, 3.0, 44.0
"""The phase from which the paths off the real axis are taken; the first panel of those, and where they end."""


def waves_depth(a: Array, q: Array, k: Array) -> Array:
    """g(a) of f = 1 - cos(q r)."""
    return q * a * _waves(a, q, k, lambda x, _: np.sin(x), lambda c, _: np.ones_like(c))


def waves_rate(t: Array, q: Array, k: Array) -> Array:
    return q * _waves(t, q, k, lambda x, _: np.sin(x) + x * np.cos(x), lambda c, x: 1.0 + 1j * x * c)


def waves_force(a: Array, q: Array, k: Array) -> Array:
    return q * a * raised(a, k) * _waves(a, q, k, lambda x, cosine: np.sin(x) * cosine * cosine, lambda c, _: c * c)


def _waves(a: Array, q: Array, k: Array, of: Callable[..., Array], factor: Callable[..., Array]) -> Array:
    """Integral of of(q a cos(y), cos(y)) sin(y)**k over a quarter turn, `of` = Im(factor(cos(y), q a) exp(i x)).

    One panel with the weight, then plain ones.
    """
    phase = q * a
    if np.all(phase > FAR):
        return _far(phase, k, factor)
    reach = np.minimum(phase, FAR)
    first = np.minimum(np.pi / 2.0, 8.0 / np.maximum(reach, 1e-300))

    def smooth(y: Array) -> Array:
        return of(reach * np.cos(y), np.cos(y)) * sine_over(y) ** k

    def rest(y: Array) -> Array:
        return of(reach * np.cos(first + y), np.cos(first + y)) * np.sin(first + y) ** k

    total = raised(first, k) * weighted(smooth, first, k)
    total = total + integral_by_panels(rest, np.pi / 2.0 - first, first, 64)
    return np.where(phase > FAR, _far(np.maximum(phase, FAR), k, factor), total) if np.any(phase > FAR) else total


def _far(phase: Array, k: Array, factor: Callable[..., Array]) -> Array:
    """The same of c = cos(y), on the paths i t/phase and 1 + i t/phase, along which exp(i phase c) falls as exp(-t)."""
    m = (k - 1.0) / 2.0

    def axis(t: Array) -> Array:
        u = t / phase
        return np.exp(-t) * factor(1j * u, phase) * (1.0 + u * u) ** m

    def edge(t: Array) -> Array:
        u = t / phase
        return np.exp(-t) * factor(1.0 + 1j * u, phase) * (1.0 + 0.5j * u) ** m

    first, rest, plain = (np.full_like(phase + k, x) for x in (NEAR, DEEP - NEAR, 0.0))
    start = DEEP * weighted(axis, first + rest, plain)
    end = NEAR * NEAR**m * weighted(edge, first, m + plain, above=(1.0 + k) / 2.0 + plain)
    end = end + (DEEP - NEAR) * weighted(lambda t: edge(NEAR + t) * (NEAR + t) ** m, rest, plain)
    # not of the sum of both, whose rounding grows with the phase
    turned = np.exp(1j * phase) * np.exp(-0.5j * np.pi * m) * (2.0 / phase) ** m
    return np.real(start - turned * end) / phase


def steepest_waves(k: Array) -> Array:
    """The least wavelength**2/(h R) at which g' of a paraboloid with waves of height h nowhere falls below zero."""
    return np.vectorize(_steepest_waves, otypes=[float])(k)


@cache
def _steepest_waves(k: float) -> float:
    # with x = q a, g' of the waves is q W(x) and that of the paraboloid 2 x/((1 + k) q R)
    x = np.arange(1.0, 40.0, 0.02)
    ratio = -waves_rate(x, 1.0, k) / x
    place = int(np.argmax(ratio))
    low, top, high = (float(ratio[place + step]) for step in (-1, 0, 1))
    largest = top - (high - low) ** 2 / (8.0 * (high - 2.0 * top + low))
    return float(2.0 * np.pi**2 * (1.0 + k) * largest)
