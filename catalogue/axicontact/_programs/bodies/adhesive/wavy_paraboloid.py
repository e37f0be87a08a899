"""Bodies of axicontact.adhesive.wavy_paraboloid over plain numbers: the same text with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import wavy_paraboloid as normal
from ...._programs.bodies._runtime.physics.adhesion import lift, tension
from ....adhesive.wavy_paraboloid import Array


def _pressure(r: Array, a: Array, R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._pressure(r, a, R, h, wavelength, E_star) - tension(r, a, E_star, dgamma)


def _displacement(r: Array, a: Array, R: Array, h: Array, wavelength: Array, E_star: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, R, h, wavelength) - lift(r, a, E_star, dgamma)
