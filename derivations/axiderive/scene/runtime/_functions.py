"""Shorter equals of functions of the runtime that a scene does without their speed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ._elementwise import Array


def rational(v: Array, top: Sequence[float], bottom: Sequence[float]) -> Array:
    """P(v)/Q(v) with coefficients in ascending order."""
    return np.polyval(top[::-1], v) / np.polyval(bottom[::-1], v)
