"""The rules of rewriting.

Names for what comes more than once in a formula: roots of exact differences, angles through them, numbers.  Sums that
cancel: conjugates, the gaps x - atan(x) and atanh(x) - x, and ln(X/Y) = log1p((X - Y)/Y); and quotients of Gamma
functions as one function.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp

from ..abel.masters import Dawson, IncompleteBeta, LegendreChi2, StruveH
from ..notation import a, n, r
from .opaque import (
    Arcosh,
    ArcStrips,
    Arctan2,
    ArctanGap,
    DepthOverHeight,
    Expm1,
    GammaRatio,
    Log1p,
    PowerDisplacement,
    PowerPressure,
    PowerPunches,
    Root,
    TanhGap,
    named,
)
from .signs import Facts, cancels, difference, sign, squares
from .variants import FULL, Variant


@dataclass
class Names:
    """The names given so far and what they stand for."""

    facts: Facts
    variant: Variant = FULL
    definitions: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    square: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    tangent: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Symbols of angles atan(X), with X."""
    ratio: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Symbols of logarithms ln(X), with X."""
    hyperbolic: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Symbols of angles atanh(X), with X."""

    def steps(self, value: sp.Expr) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
        """The definitions the value needs, those of a definition before it."""
        needed, seen = [], set()

        def visit(expr: sp.Expr) -> None:
            for name in self.definitions:
                if name in expr.free_symbols and name not in seen:
                    seen.add(name)
                    visit(self.definitions[name])
                    needed.append((name, self.definitions[name]))

        visit(value)
        return tuple(needed)

    def _known(self, definition: sp.Expr) -> sp.Symbol | None:
        return next((name for name, expr in self.definitions.items() if expr == definition), None)

    def root(self, x: sp.Expr, y: sp.Expr) -> sp.Symbol:
        """The symbol of sqrt(x**2 - y**2), made where there is none yet; it is known to be below x."""
        if known := self._known(Root(x, y)):
            return known
        symbol = named(self._root_name(x, y))
        self.definitions[symbol], self.square[symbol] = Root(x, y), x**2 - y**2
        self.facts = self.facts | {(symbol, x)}
        return symbol

    def _root_name(self, x: sp.Expr, y: sp.Expr) -> str:
        """`root` for the first root of the contact radius, else with the letters of its lengths."""
        names = [name.name for name in self.square]
        if (x.has(a) or y.has(a)) and "root" not in names:
            return "root"
        return f"root_{x}{y}" if x.is_Symbol and y.is_Symbol else f"root_{len(names)}"

    def plain_root(self, radicand: sp.Expr) -> sp.Symbol:
        """The symbol of the root of this radicand, made where there is none yet."""
        for name, square in self.square.items():
            if square == radicand:
                return name
        symbol = named(f"root_{len(self.square)}" if self.square else "root")
        self.definitions[symbol], self.square[symbol] = sp.sqrt(radicand), radicand
        return symbol

    def angle(self, y: sp.Expr, x: sp.Expr) -> sp.Symbol:
        """The symbol of atan(y/x), made where there is none yet."""
        definition = sp.atan(y / x) if self.variant.quotients else Arctan2(y, x)
        if known := self._known(definition):
            return known
        taken = [name for name in self.definitions if name.name.startswith("angle")]
        symbol = named(f"angle_{len(taken)}" if taken else "angle")
        self.definitions[symbol], self.tangent[symbol] = definition, y / x
        return symbol

    def hyperbolic_angle(self, y: sp.Expr, x: sp.Expr) -> sp.Symbol:
        """atanh(y/x) = asinh(y/sqrt(x**2 - y**2))."""
        definition = sp.asinh(y / self.root(x, y))
        if known := self._known(definition):
            return known
        symbol = named("angle" if not self.hyperbolic else f"angle_{len(self.hyperbolic)}")
        self.definitions[symbol], self.hyperbolic[symbol] = definition, y / x
        return symbol

    def named(self, expr: sp.Expr) -> sp.Expr:
        """Replace radicals and inverse functions, innermost first."""
        if not expr.args:
            return expr
        args = self._joined_roots(list(expr.args)) if expr.is_Mul else list(expr.args)
        args = [self.named(arg) for arg in args]
        if expr.is_Pow and expr.exp.is_Rational and expr.exp.q == 2 and args[0].is_Add:
            pair = squares(args[0])
            if pair:
                return self.root(*pair) ** (2 * expr.exp)
            return self.plain_root(args[0]) ** (2 * expr.exp)
        if len(args) == 1 and isinstance(expr, (sp.acos, sp.asin, sp.acosh, sp.atanh, sp.atan)):
            return self._inverse_function(expr.func, args[0])
        return expr.func(*args)

    def _joined_roots(self, args: list[sp.Expr]) -> list[sp.Expr]:
        """sqrt(x - y) sqrt(x + y) as one root."""
        for first in args:
            for second in args:
                if not (first.is_Pow and second.is_Pow and first.exp == second.exp and abs(first.exp) == sp.S.Half):
                    continue
                pair = squares(sp.expand(first.base * second.base)) if first != second else None
                if pair:
                    rest = [arg for arg in args if arg not in (first, second)]
                    return [*rest, self.root(*pair) ** (2 * first.exp)]
        return args

    def _inverse_function(self, function: type[sp.Function], argument: sp.Expr) -> sp.Expr:
        top, bottom = sp.fraction(argument)
        if function is sp.acos:
            return self.angle(self.root(bottom, top), top)
        if function is sp.asin:
            return self.angle(top, self.root(bottom, top))
        if function is sp.atan:
            return self.angle(top, bottom)
        if function is sp.acosh:
            return self._inverse_cosine(top, bottom)
        return self.hyperbolic_angle(top, bottom)

    def _inverse_cosine(self, x: sp.Expr, y: sp.Expr) -> sp.Expr:
        """acosh(x/y)."""
        if self.variant.quotients:
            return sp.asinh(self.root(x, y) / y)
        return Arcosh(x, y, self.root(x, y))

    def with_named_ratio(self, value: sp.Expr) -> sp.Expr:
        """The Gamma ratio of the exponent as kappa, outside of sums."""
        found = value.atoms(GammaRatio) if not value.has(sp.Sum) else set()
        if len(found) != 1:
            return value
        symbol = named("kappa")
        self.definitions[symbol] = found.pop()
        return value.subs(self.definitions[symbol], symbol)

    def with_named_arguments(self, value: sp.Expr) -> sp.Expr:
        """The argument of Struve's and Dawson's functions as z."""
        calls = {call: sp.Dummy(positive=True) for call in value.atoms(StruveH, Dawson)}
        arguments = {call.args[-1] for call in calls if not call.args[-1].is_Symbol}
        if len(arguments) != 1:
            return value
        (argument,), symbol = arguments, named("z")
        self.definitions[symbol] = argument
        shape = _shape(value.xreplace(calls), a / argument, symbol, set(calls.values()))
        return shape.xreplace({dummy: call.func(*call.args[:-1], symbol) for call, dummy in calls.items()})

    def with_named_powers(self, value: sp.Expr) -> sp.Expr:
        """What is raised to a power of the exponent n that is split when printed, as `ratio`."""
        for power in sorted(value.atoms(sp.Pow), key=sp.default_sort_key):
            if power.exp.has(n) and power.exp != n and not power.base.is_Symbol and not power.base.is_number:
                symbol = named("ratio")
                self.definitions[symbol] = power.base
                value = value.subs(power, symbol**power.exp)
        return value


def _shape(value: sp.Expr, length: sp.Expr, z: sp.Symbol, calls: set[sp.Symbol]) -> sp.Expr:
    """The value in z = a/length if it and its calls depend on no other ratio; powers of lengths would be rounded."""
    scaled = sp.factor_terms(sp.expand(value.subs(a, z * length)))
    factor, shape = scaled.as_independent(z, *calls, as_Add=False)
    return factor * sp.horner(shape, wrt=z) if shape.free_symbols <= {z, *calls} else value


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
