"""Integrals of inverse functions: dilogarithms and the one of a break without any shorter form."""

from __future__ import annotations

import mpmath as mp
import sympy as sp
from sympy.core.function import ArgumentIndexError

from .base import Master, Number


class C0(Master):
    """C0(b, r, a) = int_{max(b, r)}^a acos(b/t) / sqrt(t**2 - r**2) dt, for 0 <= b, r < a.

    One per break with a jump of f' that is not an odd polynomial; no form in
    elementary functions and elliptic integrals was found.
    """

    nargs = 3

    @classmethod
    def eval(cls, b: sp.Expr, r: sp.Expr, a: sp.Expr) -> sp.Expr | None:
        if b.is_zero:
            return sp.pi / 2 * sp.acosh(a / r)
        if a in (b, r):
            return sp.S.Zero
        return None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        b, r, a = self.args
        if argindex != 3:
            raise ArgumentIndexError(self, argindex)
        return sp.acos(b / a) / sp.sqrt(a**2 - r**2)

    @staticmethod
    def numeric(b: Number, r: Number, a: Number) -> Number:
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
        return sp.S.Zero if x.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        (x,) = self.args
        return sp.atanh(x) / x

    @staticmethod
    def numeric(x: Number) -> Number:
        return mp.re(mp.polylog(2, x) - mp.polylog(2, -x)) / 2


class ArctanIntegral(Master):
    """Ti_2(x) = int_0^x atan(t)/t dt = Im Li_2(i x)."""

    nargs = 1

    @classmethod
    def eval(cls, x: sp.Expr) -> sp.Expr | None:
        return sp.S.Zero if x.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        (x,) = self.args
        return sp.atan(x) / x

    @staticmethod
    def numeric(x: Number) -> Number:
        if x > 1:
            return ArctanIntegral.numeric(1 / x) + mp.pi / 2 * mp.log(x)
        return mp.im(mp.polylog(2, mp.mpc(0, x)))
