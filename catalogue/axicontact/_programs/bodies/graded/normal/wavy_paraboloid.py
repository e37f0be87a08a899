"""Bodies of axicontact.graded.normal.wavy_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from .....graded.normal.wavy_paraboloid import Array
from ....._runtime.plain import MATH as np


def _displacement(r: Array, a: Array, R: Array, h: Array, wavelength: Array, k: Array) -> Array:
    from ....._programs.bodies._runtime.graded.displacement import power_displacement, waves_displacement
    return power_displacement(r, a, 2.0, k) / (2 * R) + h * waves_displacement(r, a, 2 * np.pi / wavelength, k)
