"""Atoms with a single scale whose depth needs a special function: cosine, Gaussian, exponential.

Depth and force are closed; pressure and displacement stay single integrals.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..entry import Primitive
from ..notation import a, r, x
from .form import Form, Order
from .masters import Dawson, Kummer, StruveH, StruveL, gamma_normalised
from .moments import ONE, ZERO


class _SingleScale:
    """Common part: no further closed forms."""

    def primitives(self, order: Order, k: sp.Expr = ZERO) -> tuple[Primitive, ...]:
        """An empty tuple: no antiderivative is known."""
        return ()

    def pressure(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """None: no closed form is known."""
        return None

    def displacement(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """None: no closed form is known."""
        return None


@dataclass(frozen=True)
class CosineAtom(_SingleScale):
    """h (1 - cos(q r)); int_0^a sin(q s)/sqrt(a^2 - s^2) ds = pi/2 H_0(q a)."""

    h: sp.Expr
    q: sp.Expr

    def shape(self, order: Order) -> sp.Expr:
        """f(r), one formula for every r."""
        return self.h * (1 - sp.cos(self.q * r))

    def depth(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """int_0^a sin(q s) (a^2 - s^2)**((k-1)/2) ds = sqrt(pi)/2 Gamma((1+k)/2) (2a/q)**(k/2) H_{k/2}(q a)."""
        return Form.of(StruveH(k / 2, self.q * a), self._scale(k) * a ** (1 - k / 2))

    def force(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """(1 + k) F^ = a**(1+k) g - scale a**(1 + k/2) H_{1 + k/2}(q a)/q, by (z**nu H_nu)' = z**nu H_{nu-1}."""
        whole = Form.of(StruveH(k / 2, self.q * a), a ** (2 + k / 2))
        rest = Form.of(StruveH(1 + k / 2, self.q * a), -(1 + k) * a ** (1 + k / 2) / self.q)
        return (whole + rest) * (self._scale(k) / (1 + k))

    def _scale(self, k: sp.Expr) -> sp.Expr:
        beta = gamma_normalised((1 + k) / 2) * sp.sqrt(sp.pi) / 2
        return beta * self.h * self.q * (2 / self.q) ** (k / 2)


@dataclass(frozen=True)
class GaussianAtom(_SingleScale):
    """h (1 - exp(-r^2/s^2)); the depth is 2 h z D(z) with z = a/s and Dawson's D."""

    h: sp.Expr
    s: sp.Expr

    def shape(self, order: Order) -> sp.Expr:
        """f(r), one formula for every r."""
        return self.h * (1 - sp.exp(-(r**2) / self.s**2))

    def depth(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """g(a) by Dawson's function for k = 0, by Kummer's for any other k."""
        if k == 0:
            return Form.of(Dawson(a / self.s), 2 * self.h * a / self.s)
        z = a**2 / self.s**2
        return Form.of(Kummer(ONE, (3 + k) / 2, -z), 2 * self.h * z / (1 + k))

    def primitives(self, order: Order, k: sp.Expr = ZERO) -> tuple[Primitive, ...]:
        """Dawson's or Kummer's function of (a^2 - x^2)/s^2, times exp(-x^2/s^2)."""
        bell, width = sp.exp(-(x**2) / self.s**2), a**2 - x**2
        integrand = 2 * self.h * a ** (1 - k) * x / self.s**2 * bell * width ** ((k - 1) / 2)
        if k == 0:
            return (Primitive(ZERO, a, integrand, -2 * a * self.h / self.s * bell * Dawson(sp.sqrt(width) / self.s)),)
        half = (1 + k) / 2
        tail = width**half * bell * Kummer(ONE, half + 1, -width / self.s**2) / half
        return (Primitive(ZERO, a, integrand, -self.h * a ** (1 - k) / self.s**2 * tail),)

    def force(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """F^(a) by Dawson's function for k = 0, by Kummer's for any other k."""
        if k != 0:
            z = a**2 / self.s**2
            scale = 4 * self.h * z * a ** (1 + k) / ((1 + k) ** 2 * (3 + k))
            return Form.of(Kummer(sp.Integer(2), (5 + k) / 2, -z), scale)
        return Form.of(Dawson(a / self.s), self.h * (2 * a**2 / self.s + self.s)) + Form.of(ONE, -self.h * a)


@dataclass(frozen=True)
class ExponentialAtom(_SingleScale):
    """h (1 - exp(-r/s)); the depth is pi/2 h z (I_0(z) - L_0(z)) with z = a/s."""

    h: sp.Expr
    s: sp.Expr

    def shape(self, order: Order) -> sp.Expr:
        """f(r), one formula for every r."""
        return self.h * (1 - sp.exp(-r / self.s))

    def depth(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """g(a) by Bessel and Struve functions of order 0 for k = 0; None for any other k."""
        z = a / self.s
        return Form.of(sp.besseli(0, z) - StruveL(0, z), sp.pi / 2 * self.h * z) if k == 0 else None

    def force(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """F^(a) by Bessel and Struve functions of orders 0 and 1 for k = 0; None for any other k."""
        if k != 0:
            return None
        z = a / self.s
        form = Form.of(sp.besseli(0, z) - StruveL(0, z), sp.pi / 2 * self.h * a * z)
        return form + Form.of(sp.besseli(1, z) - StruveL(1, z), -sp.pi / 2 * self.h * a)
