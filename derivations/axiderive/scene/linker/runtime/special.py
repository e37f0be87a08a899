"""A shorter equal of a function of the runtime that a scene does without its speed."""

from __future__ import annotations

import numpy as np

from .interface import Array
from .kernels import DAWSON


def dawson(x: Array) -> Array:
    """Dawson's integral exp(-x**2) int_0^x exp(u**2) du for 0 <= x <= 25/16."""
    return x / np.polyval(DAWSON, x * x)
