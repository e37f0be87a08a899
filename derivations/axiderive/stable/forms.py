"""Exact expression -> evaluation form, by rewriting with fixed rules.

Radicals sqrt(x**2 - y**2) become named roots of exact differences, angles
become atan2 of roots, and where terms cancel three rules are tried: conjugates
(X - Y = (X**2 - Y**2)/(X + Y)), the gap functions x - atan(x) and atanh(x) - x,
and ln(X/Y) = log1p((X - Y)/Y).  The form says whether that was enough.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp

from ..abel.masters import Dawson, StruveH
from ..notation import a, n
from .arcs import arc_integrals
from .opaque import Arcosh, Arctan2, ArctanGap, DepthOverHeight, Expm1, GammaRatio, Log1p, Root, TanhGap, named
from .powers import power_integrals
from .signs import Facts, cancels, difference, sign, squares


@dataclass(frozen=True)
class EvaluationForm:
    """Named intermediates in order of use, the value, and whether cancellation remains."""

    steps: tuple[tuple[sp.Symbol, sp.Expr], ...]
    value: sp.Expr
    cancels: bool

    def needs(self) -> set[sp.Symbol]:
        """The symbols that must be given."""
        named = {name for name, _ in self.steps}
        used = self.value.free_symbols.union(*(expr.free_symbols for _, expr in self.steps))
        return used - named


def evaluation_form(expr: sp.Expr, facts: Facts) -> EvaluationForm:
    """The form with roots and angles named and, if possible, without cancellation."""
    work = Rewriting(facts)
    value = work.named(work.with_named_ratio(gamma_ratios(arc_integrals(power_integrals(expr)))))
    if cancels(value, work.facts):
        value = work.rewritten(value)
    value = work.with_named_powers(work.with_named_arguments(value))
    steps = work.steps(value)
    loses = any(cancels(part, work.facts) for part in (value, *(expr for _, expr in steps)))
    return EvaluationForm(steps, value, loses)


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


@dataclass
class Rewriting:
    """The rules, the names given so far and what they stand for."""

    facts: Facts
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

    def root(self, x: sp.Expr, y: sp.Expr) -> sp.Symbol:
        for name, expr in self.definitions.items():
            if expr == Root(x, y):
                return name
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
        for name, square in self.square.items():
            if square == radicand:
                return name
        symbol = named(f"root_{len(self.square)}" if self.square else "root")
        self.definitions[symbol], self.square[symbol] = sp.sqrt(radicand), radicand
        return symbol

    def angle(self, y: sp.Expr, x: sp.Expr) -> sp.Symbol:
        for name, expr in self.definitions.items():
            if expr == Arctan2(y, x):
                return name
        taken = [name for name in self.definitions if name.name.startswith("angle")]
        symbol = named(f"angle_{len(taken)}" if taken else "angle")
        self.definitions[symbol], self.tangent[symbol] = Arctan2(y, x), y / x
        return symbol

    def hyperbolic_angle(self, y: sp.Expr, x: sp.Expr) -> sp.Symbol:
        """atanh(y/x) = asinh(y/sqrt(x**2 - y**2))."""
        definition = sp.asinh(y / self.root(x, y))
        for name, expr in self.definitions.items():
            if expr == definition:
                return name
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
            return Arcosh(top, bottom, self.root(top, bottom))
        return self.hyperbolic_angle(top, bottom)

    def rewritten(self, value: sp.Expr) -> sp.Expr:
        """The value with every sum that cancels rewritten, from the outside in."""
        if not cancels(value, self.facts):
            return value
        if value.is_Add:
            return self._sum(value)
        if isinstance(value, sp.log):
            return self._logarithm(value)
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
        arguments = {call.args[-1] for call in value.atoms(StruveH, Dawson) if not call.args[-1].is_Symbol}
        if len(arguments) != 1:
            return value
        (argument,), symbol = arguments, named("z")
        self.definitions[symbol] = argument
        return value.replace(lambda e: isinstance(e, (StruveH, Dawson)), lambda e: e.func(*e.args[:-1], symbol))

    def with_named_powers(self, value: sp.Expr) -> sp.Expr:
        """What is raised to a power of the exponent n that is split when printed, as `ratio`."""
        for power in sorted(value.atoms(sp.Pow), key=sp.default_sort_key):
            if power.exp.has(n) and power.exp != n and not power.base.is_Symbol and not power.base.is_number:
                symbol = named("ratio")
                self.definitions[symbol] = power.base
                value = value.subs(power, symbol**power.exp)
        return value

    def with_named_logarithms(self, value: sp.Expr) -> sp.Expr:
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
                value = kept * angle + lost * TanhGap(angle)
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
