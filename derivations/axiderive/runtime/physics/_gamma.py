"""Gamma functions of arrays, by the standard library."""

from __future__ import annotations

import math

import numpy as np

from ._elementwise import Array


def gamma(x: Array) -> Array:
    return np.vectorize(math.gamma, otypes=[float])(x)


def gamma_quotient(x: Array, y: Array) -> Array:
    """Gamma(x)/Gamma(y), where each of them may be too large."""

    def quotient(x: float, y: float) -> float:
        return math.gamma(x) / math.gamma(y) if x < 100.0 else math.exp(math.lgamma(x) - math.lgamma(y))

    return np.vectorize(quotient, otypes=[float])(x, y)
