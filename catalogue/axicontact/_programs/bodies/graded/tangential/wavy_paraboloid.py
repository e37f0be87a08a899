"""Bodies of axicontact.graded.tangential.wavy_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import wavy_paraboloid as normal
from ....._programs.bodies._runtime.physics.slip import stick_force


def _stick_radius(F_x, a, R, h, wavelength, H, k, mu):
    F = stick_force(normal._force(a, R, h, wavelength, H, k), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, R, h, wavelength, H, k)


def _full_slip_displacement(a, R, h, wavelength, H, H_x, k, mu):
    return mu * (H / H_x) * normal._depth(a, R, h, wavelength, k)
