"""Shorter equals of functions of the runtime that a scene does without their speed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .interface import Array


def rational(v: Array, top: Sequence[float], bottom: Sequence[float]) -> Array:
    """P(v)/Q(v) with coefficients in ascending order."""
    return np.polyval(top[::-1], v) / np.polyval(bottom[::-1], v)


def beside(r: Array, a: Array, kernel: tuple[Sequence[float], Sequence[float], float]) -> Array:
    """pi/2 w(r)/g(a) beside a contact whose depth g is a power of its radius a < r."""
    square = (a / (r + np.sqrt((r - a) * (r + a)))) ** 2
    rest = np.polyval(kernel[0][::-1], square) / np.polyval(kernel[1][::-1], square)
    return a / r * (kernel[2] + square * rest)
