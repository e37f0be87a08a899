"""The plane contact: load, and the fields of superposed flat strips, by moments of 1/sqrt(|t^2 - z^2|).

The load of an atom c (x^n - b^n) [x > b] is c n A_n(b) in units of E*, with
A_n = depth_moment(n).  By contiguity of A_n it grows with the half-width t as

    dA_n/dt = t [(n - 1) A_{n-2}(t) + b^(n-1) / sqrt(t^2 - b^2)],

which contains odd powers of t only, over sqrt(t^2 - b^2) or times acos(b/t).
Odd powers make every moment elementary (v = t^2 is rational in the root of a
quotient), in contrast to the even ones of the axisymmetric pressure.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ..entry import Primitive
from ..notation import L, a, r, x
from .atoms import PowerAtom
from .form import Form, Order
from .masters import IncompleteBeta
from .moments import ONE, ZERO, depth_moment, pressure_moment


class Kernel(ABC):
    """1/sqrt(|t^2 - z^2|) over the half-widths t that contribute at the point z."""

    z: sp.Expr
    sign: int
    """1 where the kernel is 1/sqrt(t^2 - z^2), -1 where it is 1/sqrt(z^2 - t^2)."""

    @abstractmethod
    def root(self) -> sp.Expr:
        """sqrt(|a^2 - z^2|), the inverse of the kernel at t = a."""

    @abstractmethod
    def ends(self, b: sp.Expr) -> tuple[Form, Form]:
        """Integrals of t/sqrt(t^2 - b^2) and of 1/(t sqrt(t^2 - b^2)) times the kernel."""

    @abstractmethod
    def power(self, s: sp.Expr) -> Form:
        """Integral of t**s times the kernel, without a break."""


@dataclass(frozen=True)
class Inside(Kernel):
    """1/sqrt(t^2 - x^2) for max(b, x) < t < a, at a point of the contact; `order` tells x from b."""

    order: Order
    z: sp.Expr = x
    sign: int = 1

    def root(self) -> sp.Expr:
        """sqrt(a^2 - x^2), real for a point of the contact."""
        return sp.sqrt(a**2 - x**2)

    def ends(self, b: sp.Expr) -> tuple[Form, Form]:
        """Moments of t and of 1/t over sqrt(t^2 - b^2), through y^2 = (t^2 - large^2)/(t^2 - small^2)."""
        small, large = (x, b) if self.order.below(x, b) else (b, x)
        y = sp.sqrt(a**2 - large**2) / sp.sqrt(a**2 - small**2)
        return Form.of(sp.atanh(y)), Form.of(sp.atanh(small * y / large), 1 / (b * x))

    def power(self, s: sp.Expr) -> Form:
        """int_x^a t**s / sqrt(t**2 - x**2) dt."""
        return Form({master.subs(r, x): coefficient.subs(r, x) for master, coefficient in pressure_moment(s).items()})


@dataclass(frozen=True)
class Outside(Kernel):
    """1/sqrt(z^2 - t^2) for b < t < a, at a point z > a of the free surface."""

    z: sp.Expr
    sign: int = -1

    def root(self) -> sp.Expr:
        """sqrt(z^2 - a^2), real for a point of the free surface."""
        return sp.sqrt(self.z**2 - a**2)

    def ends(self, b: sp.Expr) -> tuple[Form, Form]:
        """Moments of t and of 1/t over sqrt(t^2 - b^2): two arcs, of y^2 = (t^2 - b^2)/(z^2 - t^2)."""
        span = sp.sqrt(self.z**2 - b**2)
        first = sp.asin(sp.sqrt(a**2 - b**2) / span)
        return Form.of(first), Form.of(sp.acos(b * self.root() / (a * span)), 1 / (b * self.z))

    def power(self, s: sp.Expr) -> Form:
        """int_0^a t**s / sqrt(z**2 - t**2) dt."""
        if not (s.is_Integer and s >= 0):
            return Form.of(IncompleteBeta(a**2 / self.z**2, (s + 1) / 2, sp.S.Half), self.z**s / 2)
        even = s % 2 == 0
        form = Form.of(sp.asin(a / self.z)) if even else Form.of(ONE, self.z) + Form.of(self.root(), -ONE)
        for i in range(2 if even else 3, int(s) + 1, 2):  # i M_i = (i - 1) z^2 M_{i-2} - a^(i-1) sqrt(z^2 - a^2)
            form = form * (sp.Rational(i - 1, i) * self.z**2) + Form.of(self.root(), -(a ** (i - 1)) / sp.Integer(i))
        return form


@dataclass(frozen=True)
class OddTerms:
    """sum root_j t**j / sqrt(t**2 - b**2) + sum arc_j t**j acos(b/t) with odd j."""

    b: sp.Expr
    root: Mapping[int, sp.Expr]
    arc: Mapping[int, sp.Expr]

    @classmethod
    def of(cls, form: Form, b: sp.Expr, shift: int) -> OddTerms:
        """t**shift times a combination of sqrt(t**2 - b**2) and acos(b/t), written with a for t."""
        root: dict[int, sp.Expr] = {}
        arc: dict[int, sp.Expr] = {}
        for master, coefficient in form.items():
            for (power,), factor in sp.Poly(sp.expand(coefficient), a).terms():
                j = power + shift
                if isinstance(master, sp.acos):
                    arc[j] = arc.get(j, ZERO) + factor
                else:  # sqrt(t^2 - b^2) = (t^2 - b^2)/sqrt(t^2 - b^2)
                    root[j + 2] = root.get(j + 2, ZERO) + factor
                    root[j] = root.get(j, ZERO) - factor * b**2
        return cls(b, root, arc)

    def against(self, kernel: Kernel) -> Form:
        """The integral of these terms times the kernel."""
        highest = max((*self.root, *(j + 1 for j in self.arc)), default=1) + 1
        ladder = _ladder(highest, self.b, kernel)
        form = Form.total(ladder[j] * factor for j, factor in self.root.items())
        return form + Form.total(_arc_moment(j, self.b, kernel, ladder) * factor for j, factor in self.arc.items())


def _ladder(highest: int, b: sp.Expr, kernel: Kernel) -> dict[int, Form]:
    """Moments of t**j / sqrt(t**2 - b**2) for odd j from -1 up.

    2k I_k = (2k - 1)(b^2 + z^2) I_{k-1} - 2(k - 1) b^2 z^2 I_{k-2} + sign a^(2k-2) sqrt(a^2 - b^2) root with
    I_k the moment of order 2k + 1; the lower end never contributes.
    """
    z2, edge = kernel.z**2, sp.sqrt(a**2 - b**2) * kernel.root()
    first, inverse = kernel.ends(b)
    moments = {-1: inverse, 1: first}
    for k in range(1, (highest + 1) // 2):
        step = moments[2 * k - 1] * (sp.Rational(2 * k - 1, 2 * k) * (b**2 + z2))
        step = step + moments[2 * k - 3] * (-sp.Rational(k - 1, k) * b**2 * z2)
        moments[2 * k + 1] = step + Form.of(edge, kernel.sign * a ** (2 * k - 2) / sp.Integer(2 * k))
    return moments


def _arc_moment(j: int, b: sp.Expr, kernel: Kernel, ladder: Mapping[int, Form]) -> Form:
    """Moment of t**j acos(b/t), by parts with sign root(t) sum d_i t**i for the integral of t**j times the kernel."""
    parts = {0: ONE}
    for i in range(3, j + 1, 2):  # i D_i = (i - 1) z^2 D_{i-2} + t^(i-1)
        parts = {power: factor * sp.Rational(i - 1, i) * kernel.z**2 for power, factor in parts.items()}
        parts[i - 1] = sp.Rational(1, i)
    edge = sp.acos(b / a) * kernel.root()
    form = Form.of(edge, kernel.sign * sp.Add(*(factor * a**i for i, factor in parts.items())))
    for i, factor in parts.items():
        form = form + (ladder[i + 1] + ladder[i - 1] * -(kernel.z**2)) * (-b * factor)
    return form


def load(atom: PowerAtom, order: Order) -> Form:
    """int_b^a x f'(x) / sqrt(a**2 - x**2) dx: the line load in units of E*."""
    if not order.below(atom.b, a):
        return Form()
    return depth_moment(atom.n, atom.b) * (atom.c * atom.n)


def field(atom: PowerAtom, order: Order, kernel: Kernel) -> Form:
    """Integral of the growth of the load with the half-width times the kernel."""
    if not order.below(atom.b, a):
        return Form()
    n, b, scale = atom.n, atom.b, atom.c * atom.n
    if b == 0:
        return kernel.power(n - 1) * (scale * n * _self_similar(n))
    terms = OddTerms(b, {1: b ** (n - 1)}, {})
    form = terms.against(kernel)
    if n > 1:
        form = form + OddTerms.of(depth_moment(n - 2, b) * (n - 1), b, 1).against(kernel)
    return form * scale


def depth(atom: PowerAtom, order: Order) -> Form:
    """Integral of the growth of the load times acosh(L/t), by parts: P acosh(L/a) + L int P/(t sqrt(L^2 - t^2)) dt."""
    if not order.below(atom.b, a):
        return Form()
    n, b, scale = atom.n, atom.b, atom.c * atom.n
    kernel = Outside(L)
    if b == 0:
        tail = kernel.power(n - 1) * (scale * _self_similar(n))
    else:
        tail = OddTerms.of(depth_moment(n, b), b, -1).against(kernel) * scale
    return load(atom, order).times(sp.acosh(L / a)) + tail * L


def complementary(form: Form) -> Form:
    """Where a multiple of pi/2 stands beside an arc acos(z), the arc asin(z) instead: they cancel for z -> 0."""
    for arc in [master for master in form if any(isinstance(factor, sp.acos) for factor in sp.Mul.make_args(master))]:
        acos = next(factor for factor in sp.Mul.make_args(arc) if isinstance(factor, sp.acos))
        rest = arc / acos
        share = sp.factor(-2 * form.get(rest, ZERO) / sp.pi)
        if share != 0 and not share.has(sp.pi):
            form = form + Form({rest: sp.pi * share / 2, arc: -share, rest * sp.asin(acos.args[0]): -share})
    return form


def primitives(atom: PowerAtom, order: Order) -> tuple[Primitive, ...]:
    """Antiderivative in x of the integrand of the load."""
    if not order.below(atom.b, a):
        return ()
    scale = atom.c * atom.n
    integrand = scale * x**atom.n / sp.sqrt(a**2 - x**2)
    return (Primitive(atom.b, a, integrand, -scale * depth_moment(atom.n, x).expr()),)


def _self_similar(n: sp.Expr) -> sp.Expr:
    """A_n(0) / a**n."""
    return depth_moment(n)[ONE].subs(a, ONE)
