"""The master integrals: functions that SymPy lacks, each with its definition, derivative and value in numbers.

The master integrals that are not functions SymPy already has.

Each class states its definition once, knows its derivatives (`fdiff`, the only
thing a certificate uses), its value where it vanishes, and how to evaluate
itself with mpmath (`numeric`, at the working precision in force).

What every master integral has in common.

The hypergeometric family: incomplete Beta, 2F1, 1F1, the moment of a cap, and Gamma in one spelling.

Integrals of inverse functions: dilogarithms and the one of a break without any shorter form.

Functions of profiles with waves and bells: Struve and Dawson.

Oblate coordinates, in which fields below the surface are elementary.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import mpmath as mp
import sympy as sp
from sympy.core.function import ArgumentIndexError

Number: TypeAlias = mp.mpf


class Master(sp.Function):
    """Common part: evaluation through `numeric`, inside the requested precision."""

    @staticmethod
    def numeric(*args: Any, **options: Any) -> Number:
        """The value at numbers of mpmath, at the working precision; `TypeError` if a class does not define it."""
        message = "a master integral must say how it is evaluated"
        raise TypeError(message)

    def _eval_evalf(self, prec: int) -> sp.Float:
        with mp.workprec(prec + 20):
            # an integer would come as int, whose powers and quotients are floats
            values = [mp.mpf(arg._to_mpmath(prec + 20)) for arg in self.args]
            # the Float must be made from the raw number: sp.Float(value) would fall back to 53 bits
            return sp.Float._new(mp.mpf(self.numeric(*values))._mpf_, prec)


class IncompleteBeta(Master):
    """B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any real q.

    SymPy's betainc lacks the value at z = 0, evaluation for q <= 0 and a readable LaTeX form.
    """

    nargs = 3

    @classmethod
    def eval(cls, z: sp.Expr, p: sp.Expr, q: sp.Expr) -> sp.Expr | None:
        """Zero at z = 0; otherwise None, which leaves the function as it is."""
        return sp.S.Zero if z.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in z; `ArgumentIndexError` for p and q."""
        z, p, q = self.args
        if argindex != 1:
            raise ArgumentIndexError(self, argindex)
        return z ** (p - 1) * (1 - z) ** (q - 1)

    @staticmethod
    def numeric(z: Number, p: Number, q: Number) -> Number:
        """B(z; p, q) by the `betainc` of mpmath, its real part."""
        return mp.re(mp.betainc(p, q, 0, z))


class Hypergeometric(Master):
    """Gauss's 2F1(p, q; c; z) for z < 1, (11.93)."""

    nargs = 4

    @classmethod
    def eval(cls, p: sp.Expr, q: sp.Expr, c: sp.Expr, z: sp.Expr) -> sp.Expr | None:
        """One at z = 0; otherwise None, which leaves the function as it is."""
        return sp.S.One if z.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in z, p q/c times the function with p, q, c raised by 1; `ArgumentIndexError` for p, q, c."""
        p, q, c, z = self.args
        if argindex != 4:
            raise ArgumentIndexError(self, argindex)
        return p * q / c * self.func(p + 1, q + 1, c + 1, z)

    @staticmethod
    def numeric(p: Number, q: Number, c: Number, z: Number) -> Number:
        """2F1(p, q; c; z) by the `hyp2f1` of mpmath."""
        return mp.hyp2f1(p, q, c, z)


class Kummer(Master):
    """Confluent 1F1(p; c; z)."""

    nargs = 3

    @classmethod
    def eval(cls, p: sp.Expr, c: sp.Expr, z: sp.Expr) -> sp.Expr | None:
        """One at z = 0; otherwise None, which leaves the function as it is."""
        return sp.S.One if z.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in z, p/c times the function with p and c raised by 1; `ArgumentIndexError` for p and c."""
        p, c, z = self.args
        if argindex != 3:
            raise ArgumentIndexError(self, argindex)
        return p / c * self.func(p + 1, c + 1, z)

    @staticmethod
    def numeric(p: Number, c: Number, z: Number) -> Number:
        """1F1(p; c; z) by the `hyp1f1` of mpmath."""
        return mp.hyp1f1(p, c, z)


class CapMoment(Master):
    """J(k; b, R, a) = int_0^b s (R**2 - s**2)**(-1/2) (a**2 - s**2)**((k - 1)/2) ds, for b < a, b < R.

    The slope in a follows from the derivative of sqrt(R^2 - s^2) (a^2 - s^2)**((k-1)/2), which
    lowers k by two.
    """

    nargs = 4

    @classmethod
    def eval(cls, k: sp.Expr, b: sp.Expr, R: sp.Expr, a: sp.Expr) -> sp.Expr | None:
        """Zero at b = 0; otherwise None, which leaves the function as it is."""
        return sp.S.Zero if b.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in b or in a; `ArgumentIndexError` for k and R."""
        k, b, R, a = self.args
        if argindex == 2:
            return b * (R**2 - b**2) ** (-sp.S.Half) * (a**2 - b**2) ** ((k - 1) / 2)
        if argindex != 4:
            raise ArgumentIndexError(self, argindex)
        half = (k - 1) / 2
        boundary = sp.sqrt(R**2 - b**2) * (a**2 - b**2) ** half - R * a ** (k - 1)
        return -a * (boundary + k * self) / (R**2 - a**2)

    @staticmethod
    def numeric(k: Number, b: Number, R: Number, a: Number) -> Number:
        """J(k; b, R, a) as the difference of a primitive, with more digits the smaller b is beside the radii."""
        gap, far, half = (R - a) * (R + a), min(a, R), mp.mpf(1) / 2

        def primitive(v: Number) -> Number:
            """In v = a^2 - s^2 or v = R^2 - s^2, whichever is the shorter way to a branch point."""
            if gap == 0:
                return v ** (k / 2) / k if k else mp.log(v) / 2
            if gap > 0:
                power = (k + 1) / 2
                return v**power / (k + 1) / mp.sqrt(gap) * mp.hyp2f1(half, power, power + 1, -v / gap)
            return mp.sqrt(v) * (-gap) ** ((k - 1) / 2) * mp.hyp2f1((1 - k) / 2, half, 3 * half, v / gap)

        # both primitives agree in as many digits as b is smaller than the radii
        with mp.extradps(max(0, 2 * int(mp.log10(far / b))) + 5):
            start = (far - b) * (far + b)
            return primitive(far * far) - (primitive(start) if start else mp.mpf(0))


def gamma_normalised(argument: sp.Expr) -> sp.Expr:
    """gamma(argument) with its rational shift moved into (0, 1]: gamma(7/4) -> 3/4*gamma(3/4).

    SymPy leaves gamma shifts as they come, so equal results would print differently.
    """
    shift, rest = sp.expand(argument).as_coeff_Add()
    steps = int(sp.ceiling(shift)) - 1
    base = shift - steps + rest
    value = sp.gamma(base)
    for i in range(abs(steps)):
        value = value * (base + i) if steps > 0 else value / (base - 1 - i)
    return value


class C0(Master):
    """C0(b, r, a) = int_{max(b, r)}^a acos(b/t) / sqrt(t**2 - r**2) dt, for 0 <= b, r < a.

    One per break with a jump of f' that is not an odd polynomial; no form in
    elementary functions and elliptic integrals was found.
    """

    nargs = 3

    @classmethod
    def eval(cls, b: sp.Expr, r: sp.Expr, a: sp.Expr) -> sp.Expr | None:
        """pi/2 acosh(a/r) at b = 0, zero where a is b or r; otherwise None, which leaves the function as it is."""
        if b.is_zero:
            return sp.pi / 2 * sp.acosh(a / r)
        if a in (b, r):
            return sp.S.Zero
        return None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in the upper limit a; `ArgumentIndexError` for b and r."""
        b, r, a = self.args
        if argindex != 3:
            raise ArgumentIndexError(self, argindex)
        return sp.acos(b / a) / sp.sqrt(a**2 - r**2)

    @staticmethod
    def numeric(b: Number, r: Number, a: Number) -> Number:
        """The integral by quadrature, in a variable in which the integrand has no root."""
        # sigma = sqrt(t^2 - b^2) = c sinh v (r < b) or c cosh v (r > b) removes both roots and stays smooth as r -> b
        if r == b:
            return mp.quad(lambda x: mp.atan(x) / mp.hypot(1, x), [0, mp.sqrt((a - b) * (a + b)) / b])
        c = mp.sqrt(abs((r - b) * (r + b)))
        curve, top = (mp.cosh, mp.acosh) if r > b else (mp.sinh, mp.asinh)

        def integrand(v: Number) -> Number:
            sigma = c * curve(v)
            return mp.atan(sigma / b) * sigma / mp.hypot(b, sigma)

        end = top(mp.sqrt((a - b) * (a + b)) / c)
        # one panel per unit of v: the integrand has singularities at distance pi/2 from the real axis
        return mp.quad(integrand, mp.linspace(0, end, int(mp.ceil(end / 2)) + 1))


class LegendreChi2(Master):
    """chi_2(x) = int_0^x atanh(t)/t dt = (Li_2(x) - Li_2(-x))/2, for 0 <= x < 1."""

    nargs = 1

    @classmethod
    def eval(cls, x: sp.Expr) -> sp.Expr | None:
        """Zero at x = 0; otherwise None, which leaves the function as it is."""
        return sp.S.Zero if x.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in the argument, atanh(x)/x."""
        (x,) = self.args
        return sp.atanh(x) / x

    @staticmethod
    def numeric(x: Number) -> Number:
        """Half the difference of the dilogarithms at x and -x, its real part."""
        return mp.re(mp.polylog(2, x) - mp.polylog(2, -x)) / 2


class ArctanIntegral(Master):
    """Ti_2(x) = int_0^x atan(t)/t dt = Im Li_2(i x)."""

    nargs = 1

    @classmethod
    def eval(cls, x: sp.Expr) -> sp.Expr | None:
        """Zero at x = 0; otherwise None, which leaves the function as it is."""
        return sp.S.Zero if x.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in the argument, atan(x)/x."""
        (x,) = self.args
        return sp.atan(x) / x

    @staticmethod
    def numeric(x: Number) -> Number:
        """The imaginary part of the dilogarithm at i x; for x > 1 from the value at 1/x."""
        if x > 1:
            return ArctanIntegral.numeric(1 / x) + mp.pi / 2 * mp.log(x)
        return mp.im(mp.polylog(2, mp.mpc(0, x)))


class StruveH(Master):
    """Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0."""

    nargs = 2
    _sign = -1

    @classmethod
    def eval(cls, nu: sp.Expr, z: sp.Expr) -> sp.Expr | None:
        """Zero at z = 0 for an order that is known to be above -1; otherwise None."""
        return sp.S.Zero if z.is_zero and (nu + 1).is_positive else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in z, by the order below or, for order 0, by order 1; `ArgumentIndexError` for nu."""
        nu, z = self.args
        if argindex != 2:
            raise ArgumentIndexError(self, argindex)
        if nu == 0:
            return 2 / sp.pi + self._sign * self.func(1, z)
        return self.func(nu - 1, z) - nu / z * self

    @staticmethod
    def numeric(nu: Number, z: Number) -> Number:
        """H_nu(z) by the `struveh` of mpmath."""
        return mp.struveh(nu, z)


class StruveL(StruveH):
    """Modified Struve function L_nu(z); L_0' = 2/pi + L_1 and (z L_1)' = z L_0."""

    _sign = 1

    @staticmethod
    def numeric(nu: Number, z: Number) -> Number:
        """L_nu(z) by the `struvel` of mpmath."""
        return mp.struvel(nu, z)


class Dawson(Master):
    """D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D."""

    nargs = 1

    @classmethod
    def eval(cls, x: sp.Expr) -> sp.Expr | None:
        """Zero at x = 0; otherwise None, which leaves the function as it is."""
        return sp.S.Zero if x.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in the argument, 1 - 2 x D(x)."""
        return 1 - 2 * self.args[0] * self

    @staticmethod
    def numeric(x: Number) -> Number:
        """D(x) by the `erfi` of mpmath."""
        return mp.sqrt(mp.pi) / 2 * mp.exp(-x * x) * mp.erfi(x)


class Oblate(Master):
    """Common part of the oblate coordinates of the point (r, z) about the circle of radius t, z >= 0.

    (xi + i eta)**2 = r**2 + (z + i t)**2 with xi, eta >= 0, so that xi eta = z t.
    """

    nargs = 3

    @staticmethod
    def pair(r: Number, z: Number, t: Number) -> tuple[Number, Number]:
        """xi and eta; the smaller one from the product of both, where the difference of squares would cancel."""
        rest = (r - t) * (r + t) + z * z
        large = mp.sqrt((mp.hypot(r - t, z) * mp.hypot(r + t, z) + abs(rest)) / 2)
        small = z * t / large if large else large
        return (large, small) if rest >= 0 else (small, large)


class Xi(Oblate):
    """xi(r, z, t), the real part of sqrt(r**2 + (z + i t)**2): r and z far away, zero on the disc of radius t."""

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in r, z or t."""
        r, z, t = self.args
        eta = Eta(r, z, t)
        above = (r * self, z * self + t * eta, z * eta - t * self)
        return above[argindex - 1] / (self**2 + eta**2)

    @staticmethod
    def numeric(r: Number, z: Number, t: Number) -> Number:
        """xi from square roots of sums without cancellation."""
        return Oblate.pair(r, z, t)[0]


class Eta(Oblate):
    """eta(r, z, t), the imaginary part of sqrt(r**2 + (z + i t)**2): between 0 and t, zero beside the disc."""

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in r, z or t."""
        r, z, t = self.args
        xi = Xi(r, z, t)
        above = (-r * self, t * xi - z * self, z * xi + t * self)
        return above[argindex - 1] / (xi**2 + self**2)

    @staticmethod
    def numeric(r: Number, z: Number, t: Number) -> Number:
        """eta from square roots of sums without cancellation."""
        return Oblate.pair(r, z, t)[1]


MASTERS: tuple[type[Master], ...] = (
    C0, LegendreChi2, ArctanIntegral, IncompleteBeta, StruveH, StruveL, Dawson, Hypergeometric, Kummer, CapMoment, Xi,
    Eta,
)  # fmt: skip

__all__ = [
    "C0", "MASTERS", "ArctanIntegral", "CapMoment", "Dawson", "Eta", "Hypergeometric", "IncompleteBeta", "Kummer",
    "LegendreChi2", "Master", "StruveH", "StruveL", "Xi", "gamma_normalised",
]  # fmt: skip
