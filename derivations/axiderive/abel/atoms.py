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

from abc import ABC, abstractmethod
from dataclasses import dataclass

import sympy as sp

from ..entry import Primitive
from ..notation import a, r, x
from .form import Form, Order
from .masters import (
    ArctanIntegral,
    CapMoment,
    Dawson,
    Hypergeometric,
    IncompleteBeta,
    Kummer,
    LegendreChi2,
    StruveH,
    StruveL,
    gamma_normalised,
)
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


class Atom(ABC):
    """Shape that is zero up to its break, with the four Abel integrals on a chain of lengths."""

    @abstractmethod
    def shape(self, order: Order) -> sp.Expr:
        """f(r) on this order of the lengths, zero up to the break."""

    @abstractmethod
    def depth(self, order: Order, k: sp.Expr) -> Form | None:
        """g(a), or None where no closed form is known; empty where the contact does not reach the break."""

    @abstractmethod
    def force(self, order: Order, k: sp.Expr) -> Form | None:
        """F^(a), or None where no closed form is known."""

    def primitives(self, order: Order, k: sp.Expr) -> tuple[Primitive, ...]:
        """Antiderivatives in x of the integrand of the depth; empty where none is known or needed."""
        return ()

    def pressure(self, order: Order, k: sp.Expr) -> Form | None:
        """P^(r) for r < a, or None where no closed form is known."""
        return None

    def displacement(self, order: Order, k: sp.Expr) -> Form | None:
        """W^(r) for r > a, or None where no closed form is known."""
        return None


def depth_kernel(slope: sp.Expr, k: sp.Expr) -> sp.Expr:
    """Integrand of (11.61) in x for the slope f'(x)."""
    return a ** (1 - k) * slope * (a**2 - x**2) ** ((k - 1) / 2)


@dataclass(frozen=True)
class PowerAtom(Atom):
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


# one quadratic radical: sphere, spherical cap, hyperboloid


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
class SphereAtom(Atom):
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
class HyperboloidAtom(Atom):
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


# one scale and a special function in the depth: cosine, Gaussian, exponential; pressure and displacement stay integrals


@dataclass(frozen=True)
class CosineAtom(Atom):
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
class GaussianAtom(Atom):
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
class ExponentialAtom(Atom):
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
