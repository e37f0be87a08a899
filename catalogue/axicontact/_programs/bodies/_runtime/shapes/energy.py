"""Bodies of axicontact._runtime.shapes.energy over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.rules import falling
from ....._runtime.plain import in_groups
from ....._runtime.plain import MATH as np


@in_groups
def energy_integral(depth, a, d, length):
    """The integral for g without singularities but those at t**2 = -length**2 and farther ones."""
    stop = np.arcsinh(a / length)
    fallen = falling(stop)

    def integrand(v):
        t = a * fallen(v)
        short = d - depth(t)
        return short * short * np.sqrt(length * length + t * t)
    return (integrand, stop, 1.0, True, 0.0)
