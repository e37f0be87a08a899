"""Domains and meanings of the keyword parameters."""

from __future__ import annotations

from math import inf
from typing import NamedTuple


class Domain(NamedTuple):
    """Where a parameter may lie, in numbers and in words, and what the parameter is."""

    low: float
    high: float
    rule: str
    meaning: str
    closed: str = ""
    """The end that belongs to the domain, "low" or "high"."""
    instead: str = ""
    """What to use for a value outside."""
    letter: str = ""
    """How the interface writes the parameter, where it shares its letter with another one."""


SYMBOLS = {
    "a": Domain(0.0, inf, "a > 0", "contact radius, in m"),
    "E_star": Domain(
        0.0, inf, "E_star > 0", "effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i, in Pa"
    ),
    "theta": Domain(0.0, 1.5707963267948966, "0 < theta < pi/2", "inclination of the flank to the surface, in rad"),
    "R": Domain(0.0, inf, "R > 0", "radius of curvature, in m"),
    "R1": Domain(0.0, inf, "R1 > 0", "radius of curvature of the inner part, in m"),
    "R2": Domain(0.0, inf, "R2 > 0", "radius of curvature of the outer part, in m"),
    "b": Domain(0.0, inf, "b > 0", "radius of the break between two parts of the profile, in m"),
    "n": Domain(0.0, inf, "n > 0", "exponent of the profile"),
    "A": Domain(0.0, inf, "A > 0", "coefficient of a power-law profile, in m^(1-n)"),
    "h": Domain(0.0, inf, "h > 0", "height of the profile, in m"),
    "s": Domain(0.0, inf, "s > 0", "length scale of the profile, in m"),
    "wavelength": Domain(0.0, inf, "wavelength > 0", "wavelength of the waviness, in m"),
}
