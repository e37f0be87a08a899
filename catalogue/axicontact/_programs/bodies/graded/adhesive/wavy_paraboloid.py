"""Bodies of axicontact.graded.adhesive.wavy_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import wavy_paraboloid as normal
from ....._programs.bodies._runtime.graded.punch import graded_retraction, punch_displacement
from .....graded.adhesive.wavy_paraboloid import Array


def _displacement(r: Array, a: Array, R: Array, h: Array, wavelength: Array, H: Array, k: Array, dgamma: Array) -> Array:
    return normal._displacement(r, a, R, h, wavelength, k) - graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)
