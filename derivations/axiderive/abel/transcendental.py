"""Atoms with a single scale whose depth needs a special function: cosine, Gaussian, exponential.

Depth and force are closed; pressure and displacement stay single integrals.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..entry import Primitive
from ..notation import a, r
from .form import Form
from .masters import Dawson, StruveH, StruveL
from .moments import ONE, ZERO
from .order import Order


class _SingleScale:
    """Common part: no further closed forms."""

    def primitives(self, order: Order) -> tuple[Primitive, ...]:
        return ()

    def pressure(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        return None

    def displacement(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        return None


@dataclass(frozen=True)
class CosineAtom(_SingleScale):
    """h (1 - cos(q r)); int_0^a sin(q s)/sqrt(a^2 - s^2) ds = pi/2 H_0(q a)."""

    h: sp.Expr
    q: sp.Expr

    def shape(self, order: Order) -> sp.Expr:
        return self.h * (1 - sp.cos(self.q * r))

    def depth(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        return Form.of(StruveH(0, self.q * a), sp.pi / 2 * self.h * self.q * a) if k == 0 else None

    def force(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        if k != 0:
            return None
        form = Form.of(StruveH(0, self.q * a), sp.pi / 2 * self.h * self.q * a**2)
        return form + Form.of(StruveH(1, self.q * a), -sp.pi / 2 * self.h * a)


@dataclass(frozen=True)
class GaussianAtom(_SingleScale):
    """h (1 - exp(-r^2/s^2)); the depth is 2 h z D(z) with z = a/s and Dawson's D."""

    h: sp.Expr
    s: sp.Expr

    def shape(self, order: Order) -> sp.Expr:
        return self.h * (1 - sp.exp(-(r**2) / self.s**2))

    def depth(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        return Form.of(Dawson(a / self.s), 2 * self.h * a / self.s) if k == 0 else None

    def force(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        if k != 0:
            return None
        return Form.of(Dawson(a / self.s), self.h * (2 * a**2 / self.s + self.s)) + Form.of(ONE, -self.h * a)


@dataclass(frozen=True)
class ExponentialAtom(_SingleScale):
    """h (1 - exp(-r/s)); the depth is pi/2 h z (I_0(z) - L_0(z)) with z = a/s."""

    h: sp.Expr
    s: sp.Expr

    def shape(self, order: Order) -> sp.Expr:
        return self.h * (1 - sp.exp(-r / self.s))

    def depth(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        z = a / self.s
        return Form.of(sp.besseli(0, z) - StruveL(0, z), sp.pi / 2 * self.h * z) if k == 0 else None

    def force(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        if k != 0:
            return None
        z = a / self.s
        form = Form.of(sp.besseli(0, z) - StruveL(0, z), sp.pi / 2 * self.h * a * z)
        return form + Form.of(sp.besseli(1, z) - StruveL(1, z), -sp.pi / 2 * self.h * a)
