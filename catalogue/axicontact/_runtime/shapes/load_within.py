"""The load within a radius beyond that of a contact which ends there: int_r^a g'(t) r**2/(t + u) dt.

u = sqrt(t**2 - r**2); all terms are positive where g' is.  Singularities at u = i r stay pi/2 away.
"""

from __future__ import annotations

import numpy as np

from ..integrals import Slope, Strip, difference_root, in_groups
from ..interface import Array
from ..rules import falling


@in_groups
def load_within_integral(slope: Slope, r: Array, a: Array) -> Strip:
    """The integral for g' without singularities but those at imaginary t."""
    reach = difference_root(a, r)
    stop = np.arcsinh(reach / r)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        u = reach * fallen(v)
        t = np.sqrt(r * r + u * u)
        return slope(t) * (u / (t + u))

    return integrand, stop, r * r, r > 0.0, 0.0


@in_groups
def load_within_integral_tanh(slope: Slope, r: Array, a: Array, R: Array) -> Strip:
    """The integral for g' singular at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    scale, share = difference_root(R, r), r / R
    ratio = difference_root(a, r) / difference_root(R, a)
    stop = np.arcsinh(ratio / share)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        side = ratio * fallen(v)
        secant = np.sqrt(1.0 + side * side)
        u, root = scale * (side / secant), scale / secant
        t = np.sqrt(r * r + u * u)
        return slope(t, root) * (u / (t + u)) * (root / (secant * secant * t)) * np.sqrt(share * share + side * side)

    return integrand, stop, r * r, (r > 0.0) & (a < R), np.where(r > 0.0, np.inf, 0.0)


@in_groups
def load_within_integral_beyond(slope: Slope, r: Array, a: Array, b: Array) -> Strip:
    """The integral from max(r, b) to a > b; `slope` takes t and sqrt(t**2 - b**2)."""
    r = np.where(r == b, np.nextafter(b, np.inf), r)
    within = r < b
    outside, reach, whole = np.where(within, 0.0, 1.0), difference_root(a, b), difference_root(a, r)
    stop = np.arcsinh(np.where(within, reach, whole) / np.sqrt(np.abs(r - b) * (r + b)))
    # the root grows like sinh within the break and like cosh outside, and u the other way round
    fallen, turned = falling(stop, outside), falling(stop, 1.0 - outside)

    def integrand(v: Array) -> Array:
        root, u = reach * fallen(v), whole * turned(v)
        t = np.sqrt(b * b + root * root)
        return slope(t, root) * (root / t) * (u / (t + u))

    return integrand, stop, r * r, a > np.maximum(r, b), 0.0
