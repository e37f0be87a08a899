"""Integrals over the profile itself, for profiles with any number of breaks or without closed forms."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array
from ._integrals import difference_root, integral


def over_profile(weight: Callable[[Array, Array], Array], a: Array, low: Array, high: Array, count: int) -> Array:
    """Integral of weight(s, z) over the angle u with s = a sin(u), z = a cos(u), for low < s < min(high, a)."""
    end = np.minimum(high, a)
    start, stop = np.arctan2(low, difference_root(a, low)), np.arctan2(end, difference_root(a, end))
    return integral(lambda u: weight(a * np.sin(start + u), a * np.cos(start + u)), stop - start, count)


def growth_beyond(bend: Callable[[Array], Array], t: Array, root: Array, b: Array, count: int) -> Array:
    """Integral of (s f')' over the angle with s = t cos(angle), for b < s < t and root = sqrt(t**2 - b**2)."""
    return integral(lambda angle: bend(t * np.cos(angle)), np.arctan2(root, b + np.zeros_like(t)), count)
