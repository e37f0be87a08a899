"""Domains and meanings of the keyword parameters."""

from __future__ import annotations

from math import inf

SYMBOLS = {
    "a": (0.0, inf, "a > 0", "contact radius, in m"),
    "E_star": (0.0, inf, "E_star > 0", "effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i, in Pa"),
    "theta": (0.0, 1.5707963267948966, "0 < theta < pi/2", "inclination of the flank to the surface, in rad"),
    "R": (0.0, inf, "R > 0", "radius of curvature, in m"),
    "R1": (0.0, inf, "R1 > 0", "radius of curvature of the inner part, in m"),
    "R2": (0.0, inf, "R2 > 0", "radius of curvature of the outer part, in m"),
    "b": (0.0, inf, "b > 0", "radius of the break between two parts of the profile, in m"),
    "n": (0.0, inf, "n > 0", "exponent of the profile"),
    "A": (0.0, inf, "A > 0", "coefficient of a power-law profile, in m^(1-n)"),
    "h": (0.0, inf, "h > 0", "height of the profile, in m"),
    "s": (0.0, inf, "s > 0", "length scale of the profile, in m"),
    "wavelength": (0.0, inf, "wavelength > 0", "wavelength of the waviness, in m"),
}
