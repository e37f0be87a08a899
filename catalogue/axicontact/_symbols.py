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
    "d": Domain(0.0, inf, "d >= 0", "indentation depth of the point r = 0, in m", closed="low"),
    "F": Domain(0.0, inf, "F >= 0", "normal force, in N", closed="low"),
    "E_star": Domain(
        0.0, inf, "E_star > 0", "effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i, in Pa"
    ),
    "k": Domain(
        -1.0,
        1.0,
        "-1 < k < 1",
        "exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space",
        instead="use a modulus that grows less than linearly with depth, or k = 0 for a homogeneous half-space",
    ),
    "H": Domain(0.0, inf, "H > 0", "foundation modulus of the graded half-space, c_N(x) = H |x|^k, in Pa m^(-k)"),
    "dgamma": Domain(
        0.0,
        inf,
        "dgamma >= 0",
        "work of separation per unit area, in N/m",
        closed="low",
        instead="use dgamma = 0 for a contact without adhesion",
    ),
    "mu": Domain(
        0.0,
        inf,
        "mu >= 0",
        "coefficient of friction",
        closed="low",
        instead="give the coefficient as a positive number, or mu = 0 for a contact without friction",
    ),
    "G_star": Domain(0.0, inf, "G_star > 0", "effective shear modulus, 1/G_star = sum (2 - nu_i)/(4 G_i), in Pa"),
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
    "H_x": Domain(0.0, inf, "H_x > 0", "tangential foundation modulus, c_T(x) = H_x |x|^k, in Pa m^(-k)"),
    "v": Domain(
        0.0,
        inf,
        "v > 0",
        "speed of indentation, d = v t, in m/s",
        instead="a shrinking contact does not obey the rule of Lee and Radok, use v > 0",
    ),
    "E": Domain(0.0, inf, "E > 0", "effective (plane-strain) modulus of the viscoelastic law, in Pa"),
    "E_inf": Domain(0.0, inf, "E_inf > 0", "long-time effective modulus, in Pa"),
    "E_1": Domain(0.0, inf, "E_1 >= 0", "relaxing part of the effective modulus, in Pa", closed="low"),
    "eta": Domain(0.0, inf, "eta > 0", "effective viscosity, in Pa s"),
    "relaxation": Domain(0.0, inf, "tau > 0", "relaxation time, in s", letter="tau"),
    "alpha": Domain(
        0.0,
        1.0,
        "0 < alpha < 1",
        "exponent of power-law creep",
        instead="use the Maxwell law for a fluid (alpha = 1) and the elastic contact for alpha = 0",
    ),
    "t_0": Domain(0.0, inf, "t_0 > 0", "reference time of power-law creep, J = (t/t_0)^alpha/E, in s"),
    "young_1": Domain(0.0, inf, "E_1 > 0", "Young's modulus of the first body, in Pa", letter="E_1"),
    "young_2": Domain(0.0, inf, "E_2 > 0", "Young's modulus of the second body, in Pa", letter="E_2"),
    "E_0": Domain(0.0, inf, "E_0 > 0", "Young's modulus at the depth of reference, in Pa"),
    "c_0": Domain(0.0, inf, "c_0 > 0", "depth of reference of the graded half-space, in m"),
    "nu": Domain(-1.0, 0.5, "-1 < nu <= 1/2", "Poisson ratio", closed="high"),
    "nu_1": Domain(-1.0, 0.5, "-1 < nu_1 <= 1/2", "Poisson ratio of the first body", closed="high"),
    "nu_2": Domain(-1.0, 0.5, "-1 < nu_2 <= 1/2", "Poisson ratio of the second body", closed="high"),
    "p_0": Domain(0.0, inf, "p_0 > 0", "scale of a prescribed pressure, in Pa"),
    "sigma": Domain(
        -1.0,
        inf,
        "s > -1",
        "exponent of a prescribed pressure",
        instead="a steeper edge carries an infinite force, use s > -1",
        letter="s",
    ),
}
