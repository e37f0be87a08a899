"""Stable branches of an adhesive contact on the graded half-space, on the grids of the homogeneous one."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..interface import Array
from ..physics.adhesion import XI, Branches, branches
from .punch import graded_retraction, punch_stiffness, stationary

Rate = Callable[..., Array]


def graded_branches(
    rate: Rate,
    geometry: tuple[Array, ...],
    radii: Array,
    high: Array | float,
    H: Array,
    k: Array,
    dgamma: Array,
    control: str,
) -> Branches:
    """The branches on which the load grows with a: a**((1 + k)/2) g'(a) over a level.

    With g' weighted by a**(k/2), it is the condition of the homogeneous half-space.
    """

    def weighted(a: Array) -> Array:
        return a ** (k / 2.0) * rate(a, *geometry) * (XI[control] / stationary(control, k))

    return branches(weighted, radii, high, control, H, dgamma)


def stress_at(unit: Array, H: Array, k: Array) -> tuple[Array, Array]:
    """The exponent of the power of two near H L**k for L = 2**unit, and H in units of that stress and of L."""
    mantissa, exponent = np.frexp(H)
    # half of the digits of k make an exact product with a whole number
    high = np.asarray(k, dtype=np.float32).astype(np.float64)
    whole = np.rint(unit * high)
    return exponent + whole.astype(np.int32), mantissa * np.exp2((unit * high - whole) + unit * (k - high))


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
