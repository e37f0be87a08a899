"""Atoms: the shapes every profile is a sum of, and their four Abel integrals.

With k the exponent of grading (k = 0: homogeneous half-space) an atom gives

    depth         g(a)  = a**(1-k) int_0^a f'(r) (a^2 - r^2)**((k-1)/2) dr            (11.61), (11.29)
    force         F^(a) = int_0^a t**k (g(a) - g(t)) dt                               (11.51), (11.20)
    pressure      P^(r) = int_r^a g'(t) (t^2 - r^2)**((k-1)/2) dt                     (11.53), (11.23)
    displacement  W^(r) = int_0^a t**k (g(a) - g(t)) (r^2 - t^2)**(-(1+k)/2) dt       (11.56)

without prefactors.  Exchanging the order of integration leaves one algebraic
integral for each, so no iterated integral appears.
A result that is not known in closed form is `None`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import sympy as sp

from ..entry import Primitive
from ..notation import a, r, x
from .form import Form, Order
from .masters import IncompleteBeta, gamma_normalised
from .moments import (
    ONE,
    ZERO,
    arccos_moment,
    depth_moment,
    elliptic_moment,
    outside_kernel,
    outside_moment,
    pressure_moment,
)


class Atom(Protocol):
    """Shape that is zero up to its break, with the four Abel integrals on a chain of lengths."""

    def shape(self, order: Order) -> sp.Expr:
        """f(r) on this order of the lengths, zero up to the break."""
        ...

    def depth(self, order: Order, k: sp.Expr) -> Form | None:
        """g(a), or None where no closed form is known; empty where the contact does not reach the break."""
        ...

    def primitives(self, order: Order, k: sp.Expr) -> tuple[Primitive, ...]:
        """Antiderivatives in x of the integrand of the depth; empty where none is known or needed."""
        ...

    def force(self, order: Order, k: sp.Expr) -> Form | None:
        """F^(a), or None where no closed form is known."""
        ...

    def pressure(self, order: Order, k: sp.Expr) -> Form | None:
        """P^(r) for r < a, or None where no closed form is known."""
        ...

    def displacement(self, order: Order, k: sp.Expr) -> Form | None:
        """W^(r) for r > a, or None where no closed form is known."""
        ...


def depth_kernel(slope: sp.Expr, k: sp.Expr) -> sp.Expr:
    """Integrand of (11.61) in x for the slope f'(x)."""
    return a ** (1 - k) * slope * (a**2 - x**2) ** ((k - 1) / 2)


@dataclass(frozen=True)
class PowerAtom:
    """c (r**n - b**n) for r > b; carries every continuous piecewise polynomial and, with b = 0, every real power."""

    c: sp.Expr
    n: sp.Expr
    b: sp.Expr = ZERO

    def shape(self, order: Order) -> sp.Expr:
        """f(r), zero where the order puts r below b; `ValueError` if it puts r nowhere."""
        return self.c * (r**self.n - (self.b**self.n if self.b != 0 else ZERO)) if order.below(self.b, r) else ZERO

    def depth(self, order: Order, k: sp.Expr = ZERO) -> Form:
        """g(a) for every k, from one moment of x**(n - 1); empty where a is below b."""
        if not order.below(self.b, a):
            return Form()
        return depth_moment(self.n - 1, self.b, k) * (self.c * self.n * a ** (1 - k))

    def primitives(self, order: Order, k: sp.Expr = ZERO) -> tuple[Primitive, ...]:
        """One antiderivative over b < x < a, the negative of the integral from x to a; none where a is below b."""
        if not order.below(self.b, a):
            return ()
        moment = depth_moment(self.n - 1, x, k).expr()
        # int_x^a has the derivative -integrand; the power of x at x = 0 is the complete Beta function
        integrand = depth_kernel(self.c * self.n * x ** (self.n - 1), k)
        return (Primitive(self.b, a, integrand, -self.c * self.n * a ** (1 - k) * moment),)

    def force(self, order: Order, k: sp.Expr = ZERO) -> Form:
        """F^ = n [a**(1+k) g + c b**n (a^2-b^2)**((1+k)/2)] / ((1+k)(1+k+n)): one contiguity step, no integral."""
        if not order.below(self.b, a):
            return Form()
        scale = 1 / ((1 + k) * (1 + k + self.n))
        form = self.depth(order, k) * (a ** (1 + k) * self.n * scale)
        if self.b != 0:
            form = form + Form.of((a**2 - self.b**2) ** ((1 + k) / 2), self.c * self.n * self.b**self.n * scale)
        return form

    def pressure(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """P^(r); None with a break where k != 0 or n is no integer."""
        if not order.below(self.b, a):
            return Form()
        if self.b == 0:
            growth = depth_moment(self.n - 1, ZERO, k)[ONE].subs(a, ONE) * self.c * self.n  # g = growth * a**n
            return pressure_moment(self.n - 1, k) * (growth * self.n)
        if k != 0 or not self.n.is_Integer:
            return None
        return self.rate_moment(0, order.below(r, self.b))

    def rate_moment(self, more: int, inside: bool) -> Form:
        """int_max(r, b)^a t**more g'(t)/sqrt(t^2 - r^2) dt for a whole power n and k = 0; inside means r < b."""
        # g'(t) = c n [n A_{n-1}(t; b) + b**n / sqrt(t^2 - b^2)]
        total = elliptic_moment(more, self.b, inside) * self.b**self.n
        for master, coefficient in depth_moment(self.n - 1, self.b).items():
            for (power,), factor in sp.Poly(sp.expand(coefficient * self.n), a).terms():
                if isinstance(master, sp.acos):
                    total = total + arccos_moment(power + more, self.b, inside) * factor
                else:  # sqrt(t^2 - b^2) t**power = t**power (t^2 - b^2)/sqrt(t^2 - b^2)
                    total = total + elliptic_moment(power + more + 2, self.b, inside) * factor
                    total = total + elliptic_moment(power + more, self.b, inside) * (-factor * self.b**2)
        return total * (self.c * self.n)

    def displacement(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """W^(r) for r > a; None with a break where k != 0 or n is no integer."""
        if not order.below(self.b, a):
            return Form()
        if k == 0 and self.n.is_Integer and not self.n.free_symbols:
            depth = Form({master * sp.asin(a / r): factor for master, factor in self.depth(order).items()})
            form = depth + outside_moment(int(self.n) + 1, self.b) * (-self.c)
            return form + outside_moment(1, self.b) * (self.c * self.b**self.n) if self.b != 0 else form
        if self.b != 0:
            return None
        n = self.n
        half = sp.S.Half
        growth = (
            self.c * n * gamma_normalised((1 + k) / 2) * gamma_normalised(n / 2) / gamma_normalised((1 + k + n) / 2)
        )
        tail = IncompleteBeta(a**2 / r**2, (n + k + 1) / 2, (1 - k) / 2)
        return outside_kernel(k) * (growth * half * a**n) + Form.of(tail, -growth * half * half * r**n)
