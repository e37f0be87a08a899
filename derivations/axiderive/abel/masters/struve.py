"""Functions of profiles with waves and bells: Struve and Dawson."""

from __future__ import annotations

import mpmath as mp
import sympy as sp
from sympy.core.function import ArgumentIndexError

from .base import Master, Number


class StruveH(Master):
    """Struve function H_nu(z), (11.97); H_0' = 2/pi - H_1 and (z H_1)' = z H_0."""

    nargs = 2
    _sign = -1

    @classmethod
    def eval(cls, nu: sp.Expr, z: sp.Expr) -> sp.Expr | None:
        return sp.S.Zero if z.is_zero and (nu + 1).is_positive else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        nu, z = self.args
        if argindex != 2:
            raise ArgumentIndexError(self, argindex)
        if nu == 0:
            return 2 / sp.pi + self._sign * self.func(1, z)
        return self.func(nu - 1, z) - nu / z * self

    @staticmethod
    def numeric(nu: Number, z: Number) -> Number:
        return mp.struveh(nu, z)


class StruveL(StruveH):
    """Modified Struve function L_nu(z); L_0' = 2/pi + L_1 and (z L_1)' = z L_0."""

    _sign = 1

    @staticmethod
    def numeric(nu: Number, z: Number) -> Number:
        return mp.struvel(nu, z)


class Dawson(Master):
    """D(x) = exp(-x**2) int_0^x exp(u**2) du, with D' = 1 - 2 x D."""

    nargs = 1

    @classmethod
    def eval(cls, x: sp.Expr) -> sp.Expr | None:
        return sp.S.Zero if x.is_zero else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return 1 - 2 * self.args[0] * self

    @staticmethod
    def numeric(x: Number) -> Number:
        return mp.sqrt(mp.pi) / 2 * mp.exp(-x * x) * mp.erfi(x)
