"""Bodies of axicontact.normal.gaussian over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.inverse import between, inverse_below
from ...._programs.bodies._runtime.rules import force_integral
from ...._programs.bodies._runtime.special import dawson
from ...._runtime.plain import MATH as np


def _slope(t, h, s):
    """Rate g'(t) of the indentation depth g(t)."""
    z = t / s
    return 2 * h / s * (dawson(z) + (1 - 2 * dawson(z) * z) * z)


def _depth(a, h, s):
    z = a / s
    return 2 * h * dawson(z) * z if a <= 1.5019752682686114 * s else np.nan


def _force(a, h, s, E_star):
    tip = 2 * E_star * force_integral(lambda t: _slope(t, h, s), a, 32)
    return tip if a <= 1.5019752682686114 * s else np.nan


def _radius_from_depth(d, h, s):

    def curve(a):
        value = _depth(a, h, s)
        return (value, a * _slope(a, h, s) / value)

    def like(short):
        rest = (1.003776, 0.2435676, 0.7000671, -0.6766533, 4.031949, -6.599278, 3.971419, -0.793611)
        return between(np.log(short / 0.6348098), (1.575, 2.0), (0.4486, 2.0), -6.0, rest)
    largest = 1.5019752682686114 * s * np.ones_like(d)
    return inverse_below(curve, d, largest, (1.0, 2.0), like)


def _radius_from_force(F, h, s, E_star):

    def curve(a):
        value = _force(a, h, s, E_star)
        return (value, 2 * E_star * a ** 2 * _slope(a, h, s) / value)

    def like(short):
        rest = (0.9994039, 0.6765872, -1.514105, 16.18697, -61.13223, 108.1267, -95.20743, 32.86326)
        return between(np.log(short / 1.360193), (1.659, 2.0), (0.1392, 3.0), -6.0, rest)
    largest = 1.5019752682686114 * s * np.ones_like(F)
    return inverse_below(curve, F, largest, (1.0, 3.0), like)


def _force_from_depth(d, h, s, E_star):
    a = _radius_from_depth(d, h, s)
    change = 2 * E_star * a * (d - _depth(a, h, s)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, h, s, E_star) + change


def _depth_from_force(F, h, s, E_star):
    a = _radius_from_force(F, h, s, E_star)
    change = (F - _force(a, h, s, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, h, s) + change
