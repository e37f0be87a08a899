"""Bodies of axicontact.normal.polynomial over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.functions import depth_over_height
from ...._programs.bodies._runtime.inverse import inverse
from ...._programs.bodies._runtime.shapes.energy import energy_integral
from ...._programs.bodies._runtime.shapes.load_within import load_within_integral
from ...._programs.bodies._runtime.shapes.powers import power_displacement, power_pressure
from ....normal.polynomial import reduce
from ...._runtime.plain import MATH as np


def _profile(r, A):
    return sum((r ** j * A_j for j, A_j in enumerate(A, 1)))


def _slope(a, A):
    """Rate g'(a) of the indentation depth."""
    return sum((j * depth_over_height(j) * a ** (j - 1) * A_j for j, A_j in enumerate(A, 1)))


def _depth(a, A):
    return sum((depth_over_height(j) * a ** j * A_j for j, A_j in enumerate(A, 1)))


def _force(a, A, E_star):
    terms = (j * depth_over_height(j) / (j + 1) * a ** (j + 1) * A_j for j, A_j in enumerate(A, 1))
    return 2 * E_star * sum(terms)


def _pressure(r, a, A, E_star):
    terms = (j * depth_over_height(j) * a ** (j - 1) * power_pressure(r, a, j) * A_j for j, A_j in enumerate(A, 1) if A_j)
    return E_star / np.pi * sum(terms) if r < a else 0.0


def _displacement(r, a, A):
    terms = (depth_over_height(j) * a ** j * power_displacement(r, a, j) * A_j for j, A_j in enumerate(A, 1))
    outside = 2 * sum(terms) / np.pi
    inside = _depth(a, A) - _profile(r, A)
    return outside if r > a else inside


def _mean_pressure(a, A, E_star):
    terms = (j * depth_over_height(j) / (j + 1) * a ** (j - 1) * A_j for j, A_j in enumerate(A, 1))
    return 2 * E_star / np.pi * sum(terms)


def _energy(a, A, E_star):
    sunk = _depth(a, A)
    tip = energy_integral(lambda t: _depth(t, A), (), a, sunk, a)
    return E_star * tip


def _load_within(r, a, A, E_star):
    tip = load_within_integral(lambda t: _slope(t, A), (), np.minimum(r, a), a)
    return _force(np.minimum(r, a), A, E_star) + 2 * E_star * tip


def _radius_from_depth(d, A):

    def curve(a):
        value = _depth(a, A)
        return (value, a * _slope(a, A) / value)
    alone = (d / depth_over_height(j) / A_j for j, A_j in enumerate(A, 1))
    terms = (np.log(share) / j for j, share in enumerate(alone, 1))
    start = np.exp(reduce(np.minimum, terms))
    return inverse(curve, d, start, (1.0, len(A)), smooth=True)


def _radius_from_force(F, A, E_star):

    def curve(a):
        value = _force(a, A, E_star)
        return (value, 2 * E_star * a ** 2 * _slope(a, A) / value)
    alone = ((j + 1) / (2 * E_star * j * depth_over_height(j)) * F / A_j for j, A_j in enumerate(A, 1))
    terms = (np.log(share) / (j + 1) for j, share in enumerate(alone, 1))
    start = np.exp(reduce(np.minimum, terms))
    return inverse(curve, F, start, (2.0, len(A) + 1.0), smooth=True)


def _force_from_depth(d, A, E_star):
    a = _radius_from_depth(d, A)
    change = 2 * E_star * a * (d - _depth(a, A)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, A, E_star) + change


def _depth_from_force(F, A, E_star):
    a = _radius_from_force(F, A, E_star)
    change = (F - _force(a, A, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, A) + change
