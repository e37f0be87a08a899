"""The master integrals: functions that SymPy lacks.

Each class states its definition once, knows its derivatives (all that a certificate uses of it), its value where it
vanishes, and how to evaluate itself with mpmath (`numeric`, at the working precision in force).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, ClassVar, TypeAlias

import mpmath as mp
import sympy as sp
from sympy.core.function import ArgumentIndexError

Number: TypeAlias = mp.mpf


class Master(sp.Function):
    """Common part: what a class states of itself, and evaluation inside the requested precision."""

    end: ClassVar[tuple[int, sp.Expr] | None] = None
    """The place of the argument at whose zero the value is known, and that value."""
    slopes: ClassVar[Mapping[int, Callable[..., sp.Expr]]] = {}
    """The derivatives that are known, by the place of their argument, from 1, as `fdiff` counts."""

    @classmethod
    def eval(cls, *args: sp.Expr) -> sp.Expr | None:
        """The value at the end where it is known; otherwise None, which leaves the function as it is."""
        return cls.end[1] if cls.end and args[cls.end[0]].is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """The derivative in an argument; `ArgumentIndexError` where none is stated."""
        if argindex not in self.slopes:
            raise ArgumentIndexError(self, argindex)
        return self.slopes[argindex](*self.args)

    @staticmethod
    def numeric(*args: Any) -> Number:
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

    nargs, end = 3, (0, sp.S.Zero)
    slopes = {1: lambda z, p, q: z ** (p - 1) * (1 - z) ** (q - 1)}
    numeric = staticmethod(lambda z, p, q: mp.re(mp.betainc(p, q, 0, z)))


class Hypergeometric(Master):
    """Gauss's 2F1(p, q; c; z) for z < 1, (11.93)."""

    nargs, end = 4, (3, sp.S.One)
    slopes = {4: lambda p, q, c, z: p * q / c * Hypergeometric(p + 1, q + 1, c + 1, z)}
    numeric = staticmethod(mp.hyp2f1)


class Kummer(Master):
    """Confluent 1F1(p; c; z)."""

    nargs, end = 3, (2, sp.S.One)
    slopes = {3: lambda p, c, z: p / c * Kummer(p + 1, c + 1, z)}
    numeric = staticmethod(mp.hyp1f1)


class CapMoment(Master):
    """J(k; b, R, a) = int_0^b s (R**2 - s**2)**(-1/2) (a**2 - s**2)**((k - 1)/2) ds, for b < a, b < R.

    The slope in a follows from the derivative of sqrt(R^2 - s^2) (a^2 - s^2)**((k-1)/2), which
    lowers k by two.
    """

    nargs, end = 4, (1, sp.S.Zero)

    @staticmethod
    def _slope(k: sp.Expr, b: sp.Expr, R: sp.Expr, a: sp.Expr) -> sp.Expr:
        boundary = sp.sqrt(R**2 - b**2) * (a**2 - b**2) ** ((k - 1) / 2) - R * a ** (k - 1)
        return -a * (boundary + k * CapMoment(k, b, R, a)) / (R**2 - a**2)

    slopes = {2: lambda k, b, R, a: b * (R**2 - b**2) ** (-sp.S.Half) * (a**2 - b**2) ** ((k - 1) / 2), 4: _slope}

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

    slopes = {3: lambda b, r, a: sp.acos(b / a) / sp.sqrt(a**2 - r**2)}

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

    nargs, end = 1, (0, sp.S.Zero)
    slopes = {1: lambda x: sp.atanh(x) / x}
    numeric = staticmethod(lambda x: mp.re(mp.polylog(2, x) - mp.polylog(2, -x)) / 2)


class ArctanIntegral(Master):
    """Ti_2(x) = int_0^x atan(t)/t dt = Im Li_2(i x)."""

    nargs, end = 1, (0, sp.S.Zero)
    slopes = {1: lambda x: sp.atan(x) / x}

    @staticmethod
    def numeric(x: Number) -> Number:
        """The imaginary part of the dilogarithm at i x; for x > 1 from the value at 1/x."""
        if x > 1:
            return ArctanIntegral.numeric(1 / x) + mp.pi / 2 * mp.log(x)
        return mp.im(mp.polylog(2, mp.mpc(0, x)))


class StruveH(Master):
    """Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0."""

    nargs = 2
    slopes = {2: lambda nu, z: 2 / sp.pi - StruveH(1, z) if nu == 0 else StruveH(nu - 1, z) - nu / z * StruveH(nu, z)}
    numeric = staticmethod(mp.struveh)

    @classmethod
    def eval(cls, nu: sp.Expr, z: sp.Expr) -> sp.Expr | None:
        """Zero at z = 0 for an order that is known to be above -1; otherwise None."""
        return sp.S.Zero if z.is_zero and (nu + 1).is_positive else None


class StruveL(StruveH):
    """Modified Struve function L_nu(z); L_0' = 2/pi + L_1 and (z L_1)' = z L_0."""

    slopes = {2: lambda nu, z: 2 / sp.pi + StruveL(1, z) if nu == 0 else StruveL(nu - 1, z) - nu / z * StruveL(nu, z)}
    numeric = staticmethod(mp.struvel)


class Dawson(Master):
    """D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D."""

    nargs, end = 1, (0, sp.S.Zero)
    slopes = {1: lambda x: 1 - 2 * x * Dawson(x)}
    numeric = staticmethod(lambda x: mp.sqrt(mp.pi) / 2 * mp.exp(-x * x) * mp.erfi(x))


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
