"""Bodies of axicontact._runtime.shapes.load_within over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.integrals import difference_root
from ....._programs.bodies._runtime.rules import falling
from ....._runtime.plain import in_groups
from ....._runtime.plain import MATH as np


@in_groups
def load_within_integral(slope, r, a):
    """The integral for g' without singularities but those at imaginary t."""
    reach = difference_root(a, r)
    stop = np.arcsinh(reach / r)
    fallen = falling(stop)

    def integrand(v):
        u = reach * fallen(v)
        t = np.sqrt(r * r + u * u)
        return slope(t) * (u / (t + u))
    return (integrand, stop, r * r, r > 0.0, 0.0)
