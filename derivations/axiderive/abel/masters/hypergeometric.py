"""The hypergeometric family: incomplete Beta, 2F1, 1F1, the moment of a cap, and Gamma in one spelling."""

from __future__ import annotations

import mpmath as mp
import sympy as sp
from sympy.core.function import ArgumentIndexError

from .base import Master, Number


class IncompleteBeta(Master):
    """B(z; p, q) = int_0^z u**(p - 1) (1 - u)**(q - 1) du, for p > 0, 0 <= z < 1 and any real q.

    SymPy's betainc lacks the value at z = 0, evaluation for q <= 0 and a readable LaTeX form.
    """

    nargs = 3

    @classmethod
    def eval(cls, z: sp.Expr, p: sp.Expr, q: sp.Expr) -> sp.Expr | None:
        return sp.S.Zero if z.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        z, p, q = self.args
        if argindex != 1:
            raise ArgumentIndexError(self, argindex)
        return z ** (p - 1) * (1 - z) ** (q - 1)

    @staticmethod
    def numeric(z: Number, p: Number, q: Number) -> Number:
        return mp.re(mp.betainc(p, q, 0, z))


class Hypergeometric(Master):
    """Gauss's 2F1(p, q; c; z) for z < 1, (11.93)."""

    nargs = 4

    @classmethod
    def eval(cls, p: sp.Expr, q: sp.Expr, c: sp.Expr, z: sp.Expr) -> sp.Expr | None:
        return sp.S.One if z.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        p, q, c, z = self.args
        if argindex != 4:
            raise ArgumentIndexError(self, argindex)
        return p * q / c * self.func(p + 1, q + 1, c + 1, z)

    @staticmethod
    def numeric(p: Number, q: Number, c: Number, z: Number) -> Number:
        return mp.hyp2f1(p, q, c, z)


class Kummer(Master):
    """Confluent 1F1(p; c; z)."""

    nargs = 3

    @classmethod
    def eval(cls, p: sp.Expr, c: sp.Expr, z: sp.Expr) -> sp.Expr | None:
        return sp.S.One if z.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        p, c, z = self.args
        if argindex != 3:
            raise ArgumentIndexError(self, argindex)
        return p / c * self.func(p + 1, c + 1, z)

    @staticmethod
    def numeric(p: Number, c: Number, z: Number) -> Number:
        return mp.hyp1f1(p, c, z)


class CapMoment(Master):
    """J(k; b, R, a) = int_0^b s (R**2 - s**2)**(-1/2) (a**2 - s**2)**((k - 1)/2) ds, for b < a, b < R.

    The slope in a follows from the derivative of sqrt(R^2 - s^2) (a^2 - s^2)**((k-1)/2), which
    lowers k by two.
    """

    nargs = 4

    @classmethod
    def eval(cls, k: sp.Expr, b: sp.Expr, R: sp.Expr, a: sp.Expr) -> sp.Expr | None:
        return sp.S.Zero if b.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
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
