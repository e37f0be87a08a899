"""Domains of the keyword parameters in words, and the units of all arguments: what messages need."""

from __future__ import annotations

from typing import NamedTuple


class Domain(NamedTuple):
    """Where a parameter may lie, and what it is."""

    rule: str
    meaning: str
    closed: str = ""
    """The end that belongs to the domain, "low" or "high"."""
    instead: str = ""
    """What to use for a value outside."""
    letter: str = ""
    """How the interface writes the parameter, where it shares its letter with another one."""
    otherwise: str = ""
    """The parameter that stands for it where it is not given."""


SYMBOLS = {
    "a": Domain("a > 0", "contact radius, in m"),
    "d": Domain("d >= 0", "indentation depth of the point r = 0, in m", closed="low"),
    "F": Domain("F >= 0", "normal force, in N", closed="low"),
    "E_star": Domain("E_star > 0", "effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i, in Pa"),
    "k": Domain(
        "-1 < k < 1",
        "exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space",
        instead="use a modulus that grows less than linearly with depth, or k = 0 for a homogeneous half-space",
    ),
    "H": Domain("H > 0", "foundation modulus of the graded half-space, c_N(x) = H |x|^k, in Pa m^(-k)"),
    "dgamma": Domain(
        "dgamma >= 0",
        "work of separation per unit area, in N/m",
        closed="low",
        instead="use dgamma = 0 for a contact without adhesion",
    ),
    "mu": Domain(
        "mu >= 0",
        "coefficient of friction",
        closed="low",
        instead="give the coefficient as a positive number, or mu = 0 for a contact without friction",
    ),
    "G_star": Domain("G_star > 0", "effective shear modulus, 1/G_star = sum (2 - nu_i)/(4 G_i), in Pa"),
    "theta": Domain("0 < theta < pi/2", "inclination of the flank to the surface, in rad"),
    "R": Domain("R > 0", "radius of curvature, in m"),
    "R1": Domain("R1 > 0", "radius of curvature of the inner part, in m"),
    "R2": Domain("R2 > 0", "radius of curvature of the outer part, in m"),
    "b": Domain("b > 0", "radius at which the profile breaks, or its length across, in m"),
    "n": Domain("n > 0", "exponent of the profile"),
    "A": Domain("A > 0", "coefficient of a power-law profile, in m^(1-n)"),
    "h": Domain("h > 0", "height or depth of the profile, in m"),
    "s": Domain("s > 0", "length scale of the profile, in m"),
    "wavelength": Domain("wavelength > 0", "wavelength of the waviness, in m"),
    "H_x": Domain("H_x > 0", "tangential foundation modulus, c_T(x) = H_x |x|^k, in Pa m^(-k)"),
    "v": Domain(
        "v > 0",
        "speed of indentation, d = v t, in m/s",
        instead="a shrinking contact does not obey the rule of Lee and Radok, use v > 0; see retract_force",
    ),
    "E": Domain("E > 0", "effective (plane-strain) modulus of the viscoelastic law, in Pa"),
    "E_inf": Domain("E_inf > 0", "long-time effective modulus, in Pa"),
    "E_1": Domain("E_1 >= 0", "relaxing part of the effective modulus, in Pa", closed="low"),
    "eta": Domain("eta > 0", "effective viscosity, in Pa s"),
    "relaxation": Domain("tau > 0", "relaxation time, in s", letter="tau"),
    "alpha": Domain(
        "0 < alpha < 1",
        "exponent of power-law creep",
        instead="use the Maxwell law for a fluid (alpha = 1) and the elastic contact for alpha = 0",
    ),
    "t_0": Domain("t_0 > 0", "reference time of power-law creep, J = (t/t_0)^alpha/E, in s"),
    "v_2": Domain("v_2 > 0", "speed of retraction, from t_h on, in m/s"),
    "t_m": Domain("t_m > 0", "time at which the indenter stops, in s"),
    "t_h": Domain(
        "t_h >= t_m",
        "time at which the indenter goes back, held at v t_m until then, in s",
        closed="low",
        otherwise="t_m",
    ),
    "young_1": Domain("E_1 > 0", "Young's modulus of the first body, in Pa", letter="E_1"),
    "young_2": Domain("E_2 > 0", "Young's modulus of the second body, in Pa", letter="E_2"),
    "C_11": Domain("C_11 > 0", "elastic constant, along the surface, in Pa"),
    "C_33": Domain("C_33 > 0", "elastic constant, into the half-space, in Pa"),
    "C_13": Domain("-oo < C_13 < oo", "elastic constant of both directions, its square below C_11 C_33, in Pa"),
    "C_44": Domain("C_44 > 0", "shear modulus in planes across the surface, in Pa"),
    "E_0": Domain("E_0 > 0", "Young's modulus at the depth of reference, in Pa"),
    "c_0": Domain("c_0 > 0", "depth of reference of the graded half-space, in m"),
    "nu": Domain("-1 < nu <= 1/2", "Poisson ratio", closed="high"),
    "nu_1": Domain("-1 < nu_1 <= 1/2", "Poisson ratio of the first body", closed="high"),
    "nu_2": Domain("-1 < nu_2 <= 1/2", "Poisson ratio of the second body", closed="high"),
    "radius_1": Domain("R_1 > 0", "radius of the first body, in m", letter="R_1"),
    "radius_2": Domain("-oo < R_2 < oo", "radius of the second body, negative for a cup, in m", letter="R_2"),
    "z_0": Domain("z_0 > 0", "distance of the surfaces at which they do not attract, in m"),
    "sigma_0": Domain("sigma_0 > 0", "greatest stress of the attraction, in Pa"),
    "p_0": Domain("p_0 > 0", "scale of a prescribed pressure, in Pa"),
    "sigma": Domain(
        "s > -1",
        "exponent of a prescribed pressure",
        instead="a steeper edge carries an infinite force, use s > -1",
        letter="s",
    ),
    "G": Domain("G > 0", "shear modulus of the half-space, in Pa"),
    "twist": Domain("twist >= 0", "angle by which the punch turns, in rad", closed="low", letter="beta"),
    "thickness": Domain("thickness > 0", "thickness of the layer, in m"),
}
UNITS = {
    "r": "m",
    "a": "m",
    "d": "m",
    "F": "N",
    "z": "m",
    "E_star": "Pa",
    "k": "1",
    "H": "Pa m^(-k)",
    "dgamma": "N/m",
    "mu": "1",
    "G_star": "Pa",
    "theta": "rad",
    "R": "m",
    "R1": "m",
    "R2": "m",
    "b": "m",
    "n": "1",
    "A": "m^(1-n)",
    "h": "m",
    "wavelength": "m",
    "c": "m",
    "H_x": "Pa m^(-k)",
    "F_x": "N",
    "P": "N/m",
    "L": "m",
    "e": "m",
    "t": "s",
    "v": "m/s",
    "E": "Pa",
    "E_inf": "Pa",
    "E_1": "Pa",
    "eta": "Pa s",
    "tau": "s",
    "alpha": "1",
    "t_0": "s",
    "v_2": "m/s",
    "t_m": "s",
    "t_h": "s",
    "E_2": "Pa",
    "C_11": "Pa",
    "C_33": "Pa",
    "C_13": "Pa",
    "C_44": "Pa",
    "E_0": "Pa",
    "c_0": "m",
    "nu": "1",
    "nu_1": "1",
    "nu_2": "1",
    "R_1": "m",
    "R_2": "m",
    "z_0": "m",
    "sigma_0": "Pa",
    "p_0": "Pa",
    "x": "m",
    "G": "Pa",
    "beta": "rad",
    "thickness": "m",
}
"""Units of the arguments, by their letters in the interface."""
