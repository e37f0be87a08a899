"""Names for what comes more than once in a formula: roots of exact differences, angles through them, numbers."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp

from ..abel.masters import Dawson, StruveH
from ..notation import a, n
from .opaque import Arcosh, Arctan2, GammaRatio, Root, named
from .signs import Facts, squares
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

    def root(self, x: sp.Expr, y: sp.Expr) -> sp.Symbol:
        """The symbol of sqrt(x**2 - y**2), made where there is none yet; it is known to be below x."""
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
        for name, expr in self.definitions.items():
            if expr == definition:
                return name
        taken = [name for name in self.definitions if name.name.startswith("angle")]
        symbol = named(f"angle_{len(taken)}" if taken else "angle")
        self.definitions[symbol], self.tangent[symbol] = definition, y / x
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
