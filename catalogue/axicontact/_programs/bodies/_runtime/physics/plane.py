"""Bodies of axicontact._runtime.physics.plane over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.rules import falling
from ....._runtime.physics.plane import FADED
from ....._runtime.plain import in_groups
from ....._runtime.plain import MATH as np


@in_groups
def load_beyond(growth, root, b):
    """Integral of P'(t) from b to a = sqrt(b**2 + root**2)."""
    stop = np.arcsinh(root / b)
    fallen = falling(stop)

    def integrand(v):
        side = root * fallen(v)
        return growth(np.sqrt(b * b + side * side), side) * side
    return (integrand, np.minimum(stop, FADED), 1.0, True, 0.0)
