"""What the stable branches of an adhesive contact on the graded half-space need beside the search for them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..functions import halves
from ..interface import Array
from ..physics.branches import exponent_of
from .punch import graded_retraction, punch_stiffness, stationary

Rate = Callable[..., Array]


def stress_at(unit: Array, H: Array, k: Array) -> tuple[Array, Array]:
    """The exponent of the power of two near H L**k for L = 2**unit, and H in units of that stress and of L."""
    mantissa, exponent = np.frexp(H)
    # half of the digits of k make an exact product with a whole number
    high, low = halves(k)
    whole = np.floor(unit * high + 0.5)
    return exponent + exponent_of(np.exp2(whole)), mantissa * np.exp2((unit * high - whole) + unit * low)


def growth_of(
    rate: Rate, geometry: tuple[Array, ...], H: Array, k: Array, dgamma: Array, control: str
) -> Callable[[Array], Array]:
    """Derivative of the depth or the force of the adhesive contact."""

    def growth(a: Array) -> Array:
        slope = rate(a, *geometry) - stationary(control, k) * graded_retraction(a, H, k, dgamma) / (2.0 * a)
        return slope * punch_stiffness(a, H, k) if control == "force" else slope

    return growth


def pull_of(H: Array, k: Array, dgamma: Array, control: str) -> Callable[[Array], Array]:
    """The part of the depth or the force by adhesion."""

    def pulled(a: Array) -> Array:
        moved = graded_retraction(a, H, k, dgamma)
        return moved * punch_stiffness(a, H, k) if control == "force" else moved

    return pulled
