"""Bodies of axicontact._runtime.graded.rules over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import pow, sin, sinh

from ....._runtime.graded.single import weighted
from ....._runtime.plain import MATH as np

NODES = 64
STRIPS = ((0.409, 8,), (1.712, 16,), (3.012, 24,), (4.256, 32,), (9.015, 64,),)


def nodes_for(length):
    """Nodes of a product rule, twice those of Gauss, for singularities at a distance pi/2; see STRIPS."""
    longest = float(np.max(length, initial=0.0))
    for reached, count in STRIPS[:2]:
        if longest <= reached:
            return 2 * count
    return NODES


def raised(x, k):
    if x > 0.0:
        return x * pow(x, k)
    return 0.0


def sine_integral(angle, k):
    """Integral of sin(y)**k from 0 to `angle`, at most pi/2."""
    return raised(angle, k) * sine_mean(angle, k)


def sine_mean(angle, k):
    """The same over the power 1 + k of the angle."""
    return weighted(lambda y: sine_over(y) ** k, angle, k, 24)


def sine_over(y):
    v2 = y > 0.0
    if v2:
        return sin(y) / (y if v2 else 1.0)
    return 1.0


def sinh_over(v):
    v2 = v > 0.0
    if v2:
        return sinh(v) / (v if v2 else 1.0)
    return 1.0
