"""Bodies of axicontact._runtime.graded.waves over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.rules import raised
from ....._runtime.graded.single import far_out, over_quarter
from ....._runtime.graded.waves import _steepest_waves
from ....._runtime.plain import MATH as np

FAR = 16.0


def waves_depth(a, q, k):
    """g(a) of f = 1 - cos(q r)."""
    return q * a * _waves(a, q, k, lambda x, _: np.sin(x), lambda c, _: np.ones_like(c))


def waves_rate(t, q, k):
    return q * _waves(t, q, k, lambda x, _: _tilted(x, np.tan(0.5 * x)), lambda c, x: 1.0 + 1j * x * c)


def _tilted(x, tangent):
    return (2.0 * tangent + x * ((1.0 - tangent) * (1.0 + tangent))) / (1.0 + tangent * tangent)


def waves_force(a, q, k):
    return q * a * raised(a, k) * _waves(a, q, k, lambda x, cosine: np.sin(x) * cosine * cosine, lambda c, _: c * c)


def _waves(a, q, k, of, factor):
    """Integral of of(q a cos(y), cos(y)) sin(y)**k over a quarter turn, `of` = Im(factor(cos(y), q a) exp(i x)).

    The nodes resolve a phase of FAR in one panel.
    """
    phase = q * a
    if np.all(phase > FAR):
        return far_out(phase, k, factor)
    reach = np.minimum(phase, FAR)
    near = over_quarter(lambda cosine: of(reach * cosine, cosine), reach + 0.0 * k, k)
    return (far_out(np.maximum(phase, FAR), k, factor) if phase > FAR else near) if np.any(phase > FAR) else near


def steepest_waves(k):
    """The least wavelength**2/(h R) at which g' of a paraboloid with waves of height h nowhere falls below zero."""
    return np.vectorize(_steepest_waves, otypes=[float])(k)
