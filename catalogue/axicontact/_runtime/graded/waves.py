"""Integrals of a concentric wave over the turn of a contact on the graded half-space, near and far out."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np

from ..integrals import integral
from ..interface import Array
from .rules import over_quarter, raised, weighted

FAR, NEAR, DEEP = 16.0, 3.0, 44.0
"""The phase from which the paths off the real axis are taken; the first panel of those, and where they end."""


def waves_depth(a: Array, q: Array, k: Array) -> Array:
    """g(a) of f = 1 - cos(q r)."""
    return q * a * _waves(a, q, k, lambda x, _: np.sin(x), lambda c, _: np.ones_like(c))


def waves_rate(t: Array, q: Array, k: Array) -> Array:
    return q * _waves(t, q, k, lambda x, _: _tilted(x, np.tan(0.5 * x)), lambda c, x: 1.0 + 1j * x * c)


def _tilted(x: Array, tangent: Array) -> Array:
    """sin(x) + x cos(x), of half of x: arrays of sines and cosines take four times as long."""
    return (2.0 * tangent + x * ((1.0 - tangent) * (1.0 + tangent))) / (1.0 + tangent * tangent)


def waves_force(a: Array, q: Array, k: Array) -> Array:
    return q * a * raised(a, k) * _waves(a, q, k, lambda x, cosine: np.sin(x) * cosine * cosine, lambda c, _: c * c)


def _waves(a: Array, q: Array, k: Array, of: Callable[..., Array], factor: Callable[..., Array]) -> Array:
    """Integral of of(q a cos(y), cos(y)) sin(y)**k over a quarter turn, `of` = Im(factor(cos(y), q a) exp(i x)).

    The nodes resolve a phase of FAR in one panel.
    """
    phase = q * a
    if np.all(phase > FAR):
        return far_out(phase, k, factor)
    reach = np.minimum(phase, FAR)
    near = over_quarter(lambda cosine: of(reach * cosine, cosine), reach + 0.0 * k, k)
    return np.where(phase > FAR, far_out(np.maximum(phase, FAR), k, factor), near) if np.any(phase > FAR) else near


def far_out(phase: Array, k: Array, factor: Callable[..., Array]) -> Array:
    """The same of c = cos(y), on the paths i t/phase and 1 + i t/phase, along which exp(i phase c) falls as exp(-t)."""
    # no numbers without a range, which are not complex
    phase, k = np.asarray(phase, dtype=np.float64), np.asarray(k, dtype=np.float64)
    m = (k - 1.0) / 2.0

    def axis(t: Array) -> Array:
        u = t / phase
        return np.exp(-t) * factor(1j * u, phase) * (1.0 + u * u) ** m

    def edge(t: Array) -> Array:
        u = t / phase
        return np.exp(-t) * factor(1.0 + 1j * u, phase) * (1.0 + 0.5j * u) ** m

    first, deep = (np.full_like(phase + k, x) for x in (NEAR, DEEP))
    end = NEAR * NEAR**m * weighted(edge, first, m, above=(1.0 + k) / 2.0)
    end = end + integral(lambda t: edge(NEAR + t) * (NEAR + t) ** m, deep - NEAR, 64)
    # not of the sum of both, whose rounding grows with the phase
    turned = np.exp(1j * phase) * np.exp(-0.5j * np.pi * m) * (2.0 / phase) ** m
    return np.real(integral(axis, deep, 32) - turned * end) / phase


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
