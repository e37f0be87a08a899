"""Bodies of axicontact.tangential.wavy_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import wavy_paraboloid as normal
from ...._programs.bodies._runtime.physics.slip import growth_waves, stick_force
from ...._runtime.plain import MATH as np

CLOSE = 0.25


def _tangential_force(a, c, R, h, wavelength, E_star, mu):
    whole, sticking = (normal._force(a, R, h, wavelength, E_star), normal._force(c, R, h, wavelength, E_star))
    close = sticking >= CLOSE * whole
    gain = 2.0 * E_star * growth_waves(normal._slope, (R, h, wavelength), 2, 0.0, c, a, wavelength, close)
    return mu * (gain if close else whole - sticking)


def _traction(r, a, c, R, h, wavelength, E_star, mu):
    sliding = normal._pressure(r, a, R, h, wavelength, E_star)
    stuck = normal._pressure(r, c, R, h, wavelength, E_star)
    close = (r < c) & (stuck >= CLOSE * sliding)
    gain = E_star / np.pi * growth_waves(normal._slope, (R, h, wavelength), 0, r, c, a, wavelength, close)
    return mu * (gain if close else sliding - stuck)


def _tangential_displacement(a, c, R, h, wavelength, E_star, G_star, mu):
    whole, sticking = (normal._depth(a, R, h, wavelength), normal._depth(c, R, h, wavelength))
    close = sticking >= CLOSE * whole
    gain = growth_waves(normal._slope, (R, h, wavelength), 1, 0.0, c, a, wavelength, close)
    return mu * (E_star / G_star) * (gain if close else whole - sticking)


def _stick_radius(F_x, a, R, h, wavelength, E_star, mu):
    F = stick_force(normal._force(a, R, h, wavelength, E_star), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, R, h, wavelength, E_star)
