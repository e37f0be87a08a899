"""The greatest pressure of a contact and the ring on which it is."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ._elementwise import Array, Result
from ._functions import rational
from ._kernels import PEAK_LARGE, PEAK_SMALL


class PeakPressure(NamedTuple):
    """The greatest pressure and its radius."""

    pressure: Result
    radius: Result


def peak_share(a: Array, b: Array) -> Array:
    """(r - b)/(a - b) of that radius under a flat face of radius b with a parabolic rounding; b/a alone decides.

    It is sqrt(pi b/a)/2 for small b/a and nowhere above 0.311, so that r is surely between b and a.
    """
    x = np.sqrt(b / a)
    small, large = np.minimum(x, 0.5), np.minimum(np.maximum(x, 0.5), 1.0)
    return x / (1.0 + x) * np.where(x < 0.5, rational(0.5 - small, *PEAK_SMALL), rational(1.0 - large, *PEAK_LARGE))
