"""Bodies of axicontact._runtime.graded.rules over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._runtime.graded.rules import NODES, STRIPS
from ....._runtime.graded.single import weighted
from ....._runtime.plain import MATH as np


def nodes_for(length):
    """Nodes of a product rule, twice those of Gauss, for singularities at a distance pi/2; see STRIPS."""
    longest = float(np.max(length, initial=0.0))
    return next((2 * count for reached, count in STRIPS[:2] if longest <= reached), NODES)


def either(condition, x, y):
    """x() where the condition holds and y() elsewhere; what is chosen nowhere is not asked for."""
    if np.all(condition):
        return x()
    return (x() if condition else y()) if np.any(condition) else y()


def raised(x, k):
    """x**(1 + k), with no rounding of the exponent."""
    return x * x ** k if x > 0.0 else 0.0


def sine_integral(angle, k):
    """Integral of sin(y)**k from 0 to `angle`, at most pi/2."""
    return raised(angle, k) * sine_mean(angle, k)


def sine_mean(angle, k):
    """The same over the power 1 + k of the angle."""
    return weighted(lambda y: sine_over(y) ** k, angle, k, 24)


def sine_over(y):
    """sin(y)/y."""
    return np.sin(y) / (y if y > 0.0 else 1.0) if y > 0.0 else 1.0


def sinh_over(v):
    """sinh(v)/v."""
    return np.sinh(v) / (v if v > 0.0 else 1.0) if v > 0.0 else 1.0
