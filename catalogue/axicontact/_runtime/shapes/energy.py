"""The elastic energy over the modulus: int_0^a (d - g(t))**2 dt, by rules that know where g is singular."""

from __future__ import annotations

import numpy as np

from ..integrals import Slope, Strip, difference_root, in_groups
from ..interface import Array
from ..rules import falling


@in_groups
def energy_integral(depth: Slope, a: Array, d: Array, length: Array) -> Strip:
    """The integral for g without singularities but those at t**2 = -length**2 and farther ones."""
    stop = np.arcsinh(a / length)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        t = a * fallen(v)
        short = d - depth(t)
        return short * short * np.sqrt(length * length + t * t)

    return integrand, stop, 1.0, True, 0.0


@in_groups
def energy_integral_tanh(depth: Slope, a: Array, d: Array, R: Array) -> Strip:
    """The integral for g singular at t = R; `depth` takes t and sqrt(R**2 - t**2)."""
    ratio = a / difference_root(R, a)
    stop = np.arcsinh(ratio)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        side = ratio * fallen(v)
        secant = np.sqrt(1.0 + side * side)
        short = d - depth(R * (side / secant), R / secant)
        return short * short / (secant * secant)

    return integrand, stop, R, a < R, np.inf


@in_groups
def energy_integral_beyond(depth: Slope, a: Array, d: Array, b: Array) -> Strip:
    """The integral from b to a > b; `depth` takes t and sqrt(t**2 - b**2)."""
    reach = difference_root(a, b)
    stop = np.arcsinh(reach / b)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        root = reach * fallen(v)
        short = d - depth(np.sqrt(b * b + root * root), root)
        return short * short * root

    return integrand, stop, 1.0, a > b, 0.0
