"""Whitelist reader of expressions in r: a walk over Python's own syntax tree that builds the SymPy tree node by node.

Nothing is evaluated but sums, products and powers of checked size; decimals stay exact; `Max(0, r - b)` becomes
(r - b) times the step symbol of b, and a `Piecewise` the sum of what begins at each break times its step.
"""

from __future__ import annotations

import ast
import itertools
import math
import re
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from operator import add, mul, sub
from typing import Any, NoReturn

import sympy as sp

from ..notation import r, theta
from .names import FUNCTIONS, ExpressionError, kinked, misplaced, refusal, syntax, unit, unknown, without_r

FORM = "write breaks as Max(0, r - b) with a parameter b"
PIECES = "write Piecewise((f1, r < b), (f2, True)) with a parameter b"


def step(b: sp.Symbol) -> sp.Symbol:
    """0 for r < b, 1 for r > b."""
    return sp.Symbol(f"[r > {b.name}]", nonnegative=True)


def begins_at(height: sp.Expr, parameters: Sequence[sp.Symbol]) -> sp.Symbol | None:
    """The parameter b at which an expression in r changes from below to above 0."""
    slope = sp.diff(height, r).subs(sp.tan(theta), sp.Dummy(positive=True))
    if any(symbol not in (r, *parameters) for symbol in height.free_symbols) or not slope.is_positive:
        return None
    return next((b for b in parameters if height.has(b) and sp.expand(height.subs(r, b)) == 0), None)


LARGEST_EXPONENT, LARGEST_ROOT = 24, 12
MOST_DIGITS, MOST_TERMS = 60, 400


def excess(expr: sp.Expr) -> str:
    """What of an expression is too large, with the next step; an empty text if nothing is."""
    if expr.has(sp.nan, sp.zoo, sp.oo, -sp.oo, sp.I):
        return "is no real number; change it"
    if any(max(abs(number.p), number.q) > 10**MOST_DIGITS for number in expr.atoms(sp.Rational)):
        return f"holds a number of more than {MOST_DIGITS} digits; scale it into a parameter"
    for power in (p for p in expr.atoms(sp.Pow) if p.exp.is_Rational and not p.is_number):
        if abs(power.exp) > LARGEST_EXPONENT or power.exp.q > LARGEST_ROOT**2:
            allowed = f"use exponents up to {LARGEST_EXPONENT} in {LARGEST_ROOT}ths"
            return f"holds {sp.sstr(power)[:40]}, whose exponent is too large or too fine; {allowed}"
    if expr.is_number and not finite(expr):
        return "is out of the range of numbers; scale it"
    if terms(expr) > MOST_TERMS:
        return f"has more than {MOST_TERMS} terms when multiplied out; lower its power"
    return ""


def finite(number: sp.Expr) -> bool:
    """Whether a number is in the range of doubles."""
    value = number.evalf(15)
    try:
        size = abs(complex(value))
    except OverflowError:
        return False
    return math.isfinite(size) and (size > 0.0 or value == 0)


def terms(expr: sp.Expr) -> int:
    """How many terms `expand` makes of it."""
    if expr.is_Add:
        return sum(terms(arg) for arg in expr.args)
    if expr.is_Mul:
        return math.prod(terms(arg) for arg in expr.args)
    if expr.is_Pow and expr.exp.is_Integer:
        count, power = terms(expr.base), abs(int(expr.exp))
        return math.comb(count + power - 1, power) if count > 1 else 1
    return max([1, *(terms(arg) for arg in expr.args)])


LONGEST, DEEPEST, MOST_NODES = 400, 30, 150
DIGITS = 15
"""Digits of a number, and decimals of its exponent of ten."""
MOST_PARAMETERS, MOST_BREAKS = 8, 4
NUMBER = re.compile(r"(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
JOINED: dict[type[ast.operator], Callable[[Any, Any], Any]] = {ast.Add: add, ast.Sub: sub, ast.Mult: mul}
CALLS = {name: getattr(sp, name) for name in FUNCTIONS if name not in ("Max", "Piecewise")}


@dataclass(frozen=True)
class Expression:
    """f(r) as it was written: the tree, its parameters in order of appearance, and its breaks with their steps."""

    text: str
    tree: sp.Expr
    parameters: tuple[sp.Symbol, ...]
    breaks: tuple[sp.Symbol, ...]

    def between(self, passed: int) -> sp.Expr:
        """f(r) beyond the first `passed` breaks."""
        on = {step(b): sp.S.One if i < passed else sp.S.Zero for i, b in enumerate(self.breaks)}
        return self.tree.xreplace(on)


def read(text: str) -> Expression:
    """The expression of a text.

    Raises
    ------
    ExpressionError
        With the value, the rule, the next step and the position.
    """
    return _Reader(text).read()


class _Reader:
    def __init__(self, text: str) -> None:
        self.text = text
        self.parameters: dict[str, sp.Symbol] = {}
        self.breaks: dict[str, sp.Symbol] = {}
        self.nodes = 0

    def read(self) -> Expression:
        """The expression of the text; ExpressionError where it is none, or does not depend on r, or holds abs."""
        node = self._parsed()
        names = [inner.id for inner in ast.walk(node) if isinstance(inner, ast.Name)]
        if "r" not in names:
            raise ExpressionError(without_r(self.text.strip(), names), self.text, 0, len(self.text))
        tree = self._walk(node, 0)
        if not tree.has(r):
            message = "f does not depend on r; write the height of the indenter over its tip, as r**2/(2*R)"
            raise ExpressionError(message, self.text, 0, len(self.text))
        bent = next(iter(sorted(tree.atoms(sp.Abs), key=str)), None)
        if bent is not None:
            message = kinked(str(bent).replace("Abs", "abs"))
            raise ExpressionError(message, self.text, 0, len(self.text))
        return Expression(self.text.strip(), tree, tuple(self.parameters.values()), tuple(self.breaks.values()))

    def _parsed(self) -> ast.expr:
        if not self.text.strip():
            message = "the expression is empty; write f(r), as r**2/(2*R)"
            raise ExpressionError(message)
        if len(self.text) > LONGEST:
            message = f"the expression has {len(self.text)} characters, at most {LONGEST} are read; name its parts"
            raise ExpressionError(message)
        odd = next((i for i, c in enumerate(self.text) if not (c.isascii() and c.isprintable())), None)
        if odd is not None:
            message = f"character {self.text[odd]!a} is not read; use plain ASCII, ** for powers and * for products"
            raise ExpressionError(message, self.text, odd)
        if "^" in self.text:
            message = "^ is no power here; write r**2"
            raise ExpressionError(message, self.text, self.text.index("^"))
        stripped = len(self.text) - len(self.text.lstrip())
        self.text = self.text.strip()
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # "3(r)" and "1if" make the compiler remark, the walk below refuses
                return ast.parse(self.text, mode="eval").body
        except SyntaxError as error:
            place = min(max(0, (error.offset or 1) - 1), len(self.text) - 1)
            message = syntax(self.text, error.msg)
            raise ExpressionError(message, " " * stripped + self.text, stripped + place) from None
        except (RecursionError, MemoryError, ValueError):
            message = f"the expression is nested deeper than {DEEPEST} levels; name its parts"
            raise ExpressionError(message) from None

    def _refuse(self, message: str, node: ast.AST) -> NoReturn:
        start = getattr(node, "col_offset", 0)
        raise ExpressionError(message, self.text, start, getattr(node, "end_col_offset", start + 1) - start)

    def _walk(self, node: ast.expr, depth: int) -> sp.Expr:
        self.nodes += 1
        if depth > DEEPEST:
            message = f"the expression is nested deeper than {DEEPEST} levels; name its parts"
            self._refuse(message, node)
        if self.nodes > MOST_NODES:
            message = f"the expression has more than {MOST_NODES} parts; name its parts"
            self._refuse(message, node)
        return self._bounded(self._node(node, depth + 1), node)

    def _node(self, node: ast.expr, depth: int) -> sp.Expr:
        match node:
            case ast.Constant():
                return self._number(node)
            case ast.Name():
                return self._name(node)
            case ast.UnaryOp(op=ast.USub() | ast.UAdd() as sign, operand=inner):
                value = self._walk(inner, depth)
                return -value if isinstance(sign, ast.USub) else value
            case ast.BinOp(left=left, op=ast.Add() | ast.Sub() | ast.Mult() as sign, right=right):
                return JOINED[type(sign)](self._walk(left, depth), self._walk(right, depth))
            case ast.BinOp(left=left, op=ast.Div(), right=right):
                return self._quotient(self._walk(left, depth), self._walk(right, depth), right)
            case ast.BinOp(left=left, op=ast.Pow(), right=right):
                return self._power(self._walk(left, depth), self._walk(right, depth), right)
            case ast.Call(func=ast.Name(id="Max"), args=arguments, keywords=[]):
                return self._step(arguments, node, depth)
            case ast.Call(func=ast.Name(id="Piecewise"), args=arguments, keywords=[]):
                return self._pieces(arguments, node, depth)
            case ast.Call(func=ast.Name(id=name), args=[inner], keywords=[]) if name in CALLS:
                return CALLS[name](
                    self._angle(self._walk(inner, depth), node) if name == "tan" else self._walk(inner, depth)
                )
            case ast.Call(func=ast.Name(id="Max" | "Piecewise")):
                self._refuse(f"keywords have no place here; {FORM}", node)
            case ast.Call(func=ast.Name(id=name)) if name in CALLS:
                self._refuse(f"{name} takes one argument; write {name}(...)", node)
            case ast.Call(func=ast.Name(id=name)):
                self._refuse(unknown(name), node.func)
        return self._refuse(misplaced(node, self._segment(node)), node)

    def _angle(self, value: sp.Expr, node: ast.Call) -> sp.Expr:
        if value.is_number and value > sp.pi / 2:
            what = f"{self._segment(node)}: angles are in radians, and an inclination is below pi/2"
            self._refuse(f"{what}; write tan({value}*pi/180) for degrees, or tan(theta) with a theta in a scene", node)
        return value

    def _segment(self, node: ast.expr) -> str:
        return (ast.get_source_segment(self.text, node) or "")[:40]

    def _number(self, node: ast.Constant) -> sp.Expr:
        text = (ast.get_source_segment(self.text, node) or "").replace("_", "")
        match = NUMBER.fullmatch(text)
        if match is None:
            self._refuse(f"{text[:40]!r} is no number of an expression; write 3, 0.25 or 1e-3", node)
        exponent = int(match[2][1:]) if match[2] and len(match[2]) < 6 else 0 if not match[2] else 99
        if len(match[1].replace(".", "").lstrip("0")) > DIGITS or abs(exponent) > DIGITS:
            message = f"{text[:40]!r} has more than {DIGITS} digits or decimals; scale it into a parameter"
            self._refuse(message, node)
        fraction = Fraction(text)
        return sp.Rational(fraction.numerator, fraction.denominator)

    def _name(self, node: ast.Name) -> sp.Expr:
        name = node.id
        if name == "r":
            return r
        if name == "pi":
            return sp.pi
        if name in self.parameters:
            return self.parameters[name]
        reason = unit(name) or refusal(name)
        if reason:
            self._refuse(reason, node)
        if len(self.parameters) == MOST_PARAMETERS:
            self._refuse(f"{name} is one parameter more than {MOST_PARAMETERS}; put numbers for some", node)
        symbol = sp.Symbol(name, positive=True)
        self.parameters[name] = symbol
        return symbol

    def _quotient(self, top: sp.Expr, bottom: sp.Expr, node: ast.expr) -> sp.Expr:
        if bottom == 0:
            self._refuse("the denominator is 0; divide by something else", node)
        return top / bottom

    def _power(self, base: sp.Expr, exponent: sp.Expr, node: ast.expr) -> sp.Expr:
        if exponent.has(r) or exponent.atoms(sp.Symbol) & set(map(step, self.breaks.values())):
            self._refuse("an exponent must not depend on r; write exp(...) for an exponential", node)
        if exponent.is_Rational:
            if abs(exponent) > LARGEST_EXPONENT or exponent.q > LARGEST_ROOT:
                message = (
                    f"exponent {exponent} is outside -{LARGEST_EXPONENT} ... {LARGEST_EXPONENT} in {LARGEST_ROOT}ths"
                )
                self._refuse(message + "; use a parameter as r**n for others", node)
        elif exponent.is_number:
            self._refuse(f"exponent {exponent} is no fraction; write it as one, or as a parameter", node)
        if base == 0:
            self._refuse("a power of 0 says nothing; leave the term out", node)
        if base.is_number and not base.is_positive and not exponent.is_Integer:
            self._refuse(f"the base {base} of a broken power is not above 0; change its sign", node)
        return base**exponent

    def _step(self, arguments: list[ast.expr], node: ast.Call, depth: int) -> sp.Expr:
        if len(arguments) != 2:
            self._refuse(f"Max takes two arguments; {FORM}", node)
        values = [self._walk(argument, depth) for argument in arguments]
        rest = [value for value in values if value != 0]
        if len(rest) != 1:
            self._refuse(f"one argument of Max must be 0; {FORM}", node)
        b = begins_at(rest[0], list(self.parameters.values()))
        if b is None:
            text = self._segment(arguments[values.index(rest[0])])
            hint = "; a number is named and given in a scene" if sp.expand(r - rest[0]).is_number else ""
            self._refuse(f"{text!r} is not r - b; {FORM}{hint}", node)
        self._break(b, node)
        return rest[0] * step(b)

    def _pieces(self, arguments: list[ast.expr], node: ast.Call, depth: int) -> sp.Expr:
        found: list[tuple[sp.Expr, sp.Symbol | None]] = []
        for argument in arguments:
            if not (isinstance(argument, ast.Tuple) and len(argument.elts) == 2):
                self._refuse(f"a piece is a pair of f and a condition; {PIECES}", argument)
            found.append((self._walk(argument.elts[0], depth), self._limit(argument.elts[1])))
        breaks = [b for _, b in found]
        if len(found) < 2 or breaks[-1] is not None or None in breaks[:-1]:
            self._refuse(f"the last piece, and no other, has the condition True; {PIECES}", node)
        total = found[0][0]
        for (before, b), (piece, _) in itertools.pairwise(found):
            added = sp.expand(piece - before)
            jump = sp.expand(added.subs(r, b))
            if any(str(symbol).startswith("[") for symbol in jump.free_symbols):
                self._refuse(f"a piece has a break of its own; {PIECES} for each break in turn", node)
            if jump != 0:
                jumps = f"f jumps by {sp.sstr(jump)[:60]} at the break r = {b}"
                self._refuse(f"{jumps}; write pieces that agree there", node)
            self._break(b, node)
            total += added * step(b)
        return total

    def _limit(self, node: ast.expr) -> sp.Symbol | None:
        """The b of a condition r < b or r <= b; None for True."""
        match node:
            case ast.Constant(value=True):
                return None
            case ast.Compare(left=ast.Name(id="r"), ops=[ast.Lt() | ast.LtE()], comparators=[ast.Name() as name]):
                found = self._name(name)
                if found.is_Symbol and found != r:
                    return found
        return self._refuse(f"a condition is r < b with a parameter b, and True for the last piece; {PIECES}", node)

    def _break(self, b: sp.Symbol, node: ast.AST) -> None:
        self.breaks.setdefault(b.name, b)
        if len(self.breaks) > MOST_BREAKS:
            self._refuse(f"{b} is one break more than {MOST_BREAKS}; join some pieces", node)

    def _bounded(self, expr: sp.Expr, node: ast.expr) -> sp.Expr:
        reason = excess(expr)
        if reason:
            self._refuse(f"{self._segment(node)!r} {reason}", node)
        return expr
