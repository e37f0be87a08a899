"""Results as Arb balls: an enclosure of the value for exact inputs, with a radius that is a theorem.

The functions are those of Arb; a master integral Arb does not know becomes an
`acb.integral` of its regular form.  Inside an integrand the arguments are
complex boxes and `analytic` asks for a proof that the function is holomorphic
on the box, hence inverse functions in terms of `sqrt` and `log`, which can
tell.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp
import sympy as sp
from flint import acb, arb, ctx, fmpq

from ..abel import masters
from .rules import ball
from .shape import Number, Values, concrete, numeric_symbols

HIGHEST = 1 << 12
"""Bits at which an enclosure that is still too wide is given up."""


EVALUATIONS = 20000
"""Evaluations after which an integral that still splits boxes is given up."""


class NotAvailableError(ValueError):
    """Arb has no function for a node of the expression."""


def exact(value: Any) -> acb:
    """A number of the point: rational numbers exactly, numbers of mpmath as the binary fractions they are."""
    if isinstance(value, mp.mpf):
        return acb(ball(value))
    value = sp.sympify(value)
    return acb(ball(value)) if value.is_Rational else Ball({}, False)(value)


def enclose(expr: sp.Expr, values: Values, digits: int) -> arb:
    """A real ball around the value of expr whose relative radius is below 10**-digits.

    Raises
    ------
    NotAvailableError
        If Arb lacks a function, or the radius does not shrink below HIGHEST bits.
    """
    plain = concrete(sp.sympify(expr), values)
    return shrinking(lambda: Ball(point(values), False)(plain), digits)


def enclose_value(expr: sp.Expr, values: Values, digits: int) -> Number:
    """The middle of the enclosure, as a number of mpmath."""
    enclosure = enclose(expr, values, digits)
    with mp.workdps(digits + 10):
        return mp.mpf(enclosure.mid().str(digits + 10, radius=False))


def point(values: Values) -> dict[sp.Symbol, acb]:
    """The symbols of a point with their values as balls."""
    return {s: exact(values[s]) for s in numeric_symbols(values)}


def shrinking(value_at: Callable[[], acb], digits: int) -> arb:
    """The value at a precision, doubled until its relative radius is below 10**-digits."""
    wanted = int(digits * 3.33) + 2
    bits = wanted + 64
    while bits <= HIGHEST:
        with ctx.workprec(bits):
            value = value_at()
        if value.is_finite() and value.real.rel_accuracy_bits() >= wanted and value.imag.contains(0):
            return value.real
        bits *= 2
    message = f"no enclosure to {digits} digits below {HIGHEST} bits; the point may be a zero or a branch point"
    raise NotAvailableError(message)


def integral(f: Callable[[acb, bool], acb], lower: acb, upper: acb) -> acb:
    """Enclosure of an integral of a function that is holomorphic around the open interval."""
    return acb.integral(f, lower, upper, eval_limit=EVALUATIONS)


class Ball:
    """Evaluates a tree over the balls of its symbols; equal subtrees once."""

    def __init__(self, symbols: dict[sp.Symbol, acb], analytic: bool) -> None:
        self.known: dict[sp.Expr, acb] = dict(symbols)
        self.symbols, self.analytic = symbols, analytic

    def __call__(self, expr: sp.Expr) -> acb:
        value = self.known.get(expr)
        if value is None:
            value = self.known[expr] = self._value(expr)
        return value

    def _value(self, expr: sp.Expr) -> acb:
        if expr.is_Rational:
            return acb(ball(expr))
        if expr is sp.pi:
            return acb.pi()
        if expr.is_Add:
            return sum((self(term) for term in expr.args[1:]), self(expr.args[0]))
        if expr.is_Mul:
            product = self(expr.args[0])
            for factor in expr.args[1:]:
                product *= self(factor)
            return product
        if expr.is_Pow:
            return self._power(expr.base, expr.exp)
        if isinstance(expr, sp.Integral):
            return self._integral(expr)
        rule = FUNCTIONS.get(type(expr))
        if rule is None:
            message = f"Arb has no function for {type(expr).__name__}; add a rule for it to balls.FUNCTIONS"
            raise NotAvailableError(message)
        return rule(self, *(self(arg) for arg in expr.args))

    def _power(self, base: sp.Expr, exponent: sp.Expr) -> acb:
        value = self(base)
        if exponent.is_Integer:
            return value ** int(exponent)
        if exponent.is_Rational and exponent.q == 2:
            return value.sqrt(analytic=self.analytic) ** int(exponent.p)
        return value.pow(self(exponent), analytic=self.analytic)

    def _integral(self, expr: sp.Integral) -> acb:
        (variable, lower, upper), integrand = expr.limits[0], expr.function

        def f(x: acb, analytic: bool) -> acb:
            return Ball({**self.symbols, variable: x}, bool(analytic))(integrand)

        return integral(f, self(lower), self(upper))

    def sqrt(self, z: acb) -> acb:
        """The square root; not finite on a box that meets its cut, if `analytic` is set."""
        return z.sqrt(analytic=self.analytic)

    def log(self, z: acb) -> acb:
        """The natural logarithm; not finite on a box that meets its cut, if `analytic` is set."""
        return z.log(analytic=self.analytic)

    def atanh(self, z: acb) -> acb:
        """The inverse hyperbolic tangent, by logarithms if `analytic` is set."""
        return (self.log(1 + z) - self.log(1 - z)) / 2 if self.analytic else z.atanh()

    def atan(self, z: acb) -> acb:
        """The inverse tangent, by logarithms if `analytic` is set."""
        return self.atanh(z * acb(0, 1)) * acb(0, -1) if self.analytic else z.atan()

    def asin(self, z: acb) -> acb:
        """The inverse sine, by a logarithm and a root if `analytic` is set."""
        if not self.analytic:
            return z.asin()
        return self.log(acb(0, 1) * z + self.sqrt((1 - z) * (1 + z))) * acb(0, -1)

    def struve(self, order: acb, z: acb, sign: int) -> acb:
        """The Struve function H for the sign -1, L for the sign 1, by its hypergeometric series."""
        series = (sign * z * z / 4).hypgeom([acb(1)], [acb(fmpq(3, 2)), order + fmpq(3, 2)])
        return (z / 2).pow(order + 1) * series / (acb(fmpq(3, 2)).gamma() * (order + fmpq(3, 2)).gamma())

    def real_only(self, value: acb) -> acb:
        """A function whose cuts are not watched may stand outside of integrands only."""
        if self.analytic:
            message = "a function without a test for its branch cuts stands inside an integrand"
            raise NotAvailableError(message)
        return value


def _c0(ball: Ball, b: acb, r: acb, a: acb) -> acb:
    """C0 with sqrt(t**2 - b**2) = c sinh(v) for r < b, c cosh(v) for b < r: no root is left, also for r next to b."""
    inside = r.real < b.real
    c = ((b - r) * (b + r) if inside else (r - b) * (r + b)).sqrt()
    reach = ((a - b) * (a + b)).sqrt() / c

    def f(v: acb, analytic: bool) -> acb:
        side = c * (v.sinh() if inside else v.cosh())
        within = Ball({}, bool(analytic))
        return within.atan(side / b) * side / within.sqrt(b * b + side * side)

    return integral(f, acb(0), reach.asinh() if inside else reach.acosh())


def _beta(ball: Ball, z: acb, p: acb, q: acb) -> acb:
    """B(z; p, q) = z**p/p 2F1(p, 1 - q; p + 1; z), which also holds for q <= 0."""
    return z.pow(p) / p * z.hypgeom_2f1(p, 1 - q, p + 1)


def _cap(ball: Ball, k: acb, b: acb, R: acb, a: acb) -> acb:
    """J(k; b, R, a) in v = a**2 - s**2 or v = R**2 - s**2, whichever is the shorter way to a branch point."""
    gap, half = (R - a) * (R + a), acb(fmpq(1, 2))
    if a.real < R.real:
        far, near = a, (k + 1) * half

        def primitive(v: acb) -> acb:
            return v.pow(near) / (k + 1) / gap.sqrt() * (-v / gap).hypgeom_2f1(half, near, near + 1)

    else:
        far = R

        def primitive(v: acb) -> acb:
            other = (-gap).pow((k - 1) * half) * (v / gap).hypgeom_2f1((1 - k) * half, half, 3 * half)
            return v.sqrt() * other

    if far is b:  # the ball of the same symbol
        return primitive(far * far)
    return primitive(far * far) - primitive((far - b) * (far + b))


FUNCTIONS: dict[Any, Callable[..., acb]] = {
    sp.sin: lambda ball, z: z.sin(),
    sp.cos: lambda ball, z: z.cos(),
    sp.tan: lambda ball, z: z.tan(),
    sp.exp: lambda ball, z: z.exp(),
    sp.sinh: lambda ball, z: z.sinh(),
    sp.cosh: lambda ball, z: z.cosh(),
    sp.log: Ball.log,
    sp.asin: Ball.asin,
    sp.acos: lambda ball, z: acb.pi() / 2 - ball.asin(z) if ball.analytic else z.acos(),
    sp.atan: Ball.atan,
    sp.asinh: lambda ball, z: ball.log(z + ball.sqrt(1 + z * z)) if ball.analytic else z.asinh(),
    sp.acosh: lambda ball, z: ball.log(z + ball.sqrt(z - 1) * ball.sqrt(z + 1)) if ball.analytic else z.acosh(),
    sp.atanh: Ball.atanh,
    sp.gamma: lambda ball, z: z.gamma(),
    sp.elliptic_f: lambda ball, phi, m: ball.real_only(acb.elliptic_f(phi, m)),
    sp.elliptic_e: lambda ball, *x: ball.real_only(acb.elliptic_e_inc(*x) if len(x) > 1 else acb.elliptic_e(*x)),
    sp.elliptic_k: lambda ball, m: ball.real_only(acb.elliptic_k(m)),
    masters.IncompleteBeta: lambda ball, z, p, q: ball.real_only(_beta(ball, z, p, q)),
    masters.LegendreChi2: lambda ball, x: ball.real_only((x.polylog(2) - (-x).polylog(2)) / 2),
    masters.ArctanIntegral: lambda ball, x: ball.real_only(acb((x * acb(0, 1)).polylog(2).imag)),
    masters.C0: lambda ball, b, r, a: ball.real_only(_c0(ball, b, r, a)),
    masters.Hypergeometric: lambda ball, p, q, c, z: ball.real_only(z.hypgeom_2f1(p, q, c)),
    masters.Kummer: lambda ball, p, c, z: ball.real_only(z.hypgeom([p], [c])),
    masters.CapMoment: lambda ball, k, b, R, a: ball.real_only(_cap(ball, k, b, R, a)),
    masters.Dawson: lambda ball, x: acb.pi().sqrt() / 2 * (-x * x).exp() * x.erfi(),
    masters.StruveH: lambda ball, order, z: ball.struve(order, z, -1),
    masters.StruveL: lambda ball, order, z: ball.struve(order, z, 1),
}
