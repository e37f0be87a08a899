"""Fields of flat punches, and their moments U_{j,m} = int_0^a t**j X_m(t) dt: all that polynomial slopes need.

A punch of radius t has X_m(t) = (r/q)**m/rho = int_0^oo exp(-k zeta) J_m(k r) dk with zeta = z + i t,
rho**2 = r**2 + zeta**2 and q = rho + zeta.  As d rho/dt = i zeta/rho and dq/dt = i q/rho, U_{0,m} is elementary; then

    j U_{j,0} = (2 j - 1) i z U_{j-1,0} + (j - 1) (r**2 + z**2) U_{j-2,0} - [t**(j-1) rho]_0^a
    U_{j+1,m} = i z U_{j,m} - i r/2 (U_{j,m-1} - U_{j,m+1}) for m > 0

by parts, and because zeta (r/q)**m = r/2 [(r/q)**(m-1) - (r/q)**(m+1)].  Real and imaginary parts are kept apart: in
the oblate coordinates of the edge rho = xi + i eta and q = (1 + eta/a) (xi + i a).
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..notation import a, r, z
from .form import Form
from .masters import Eta, Xi

CENTRE = sp.sqrt(r**2 + z**2)
"""rho of the radius zero."""
ONE = Form.of(sp.S.One)


@dataclass(frozen=True)
class Complex:
    """A complex combination of masters."""

    real: Form
    imaginary: Form

    def __add__(self, other: Complex) -> Complex:
        return Complex(self.real + other.real, self.imaginary + other.imaginary)

    def __mul__(self, scale: sp.Expr) -> Complex:
        return Complex(self.real * scale, self.imaginary * scale)

    def times(self, real: sp.Expr, imaginary: sp.Expr) -> Complex:
        """The product with a complex number."""
        return Complex(self.real * real + self.imaginary * -imaginary, self.real * imaginary + self.imaginary * real)

    def times_i(self, scale: sp.Expr) -> Complex:
        """The product with i and a real number."""
        return Complex(self.imaginary * -scale, self.real * scale)


def ratio(m: int, t: sp.Expr) -> Complex:
    """(r/q)**m of a punch of radius t; real for the radius zero."""
    if m == 0:
        return Complex(ONE, Form())
    if t == 0:
        return Complex(Form.of((r / (z + CENTRE)) ** m), Form())
    xi, eta = Xi(r, z, t), Eta(r, z, t)
    x, y = sp.symbols("x y", real=True)
    parts = sp.expand((x - sp.I * y) ** m).as_real_imag()
    modulus = (r * t / ((t + eta) * (xi**2 + t**2))) ** m
    real, imaginary = (Form.of(modulus * sp.factor_terms(part.subs({x: xi, y: t}))) for part in parts)
    return Complex(real, imaginary)


def kernel(m: int, t: sp.Expr) -> Complex:
    """X_m of a punch of radius t."""
    if t == 0:
        return ratio(m, t) * (1 / CENTRE)
    xi, eta = Xi(r, z, t), Eta(r, z, t)
    size = xi**2 + eta**2
    return ratio(m, t).times(xi / size, -eta / size)


def sharper(m: int, t: sp.Expr) -> Complex:
    """(zeta + m rho) X_m/rho**2 of a punch of radius t: what X_m loses with the depth."""
    xi, eta = Xi(r, z, t), Eta(r, z, t)
    size = xi**2 + eta**2
    found = kernel(m, t).times(z + m * xi, t + m * eta)
    return found.times((xi**2 - eta**2) / size**2, -2 * xi * eta / size**2)


def angle(t: sp.Expr) -> sp.Expr:
    """arg q of a punch of radius t, pi/2 on the face of the punch."""
    return sp.atan(t / Xi(r, z, t))


class Moments:
    """U_{j,m} up to the radius a, each derived once."""

    def __init__(self) -> None:
        self.known: dict[tuple[int, int], Complex] = {}

    def __call__(self, j: int, m: int) -> Complex:
        """U_{j,m}."""
        if (j, m) not in self.known:
            self.known[j, m] = self._of_power(j, m) if j else self._lowest(m)
        return self.known[j, m]

    def _lowest(self, m: int) -> Complex:
        if m:
            return (ratio(m, a) + ratio(m, sp.S.Zero) * sp.S.NegativeOne).times_i(sp.Rational(1, m))
        xi, eta = Xi(r, z, a), Eta(r, z, a)
        growth = sp.log((a + eta) * sp.sqrt(xi**2 + a**2) / (a * (z + CENTRE)))
        return Complex(Form.of(angle(a)), Form.of(growth, sp.S.NegativeOne))

    def _of_power(self, j: int, m: int) -> Complex:
        if m:
            between = self(j - 1, m - 1) + self(j - 1, m + 1) * sp.S.NegativeOne
            return self(j - 1, m).times_i(z) + between.times_i(-r / 2)
        end = Complex(Form.of(Xi(r, z, a)), Form.of(Eta(r, z, a))) * (-(a ** (j - 1)))
        found = self(j - 1, 0).times_i((2 * j - 1) * z) + end
        if j == 1:
            found = found + Complex(Form.of(CENTRE), Form())
        else:
            found = found + self(j - 2, 0) * ((j - 1) * (r**2 + z**2))
        return found * sp.Rational(1, j)
