"""Atoms with one quadratic radical: sphere, spherical cap, hyperboloid."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..entry import Primitive
from ..notation import a, r, x
from .atoms import depth_kernel
from .form import Form, Order
from .masters import ArctanIntegral, CapMoment, Hypergeometric, IncompleteBeta, LegendreChi2
from .moments import ONE, ZERO, outside_moment


def _radical_depth(curvature: sp.Expr, z: sp.Expr, k: sp.Expr) -> Form:
    """Depth for f' = curvature r (1 - z r^2/a^2)**(-1/2) by Euler's integral, z = a^2/R^2 or -a^2/b^2."""
    half = sp.S.Half
    return Form.of(Hypergeometric(half, ONE, (3 + k) * half, z), curvature * a**2 / (1 + k))


def _radical_force(curvature: sp.Expr, z: sp.Expr, k: sp.Expr) -> Form:
    half = sp.S.Half
    scale = 2 * curvature * a ** (3 + k) / ((1 + k) ** 2 * (3 + k))
    return Form.of(Hypergeometric(half, sp.Integer(2), (5 + k) * half, z), scale)


def _graded_tail(z: sp.Expr, k: sp.Expr, q: sp.Expr) -> sp.Expr:
    return IncompleteBeta(z, (1 + k) / 2, q) / 2


@dataclass(frozen=True)
class SphereAtom:
    """c (R - sqrt(R**2 - r**2)) up to `cap`, constant beyond; zero stands for no cap, and a < R is understood then."""

    c: sp.Expr
    R: sp.Expr
    cap: sp.Expr = ZERO

    def _capped(self, order: Order) -> bool:
        return bool(self.cap != 0 and order.below(self.cap, a))

    def shape(self, order: Order) -> sp.Expr:
        """f(r); where the atom has a cap, the order must tell on which side of it r is."""
        top = self.cap if self.cap != 0 and order.below(self.cap, r) else r
        return self.c * (self.R - sp.sqrt(self.R**2 - top**2))

    def _angle(self, order: Order) -> sp.Expr:
        """S_0 = int_0^min(a, cap) s / (sqrt(R^2 - s^2) sqrt(a^2 - s^2)) ds."""
        if not self._capped(order):
            return sp.atanh(a / self.R)
        root_a, root_R = sp.sqrt(a**2 - self.cap**2), sp.sqrt(self.R**2 - self.cap**2)
        return sp.log((a + self.R) / (root_a + root_R))

    def depth(self, order: Order, k: sp.Expr = ZERO) -> Form:
        """g(a), elementary for k = 0; otherwise a 2F1, or a `CapMoment` where a is above the cap."""
        if k == 0:
            return Form.of(self._angle(order), self.c * a)
        if self._capped(order):
            return Form.of(CapMoment(k, self.cap, self.R, a), self.c * a ** (1 - k))
        return _radical_depth(self.c / self.R, a**2 / self.R**2, k)

    def primitives(self, order: Order, k: sp.Expr = ZERO) -> tuple[Primitive, ...]:
        """One antiderivative, over 0 < x < a or, where a is above the cap, over 0 < x < cap."""
        integrand = depth_kernel(self.c * x / sp.sqrt(self.R**2 - x**2), k)
        if k != 0:
            return (self._graded_primitive(order, k, integrand),)
        root_a, root_R = sp.sqrt(a**2 - x**2), sp.sqrt(self.R**2 - x**2)
        if self._capped(order):
            return (Primitive(ZERO, self.cap, integrand, -self.c * a * sp.log(root_a + root_R)),)
        return (Primitive(ZERO, a, integrand, -self.c * a * sp.atanh(root_a / root_R)),)

    def _graded_primitive(self, order: Order, k: sp.Expr, integrand: sp.Expr) -> Primitive:
        if self._capped(order):
            return Primitive(ZERO, self.cap, integrand, self.c * a ** (1 - k) * CapMoment(k, x, self.R, a))
        tail = _graded_tail((a**2 - x**2) / (self.R**2 - x**2), k, -k / 2)
        return Primitive(ZERO, a, integrand, -self.c * a ** (1 - k) * (self.R**2 - a**2) ** (k / 2) * tail)

    def force(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """c S_1/(1 + k) with (2 + k) S_1 = (a^2 + (1 + k) R^2) S_0 + [sqrt(R^2 - s^2) (a^2 - s^2)**((1 + k)/2)]."""
        if k != 0 and not self._capped(order):
            return _radical_force(self.c / self.R, a**2 / self.R**2, k)
        if k != 0:
            moment = Form.of(CapMoment(k, self.cap, self.R, a), a**2 + (1 + k) * self.R**2)
            rim = sp.sqrt(self.R**2 - self.cap**2) * (a**2 - self.cap**2) ** ((1 + k) / 2)
            ends = Form.of(rim) + Form.of(ONE, -self.R * a ** (1 + k))
            return (moment + ends) * (self.c / ((1 + k) * (2 + k)))
        end = -a * self.R
        if self._capped(order):
            end = sp.sqrt(a**2 - self.cap**2) * sp.sqrt(self.R**2 - self.cap**2) - a * self.R
        return Form.of(self._angle(order), self.c * (self.R**2 + a**2) / 2) + Form.of(ONE, self.c * end / 2)

    def pressure(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """int (atanh(t/R) + t R/(R^2 - t^2)) / sqrt(t^2 - r^2) dt by Landen's substitution t + sqrt(t^2 - r^2)."""
        if k != 0 or self._capped(order):
            return None
        root_a, root_R = sp.sqrt(a**2 - r**2), sp.sqrt(self.R**2 - r**2)
        form = Form.of(LegendreChi2((a + root_a) / (self.R + root_R)), self.c)
        form = form + Form.of(LegendreChi2((a - root_a) / (self.R + root_R)), -self.c)
        return form + Form.of(sp.atanh(root_a / root_R) / root_R, self.c * self.R)

    def displacement(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """Lemma for W^ with f split as (R^2 - s^2)/sqrt(R^2 - s^2): two angles and one arc."""
        if k != 0:
            return None
        q, capped = sp.sqrt(r**2 - a**2), self._capped(order)
        form = Form.of(self._angle(order) * sp.asin(a / r), self.c * a) + outside_moment(1) * (-self.c * self.R)
        form = form + Form.of(self._angle(order) * q, self.c)
        if capped:
            form = form + outside_moment(1, self.cap) * (self.c * sp.sqrt(self.R**2 - self.cap**2))
        # (R^2 - r^2) int s ds / ((r^2 - s^2) sqrt(R^2 - s^2) sqrt(a^2 - s^2)) in y = sqrt((a^2 - s^2)/(R^2 - s^2))
        start = a / self.R
        stop = sp.sqrt(a**2 - self.cap**2) / sp.sqrt(self.R**2 - self.cap**2) if capped else ZERO
        if order.below(r, self.R):
            rho = sp.sqrt(self.R**2 - r**2)
            arc = sp.atan(rho * start / q) - (sp.atan(rho * stop / q) if capped else ZERO)
            return form + Form.of(rho, self.c * arc)
        rho = sp.sqrt(r**2 - self.R**2)
        if order.below(a, self.R):
            arc = sp.atanh(rho * start / q) - (sp.atanh(rho * stop / q) if capped else ZERO)
        else:  # acoth = atanh of the inverse
            arc = sp.atanh(q / (rho * start)) - (sp.atanh(q / (rho * stop)) if capped else ZERO)
        return form + Form.of(rho, -self.c * arc)


@dataclass(frozen=True)
class HyperboloidAtom:
    """c (sqrt(r**2 + b**2) - b)."""

    c: sp.Expr
    b: sp.Expr

    def shape(self, order: Order) -> sp.Expr:
        """f(r), one formula for every r."""
        return self.c * (sp.sqrt(r**2 + self.b**2) - self.b)

    def depth(self, order: Order, k: sp.Expr = ZERO) -> Form:
        """g(a), an arctangent for k = 0, otherwise a 2F1."""
        if k != 0:
            return _radical_depth(self.c / self.b, -(a**2) / self.b**2, k)
        return Form.of(sp.atan(a / self.b), self.c * a)

    def primitives(self, order: Order, k: sp.Expr = ZERO) -> tuple[Primitive, ...]:
        """One antiderivative over 0 < x < a, an arctangent for k = 0, otherwise an incomplete Beta function."""
        root_a, root_b = sp.sqrt(a**2 - x**2), sp.sqrt(self.b**2 + x**2)
        integrand = depth_kernel(self.c * x / root_b, k)
        if k == 0:
            return (Primitive(ZERO, a, integrand, -self.c * a * sp.atan(root_a / root_b)),)
        tail = _graded_tail((a**2 - x**2) / (a**2 + self.b**2), k, sp.S.Half)
        return (Primitive(ZERO, a, integrand, -self.c * a ** (1 - k) * (a**2 + self.b**2) ** (k / 2) * tail),)

    def force(self, order: Order, k: sp.Expr = ZERO) -> Form:
        """F^(a), an arctangent for k = 0, otherwise a 2F1."""
        if k != 0:
            return _radical_force(self.c / self.b, -(a**2) / self.b**2, k)
        return Form.of(sp.atan(a / self.b), self.c * (a**2 - self.b**2) / 2) + Form.of(ONE, self.c * a * self.b / 2)

    def pressure(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """P^(r) for k = 0, by two inverse tangent integrals; None for any other k."""
        if k != 0:
            return None
        root_a, root_b = sp.sqrt(a**2 - r**2), sp.sqrt(self.b**2 + r**2)
        form = Form.of(ArctanIntegral((a + root_a) / (self.b + root_b)), self.c)
        form = form + Form.of(ArctanIntegral((a - root_a) / (self.b + root_b)), -self.c)
        return form + Form.of(sp.atan(root_a / root_b) / root_b, self.c * self.b)

    def displacement(self, order: Order, k: sp.Expr = ZERO) -> Form | None:
        """W^(r) for r > a and k = 0, by arcs; None for any other k."""
        if k != 0:
            return None
        q, root_b = sp.sqrt(r**2 - a**2), sp.sqrt(self.b**2 + r**2)
        angle = sp.atan(a / self.b)
        form = Form.of(angle * sp.asin(a / r), self.c * a) + Form.of(angle * q, self.c)
        form = form + outside_moment(1) * (self.c * self.b)
        return form + Form.of(sp.atan(a * root_b / (self.b * q)), -self.c * root_b)
