"""Bodies of axicontact.normal.wavy_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.rules import displacement_integral_waves, pressure_integral_waves
from ...._programs.bodies._runtime.shapes.waves import inverse_over_waves
from ...._programs.bodies._runtime.special import struve_h0, struve_h1
from ...._runtime.plain import MATH as np


def _profile(r, R, h, wavelength):
    return 2 * h * np.sin(np.pi / wavelength * r) ** 2 + r ** 2 / (2 * R)


def _slope(t, R, h, wavelength):
    """Rate g'(t) of the indentation depth g(t)."""
    z = 2 * np.pi / wavelength * t
    plus = 4 * np.pi ** 2 * h / wavelength ** 2 * t + np.pi ** 2 * h / wavelength * struve_h0(z) + 2 * t / R
    minus = 2 * np.pi ** 3 * h / wavelength ** 2 * t * struve_h1(z)
    return plus - minus


def _depth(a, R, h, wavelength):
    z = 2 * np.pi / wavelength * a
    return a * (np.pi ** 2 * h / wavelength * struve_h0(z) + a / R)


def _force(a, R, h, wavelength, E_star):
    z = 2 * np.pi / wavelength * a
    plus = 2 * np.pi ** 2 * h / wavelength * a * struve_h0(z) + 4 * a ** 2 / (3 * R)
    minus = np.pi * h * struve_h1(z)
    return E_star * a * (plus - minus)


def _pressure(r, a, R, h, wavelength, E_star):
    within = pressure_integral_waves(lambda t: _slope(t, R, h, wavelength), r, a, wavelength)
    return E_star / np.pi * within if r < a else 0.0


def _displacement(r, a, R, h, wavelength):
    tip = displacement_integral_waves(lambda t: _slope(t, R, h, wavelength), r, a, wavelength)
    outside = 2 / np.pi * tip
    inside = _depth(a, R, h, wavelength) - _profile(r, R, h, wavelength)
    return outside if r > a else inside


def _radius_from_depth(d, R, h, wavelength):
    unit = wavelength / (2 * np.pi)
    waves = 2 * np.pi ** 3 * h * R / wavelength ** 2
    return unit * inverse_over_waves(d / unit * (R / unit), waves, 1)


def _radius_from_force(F, R, h, wavelength, E_star):
    unit = wavelength / (2 * np.pi)
    waves = 2 * np.pi ** 3 * h * R / wavelength ** 2
    return unit * inverse_over_waves(F / unit * (R / unit) / (2 * E_star * unit), waves, 2)


def _force_from_depth(d, R, h, wavelength, E_star):
    a = _radius_from_depth(d, R, h, wavelength)
    change = 2 * E_star * a * (d - _depth(a, R, h, wavelength)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, R, h, wavelength, E_star) + change


def _depth_from_force(F, R, h, wavelength, E_star):
    a = _radius_from_force(F, R, h, wavelength, E_star)
    change = (F - _force(a, R, h, wavelength, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, R, h, wavelength) + change
