"""The rules of rewriting.

Sums that cancel: conjugates, the gaps x - atan(x) and atanh(x) - x, and ln(X/Y) = log1p((X - Y)/Y); and quotients of
Gamma functions as one function.
"""

from __future__ import annotations

import sympy as sp

from ..abel.masters import IncompleteBeta, LegendreChi2
from ..notation import a, r
from .names import Names
from .opaque import (
    ArcStrips,
    ArctanGap,
    DepthOverHeight,
    Expm1,
    GammaRatio,
    Log1p,
    PowerDisplacement,
    PowerPressure,
    PowerPunches,
    TanhGap,
    named,
)
from .signs import cancels, difference, sign


class Rewriting(Names):
    """The rules for sums; those its variant leaves out change nothing."""

    def rewritten(self, value: sp.Expr) -> sp.Expr:
        """The value with every sum that cancels rewritten, from the outside in."""
        if not cancels(value, self.facts):
            return value
        if value.is_Add:
            return self._sum(value)
        if isinstance(value, sp.log):
            return self.with_named_logarithms(value)
        return value.func(*(self.rewritten(arg) for arg in value.args)) if value.args else value

    def _sum(self, value: sp.Expr) -> sp.Expr:
        value = self.with_named_logarithms(value)
        value = value.replace(sp.cos, lambda x: 1 - 2 * sp.sin(x / 2) ** 2) if value.has(sp.cos) else value
        value = value.replace(sp.exp, lambda x: 1 + Expm1(x)) if value.has(sp.exp) else value
        kept = self.fixed_differences(value)
        total = self._gaps(sp.expand(value.subs(kept)))
        total = self.conjugates(total)
        if not cancels(total, self.facts):
            total = sp.factor_terms(total)
        return total.subs({dummy: node for node, dummy in kept.items()})

    def fixed_differences(self, value: sp.Expr) -> dict[sp.Expr, sp.Symbol]:
        """Positive differences of parameters, to be kept in one piece."""
        return {
            node: sp.Dummy(positive=True)
            for node in value.atoms(sp.Add)
            if sign(node, self.facts) == 1 and difference(node) and not node.has(a)
        }

    def with_named_logarithms(self, value: sp.Expr) -> sp.Expr:
        """The value with ln(X/Y) for X > Y as a named log1p."""
        return value.replace(lambda e: isinstance(e, sp.log), self._logarithm)

    def _logarithm(self, value: sp.Expr) -> sp.Expr:
        top, bottom = sp.fraction(value.args[0])
        excess = self.conjugates(sp.expand(top - bottom))
        if sign(excess, self.facts) != 1:
            return value
        symbol = named("logarithm")
        self.ratio[symbol] = value.args[0]
        self.definitions[symbol] = Log1p(excess / bottom)
        return symbol

    def _gaps(self, value: sp.Expr) -> sp.Expr:
        """c (x - atan x) and c (atanh x - x) instead of their parts."""
        if not self.variant.gaps:
            return value
        for angle in [name for name in self.tangent if name in value.free_symbols]:
            slope = value.coeff(angle)
            lost = sp.Add(*(-term for term in sp.Add.make_args(slope) if sign(term, self.facts) == -1))
            if lost == 0:
                continue
            tangent = self.tangent[angle]
            rest = self._by_roots(sp.expand(value.coeff(angle, 0) - lost * tangent))
            if sign(rest, self.facts) == 1 or rest == 0:
                value = rest + (slope + lost) * angle + lost * ArctanGap(tangent)
        for angle in [name for name in self.hyperbolic if name in value.free_symbols]:
            rest = value.coeff(angle, 0)
            lost = sp.expand(-rest / self.hyperbolic[angle])
            kept = sp.expand(value.coeff(angle) - lost)
            if sign(rest, self.facts) == -1 and (kept == 0 or sign(kept, self.facts) == 1):
                value = kept * angle + lost * TanhGap(angle, sp.tanh(angle))
        return value

    def _by_roots(self, value: sp.Expr) -> sp.Expr:
        """Sums of squares written as squares of roots where that leaves one sign."""
        plain, rooted = value.as_independent(*self.square, as_Add=True)
        return plain + self._squared(sp.factor(rooted))

    def _squared(self, value: sp.Expr) -> sp.Expr:
        for root, square in self.square.items():
            value = value.subs(sp.factor(square), root**2).subs(square, root**2)
        return value

    def conjugates(self, value: sp.Expr) -> sp.Expr:
        """Pairs X - Y as (X**2 - Y**2)/(X + Y), where the numerator has one sign."""
        terms = list(sp.Add.make_args(value))
        for minus in [term for term in terms if sign(term, self.facts) == -1]:
            for plus in [term for term in terms if sign(term, self.facts) == 1]:
                pair = self._conjugate(plus, -minus)
                if pair is not None:
                    terms = [term for term in terms if term not in (plus, minus)] + [pair]
                    break
        return sp.Add(*terms)

    def _conjugate(self, x: sp.Expr, y: sp.Expr) -> sp.Expr | None:
        ratio = sp.cancel(x / y)
        top, bottom = sp.fraction(ratio)
        if not (top.free_symbols | bottom.free_symbols) & set(self.square):
            return None
        excess = sp.expand(top**2 - bottom**2)
        excess = sp.factor(sp.expand(excess.subs({root**2: square for root, square in self.square.items()})))
        if sign(excess, self.facts) != 1:
            return None
        if sign(top, self.facts) == -1:
            top, bottom = -top, -bottom
        below = self._squared(sp.factor(top)) + self._squared(sp.factor(bottom))
        return sp.factor(sp.cancel(y / bottom * excess)) / below


def gamma_ratios(expr: sp.Expr) -> sp.Expr:
    """gamma(x + 1/2)/gamma(x) as one function."""
    if not expr.args:
        return expr
    expr = expr.func(*(gamma_ratios(arg) for arg in expr.args))
    if isinstance(expr, sp.Sum) and expr.has(DepthOverHeight):
        number, term = expr.function.as_independent(*expr.function.free_symbols, as_Add=False)
        return number * sp.Sum(term, *expr.limits)
    if not expr.is_Mul:
        return expr
    powers = dict(factor.as_base_exp() for factor in expr.args)
    for lower, power in powers.items():
        upper = sp.gamma(sp.expand(lower.args[0] + sp.S.Half)) if isinstance(lower, sp.gamma) else None
        if powers.get(upper) == -power:
            return expr / lower**power * upper**power * _ratio(lower.args[0]) ** -power
    return expr


def _ratio(argument: sp.Expr) -> sp.Expr:
    """gamma(x + 1/2)/gamma(x); of half a whole number through the double factorials it stands for."""
    degree = 2 * argument - 1
    return DepthOverHeight(degree) / sp.sqrt(sp.pi) if degree.is_integer else GammaRatio(argument)


def arc_integrals(expr: sp.Expr) -> sp.Expr:
    """A pair chi(x) - chi(y), x and y = (a +- sqrt(a^2 - r^2))/(R + sqrt(R^2 - r^2)).

    It is int_r^a atanh(t/R)/sqrt(t^2 - r^2) dt: with chi'(x) = atanh(x)/x, x = r e^v/(R + sqrt(R^2 - r^2)) and
    t = r cosh v, both halves of the path add up to atanh(x(v)) + atanh(x(-v)) = atanh(t/R).
    """
    found = sorted(expr.atoms(LegendreChi2), key=sp.default_sort_key)
    if len(found) != 2:
        return expr
    tops, bottoms = zip(*(sp.fraction(call.args[0]) for call in found), strict=True)
    radius, half = (sum(tops) / 2, (tops[0] - tops[1]) / 2)
    lengths = [term for term in sp.Add.make_args(bottoms[0]) if term.is_Symbol]
    if bottoms[0] != bottoms[1] or not radius.is_Symbol or len(lengths) != 1:
        return expr
    (length,), square = lengths, sp.expand(tops[0] * tops[1])
    if sp.expand((bottoms[0] - length) ** 2 - length**2 + square) != 0:
        return expr
    larger, smaller = found if not half.could_extract_minus_sign() else found[::-1]
    strips = ArcStrips(sp.sqrt(square), radius, length)
    opened = sp.expand(expr.subs(larger, strips + smaller))
    if opened.has(LegendreChi2):
        return expr
    # atanh(sqrt(a^2 - r^2)/sqrt(R^2 - r^2)) keeps its digits through the root of the exact difference
    side = sp.sqrt(length**2 - radius**2)
    opened = opened.replace(sp.atanh, lambda x: sp.asinh(sp.numer(x) / side) if _leaves(x, side) else sp.atanh(x))
    return sp.factor_terms(opened)


def _leaves(quotient: sp.Expr, side: sp.Expr) -> bool:
    top, bottom = sp.fraction(quotient)
    return sp.expand(bottom**2 - top**2 - side**2) == 0


def power_integrals(expr: sp.Expr) -> sp.Expr:
    """Every IncompleteBeta through an integral over the radius of the growing contact.

    With t = r/sqrt(1 - u) resp. t = r sqrt(u) in the definition of B(z; p, q):

        r**(n-1) B(1 - r^2/a^2; 1/2, (1-n)/2) = 2 int_r^a t**(n-1)/sqrt(t^2 - r^2) dt
        r**n B(a^2/r^2; (n+1)/2, 1/2) = 2 int_0^a t**n/sqrt(r^2 - t^2) dt

    and the second one by parts where a**n asin(a/r) stands against it.
    """
    if isinstance(expr, sp.Sum):
        return sp.Sum(power_integrals(expr.function), *expr.limits)
    if expr.has(sp.Sum):
        return expr.func(*(power_integrals(arg) for arg in expr.args))
    for beta in sorted(expr.atoms(IncompleteBeta), key=sp.default_sort_key):
        z, p, q = beta.args
        if p == sp.S.Half:
            n = sp.expand(1 - 2 * q)
            return _collected(expr.subs(beta, 2 * (a / r) ** (n - 1) * PowerPressure(r, a, n)))
        n = sp.expand(2 * p - 1)
        opposed = expr.subs(beta, 2 * (a / r) ** n * (sp.asin(a / r) - PowerDisplacement(r, a, n)))
        opposed = _collected(opposed)
        return (
            opposed
            if not opposed.has(sp.asin)
            else _collected(expr.subs(beta, 2 * (a / r) ** n * PowerPunches(r, a, n)))
        )
    return expr


def _collected(expr: sp.Expr) -> sp.Expr:
    terms = [sp.powsimp(sp.expand_power_base(term)) for term in sp.Add.make_args(sp.expand(sp.expand_power_base(expr)))]
    return sp.factor_terms(sp.Add(*terms))
