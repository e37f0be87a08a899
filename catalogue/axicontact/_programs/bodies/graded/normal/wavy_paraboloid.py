"""Bodies of axicontact.graded.normal.wavy_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import power_depth, power_force, power_rate
from ....._programs.bodies._runtime.graded.punch import punch_depth, punch_force, punch_stiffness
from ....._programs.bodies._runtime.graded.waves import waves_depth, waves_force, waves_rate
from ....._runtime.plain import MATH as np


def _depth(a, R, h, wavelength, k):
    return power_depth(a, 2.0, k) / (2 * R) + h * waves_depth(a, 2 * np.pi / wavelength, k)


def _rate(a, R, h, wavelength, k):
    """Rate g'(a) of the depth."""
    return power_rate(a, 2.0, k) / (2 * R) + h * waves_rate(a, 2 * np.pi / wavelength, k)


def _force(a, R, h, wavelength, H, k):
    growth = power_force(a, 2.0, k) / (2 * R) + h * waves_force(a, 2 * np.pi / wavelength, k)
    return 2.0 * H / (1.0 + k) * growth


def _force_rate(a, R, h, wavelength, H, k):
    """Derivative of the force."""
    return punch_stiffness(a, H, k) * _rate(a, R, h, wavelength, k)


def _mean_pressure(a, R, h, wavelength, H, k):
    return _force(a, R, h, wavelength, H, k) / (np.pi * a * a) if a > 0.0 else 0.0


def _displacement(r, a, R, h, wavelength, k):
    from ....._programs.bodies._runtime.graded.displacement import power_displacement, waves_displacement
    return power_displacement(r, a, 2.0, k) / (2 * R) + h * waves_displacement(r, a, 2 * np.pi / wavelength, k)


def _radius_from_depth(d, R, h, wavelength, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_to
    return radius_to(_depth, _rate, d, 1.5 * wavelength, (R, h, wavelength, k))


def _radius_from_force(F, R, h, wavelength, H, k):
    from ....._programs.bodies._runtime.graded.inverse import radius_to
    return radius_to(_force, _force_rate, F, 1.5 * wavelength, (R, h, wavelength, H, k))


def _force_from_depth(d, R, h, wavelength, H, k):
    a = _radius_from_depth(d, R, h, wavelength, k)
    return _force(a, R, h, wavelength, H, k) + punch_force(d - _depth(a, R, h, wavelength, k), a, H, k)


def _depth_from_force(F, R, h, wavelength, H, k):
    a = _radius_from_force(F, R, h, wavelength, H, k)
    return _depth(a, R, h, wavelength, k) + punch_depth(F - _force(a, R, h, wavelength, H, k), a, H, k)
