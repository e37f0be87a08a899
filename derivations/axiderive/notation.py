"""Every symbol once: name, LaTeX, dimension, domain and meaning.

The SymPy symbols of the engine are attributes of this module (`notation.a`,
`notation.E_star`); all of them are positive, which is what lets radicals be
split.  `describe(symbol)` gives the record behind a symbol.

Conventions fixed here for the whole catalogue: elliptic integrals take the
parameter m = k**2 in code (as SymPy and mpmath do) and print the modulus k;
`theta` is the inclination of the flank to the surface, in radians; lengths
share one unit, forces are length unit squared times the unit of E_star.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class Dimension:
    """Exponents of length and force; a stress is force / length**2."""

    length: sp.Expr
    force: sp.Expr

    @classmethod
    def of(cls, length: object = 0, force: object = 0) -> Dimension:
        """The dimension with these exponents, given as numbers or expressions; that of a number without any."""
        return cls(sp.sympify(length), sp.sympify(force))

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(sp.expand(self.length + other.length), sp.expand(self.force + other.force))

    def __pow__(self, exponent: object) -> Dimension:
        e = sp.sympify(exponent)
        return Dimension(sp.expand(self.length * e), sp.expand(self.force * e))


NUMBER = Dimension.of()
LENGTH = Dimension.of(1)
FORCE = Dimension.of(0, 1)
STRESS = Dimension.of(-2, 1)
STIFFNESS = Dimension.of(-1, 1)


@dataclass(frozen=True)
class Notation:
    """What the handbook, the docstrings and the error messages say about one symbol."""

    symbol: sp.Symbol
    latex: str
    dimension: Dimension
    unit: str
    domain: str
    meaning: str
    letter: str = ""
    """In the interface, where it is another than the name."""

    @property
    def name(self) -> str:
        """The name of the symbol, under which `describe` finds the record."""
        return str(self.symbol.name)


_RECORDS: dict[str, Notation] = {}


def define(
    name: str, latex: str, dimension: Dimension, unit: str, domain: str, meaning: str, letter: str = ""
) -> sp.Symbol:
    """A new symbol, positive, with its record; a physics defines the letters that no other one has."""
    symbol = sp.Symbol(name, positive=True)
    _RECORDS[name] = Notation(symbol, latex, dimension, unit, domain, meaning, letter)
    return symbol


def define_signed(name: str, latex: str, dimension: Dimension, unit: str, meaning: str, letter: str = "") -> sp.Symbol:
    """A new symbol with its record that may be negative as well."""
    symbol = sp.Symbol(name, real=True)
    _RECORDS[name] = Notation(symbol, latex, dimension, unit, "", meaning, letter)
    return symbol


def describe(symbol: sp.Symbol | sp.IndexedBase | str) -> Notation:
    """The record of a symbol; `KeyError` if the notation does not know it."""
    name = symbol if isinstance(symbol, str) else str(getattr(symbol, "label", symbol))
    return _RECORDS[name]


def known(name: str) -> bool:
    """Whether there is a record for a symbol of that name."""
    return name in _RECORDS


@contextmanager
def extended(records: Iterable[Notation]) -> Iterator[None]:
    """The notation with the parameters of a profile of the user's own, for as long as that profile is worked on."""
    before = dict(_RECORDS)
    _RECORDS.update({record.name: record for record in records})
    try:
        yield
    finally:
        _RECORDS.clear()
        _RECORDS.update(before)


def all_notation() -> tuple[Notation, ...]:
    """All records in order of definition (fields, loads, material, geometry, auxiliary)."""
    return tuple(_RECORDS.values())


# fmt: off
# fields: where a quantity is asked for, or what is asked
r = define("r", "r", LENGTH, "m", "r >= 0", "distance from the axis")
a = define("a", "a", LENGTH, "m", "a > 0", "contact radius")
d = define("d", "d", LENGTH, "m", "d > 0", "indentation depth of the point r = 0")
F = define("F", r"F_{\mathrm N}", FORCE, "N", "F > 0", "normal force")
p = define("p", "p", STRESS, "Pa", "", "contact pressure, positive in compression")
w = define("w", "w", LENGTH, "m", "", "surface displacement into the half-space")
f = define("f", "f", LENGTH, "m", "", "profile of the indenter, measured from its apex")
g = define("g", "g", LENGTH, "m", "", "indentation depth as a function of the contact radius")
p_mean = define("p_mean", r"\bar p", STRESS, "Pa", "", "mean pressure F/(pi a^2)")
r_zero = define("r_zero", "r_0", LENGTH, "m", "", "radius of the ring where the pressure first vanishes on unloading")
r_peak = define("r_peak", r"r_{\mathrm{max}}", LENGTH, "m", "", "radius of the ring of greatest pressure")
p_peak = define("p_peak", r"p_{\mathrm{max}}", STRESS, "Pa", "", "greatest pressure")
stiffness = define("stiffness", r"\frac{\mathrm dF_{\mathrm N}}{\mathrm dd}", STIFFNESS, "N/m", "",
                   "contact stiffness dF/dd")

# fields below the surface
z = define("z", "z", LENGTH, "m", "z >= 0", "depth below the surface")
S_0, S_1, S_2, S_3 = (
    define(f"S_{m}", f"S_{m}", NUMBER, "1", "", f"pressure below the surface, turned {m} times; pi p/E_star for m = 0")
    for m in range(4)
)
D_0, D_1, D_2, D_3 = (
    define(f"D_{m}", f"D_{m}", NUMBER, "1", "", f"-z times the derivative of S_{m} by the depth") for m in range(4)
)
W = define("W", "W", LENGTH, "m", "", "potential of the displacement, pi/2 of it on the surface")

# material
E_star = define("E_star", "E^{*}", STRESS, "Pa", "E_star > 0",
                "effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i")
k = define("k", "k", NUMBER, "1", "-1 < k < 1",
           "exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space")
H = define("H", "H", Dimension(-2 - k, sp.S.One), "Pa m^(-k)", "H > 0",
           "foundation modulus of the graded half-space, c_N(x) = H |x|^k")
dgamma = define("dgamma", r"\Delta\gamma", Dimension.of(-1, 1), "N/m", "dgamma >= 0", "work of separation per unit area")
mu = define("mu", r"\mu", NUMBER, "1", "mu >= 0", "coefficient of friction")
G_star = define("G_star", "G^{*}", STRESS, "Pa", "G_star > 0",
                "effective shear modulus, 1/G_star = sum (2 - nu_i)/(4 G_i)")

# geometry
theta = define("theta", r"\theta", NUMBER, "rad", "0 < theta < pi/2", "inclination of the flank to the surface")
R = define("R", "R", LENGTH, "m", "R > 0", "radius of curvature")
R1 = define("R1", "R_1", LENGTH, "m", "R1 > 0", "radius of curvature of the inner part")
R2 = define("R2", "R_2", LENGTH, "m", "R2 > 0", "radius of curvature of the outer part")
b = define("b", "b", LENGTH, "m", "b > 0", "radius at which the profile breaks, or its length across")
n = define("n", "n", NUMBER, "1", "n > 0", "exponent of the profile")
A = define("A", "A", Dimension(1 - n, sp.S.Zero), "m^(1-n)", "A > 0", "coefficient of a power-law profile")
h = define("h", "h", LENGTH, "m", "h > 0", "height or depth of the profile")
s = define("s", "s", LENGTH, "m", "s > 0", "length scale of the profile")
wavelength = define("wavelength", r"\lambda", LENGTH, "m", "wavelength > 0", "wavelength of the waviness")

# adhesive and tangential fields
c = define("c", "c", LENGTH, "m", "0 <= c <= a", "radius of the stick zone")
retraction = define("retraction", r"\Delta\ell", LENGTH, "m", "", "retraction at constant contact radius, rule of Hess")
a_c = define("a_c", r"a_{\mathrm c}", LENGTH, "m", "", "contact radius at pull-off")
H_x = define("H_x", "H_x", Dimension(-2 - k, sp.S.One), "Pa m^(-k)", "H_x > 0",
             "tangential foundation modulus, c_T(x) = H_x |x|^k")
F_x = define("F_x", "F_x", FORCE, "N", "", "tangential force")
tau = define("tau", r"\tau", STRESS, "Pa", "", "tangential traction")
u_0 = define("u_0", "u^{(0)}", LENGTH, "m", "", "tangential displacement of the rigid body")

# plane problem
P = define("P", "P", Dimension.of(-1, 1), "N/m", "P > 0", "line load, force per length of the strip of contact")
L = define("L", "L", LENGTH, "m", "L > a", "distance of the reference point from the middle of the contact")
x_zero = define("x_zero", "x_0", LENGTH, "m", "",
                "distance from the middle where the pressure first vanishes on unloading")
slope = define("slope", r"\frac{\mathrm dw}{\mathrm dx}", NUMBER, "1", "", "slope of the surface outside the contact")
tilt = define("tilt", r"\varphi", NUMBER, "rad", "", "inclination of the punch, deeper on the side of positive x")
width = define("width", r"\ell", LENGTH, "m", "", "width of the contact")
e = sp.Symbol("e", real=True)
_RECORDS["e"] = Notation(e, "e", LENGTH, "m", "-a < e < a", "eccentricity: the load acts at x = e")

# viscoelastic half-space: time, loading and material laws
time = define("time", "t", NUMBER, "s", "t >= 0", "time since first contact", letter="t")
v = define("v", "v", LENGTH, "m/s", "v > 0", "speed of indentation, d = v t")
E = define("E", "E", STRESS, "Pa", "E > 0", "effective (plane-strain) modulus of the viscoelastic law")
E_inf = define("E_inf", r"E_\infty", STRESS, "Pa", "E_inf > 0", "long-time effective modulus")
E_1 = define("E_1", "E_1", STRESS, "Pa", "E_1 >= 0", "relaxing part of the effective modulus")
eta = define("eta", r"\eta", STRESS, "Pa s", "eta > 0", "effective viscosity")
relaxation = define("relaxation", r"\tau", NUMBER, "s", "tau > 0", "relaxation time", letter="tau")
alpha = define("alpha", r"\alpha", NUMBER, "1", "0 < alpha < 1", "exponent of power-law creep")
t_0 = define("t_0", "t_0", NUMBER, "s", "t_0 > 0", "reference time of power-law creep, J = (t/t_0)^alpha/E")
v_2 = define("v_2", "v_2", LENGTH, "m/s", "v_2 > 0", "speed of retraction, from t_h on")
t_m = define("t_m", r"t_{\mathrm m}", NUMBER, "s", "t_m > 0", "time at which the indenter stops")
t_h = define("t_h", r"t_{\mathrm h}", NUMBER, "s", "t_h >= t_m", "time at which the indenter goes back, held at v t_m until then")
t_1 = define("t_1", "t_1", NUMBER, "s", "", "time before at which the contact was as large")
t_c = define("t_c", r"t_{\mathrm c}", NUMBER, "s", "", "time at which the contact ends")

# elastic constants of the bodies in contact
young_1 = define("young_1", "E_1", STRESS, "Pa", "E_1 > 0", "Young's modulus of the first body", letter="E_1")
young_2 = define("young_2", "E_2", STRESS, "Pa", "E_2 > 0", "Young's modulus of the second body", letter="E_2")
C_11 = define("C_11", "C_{11}", STRESS, "Pa", "C_11 > 0", "elastic constant, along the surface")
C_33 = define("C_33", "C_{33}", STRESS, "Pa", "C_33 > 0", "elastic constant, into the half-space")
C_13 = define_signed("C_13", "C_{13}", STRESS, "Pa", "elastic constant of both directions, its square below C_11 C_33")
C_44 = define("C_44", "C_{44}", STRESS, "Pa", "C_44 > 0", "shear modulus in planes across the surface")
E_0 = define("E_0", "E_0", STRESS, "Pa", "E_0 > 0", "Young's modulus at the depth of reference")
c_0 = define("c_0", "c_0", LENGTH, "m", "c_0 > 0", "depth of reference of the graded half-space")
nu, nu_1, nu_2 = (sp.Symbol(name, real=True) for name in ("nu", "nu_1", "nu_2"))
_RECORDS["nu"] = Notation(nu, r"\nu", NUMBER, "1", "-1 < nu <= 1/2", "Poisson ratio")
_RECORDS["nu_1"] = Notation(nu_1, r"\nu_1", NUMBER, "1", "-1 < nu_1 <= 1/2", "Poisson ratio of the first body")
_RECORDS["nu_2"] = Notation(nu_2, r"\nu_2", NUMBER, "1", "-1 < nu_2 <= 1/2", "Poisson ratio of the second body")
beta = define("beta", r"\beta", NUMBER, "1", "", "exponent of the stress function of the graded half-space")
h_N = define("h_N", r"h_{\mathrm N}", NUMBER, "1", "", "factor of the graded half-space, 1 for k = 0")
radius_1 = define("radius_1", "R_1", LENGTH, "m", "R_1 > 0", "radius of the first body", letter="R_1")
radius_2 = define_signed("radius_2", "R_2", LENGTH, "m", "radius of the second body, negative for a cup", letter="R_2")
z_0 = define("z_0", "z_0", LENGTH, "m", "z_0 > 0", "distance of the surfaces at which they do not attract")
sigma_0 = define("sigma_0", r"\sigma_0", STRESS, "Pa", "sigma_0 > 0", "greatest stress of the attraction")
mu_T = define("mu_T", r"\mu_{\mathrm T}", NUMBER, "1", "", "Tabor's number")
lambda_M = define("lambda_M", r"\lambda_{\mathrm M}", NUMBER, "1", "", "parameter of Maugis")

# prescribed pressure
p_0 = define("p_0", "p_0", STRESS, "Pa", "p_0 > 0", "scale of a prescribed pressure")
sigma = define("sigma", "s", NUMBER, "1", "s > -1", "exponent of a prescribed pressure", letter="s")

# auxiliary: integration variables, never arguments of a function
t = define("t", "t", LENGTH, "m", "", "integration variable, radius of an earlier contact")
x = define("x", "x", LENGTH, "m", "", "distance from the middle of a plane contact; lower limit of a primitive")
u = define("u", "u", LENGTH, "m", "", "regularised integration variable")
psi = define("psi", r"\psi", NUMBER, "rad", "", "regularised angle of integration")
C = define("C", "C", Dimension(1 - n, sp.S.Zero), "m^(1-n)", "",
           "coefficient h/a^n of a concave face, held fixed while the radius varies")
j = sp.Symbol("j", integer=True, positive=True)
N = sp.Symbol("N", integer=True, positive=True)
_RECORDS["j"] = Notation(j, "j", NUMBER, "1", "", "summation index")
_RECORDS["N"] = Notation(N, "N", NUMBER, "1", "", "degree of a polynomial profile")
coefficients = sp.IndexedBase("A")
