"""Programs over single numbers as C99: what is known when the file is written is worked out there, the rest is printed.

A program of the package is run once with its arguments as names.  Numbers that depend on none are folded, as Python has
them; a loop over something of a known length is written out; a function that is given a function is written where it is
called, so that the file needs no pointers to functions, no memory of its own and no library but that of C.
"""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import reduce
from itertools import count
from pathlib import Path
from typing import Any, TypeAlias

from ..code.programs import FOLDER
from ..code.programs.bodies import BODIES
from .reach import PLAIN, Module, NoProgramError, Package

HELPERS = Path(__file__).with_name("numbers.h")
"""What C lacks: comparisons that keep what is no number, exact sums, the places of a rule."""
Value: TypeAlias = Any
"""A number of C, or what is known of Python: a number, text, None, a sequence of values, a function."""
INLINE = 60
"""Functions within functions, at most."""
SPELLED = 32
"""Turns of a loop that are written out, at most."""


@dataclass(frozen=True)
class Number:
    """An expression of C, how tightly it is bound, and the variables in it."""

    text: str
    kind: str = "double"
    rank: int = 9
    names: frozenset[str] = frozenset()


@dataclass
class Scope:
    """The names of a function while it is run; `divided` is how many branches and loops stand around."""

    module: Module
    around: Scope | None = None
    names: dict[str, Value] = field(default_factory=dict)
    divided: int = 0
    result: Value = None
    end: str = ""
    """The label behind the function, where it stands inside another."""
    loops: list[str] = field(default_factory=list)
    """Of each loop around, the label behind it; empty for a loop of C."""
    alone: bool = False
    """Whether it is a function of C by itself."""


@dataclass(frozen=True)
class Closure:
    """A function of Python with the names around it."""

    node: ast.FunctionDef | ast.Lambda
    module: Module
    scope: Scope | None = None


@dataclass(frozen=True)
class Whole:
    """A module of the package, or NumPy, whose names are attributes."""

    name: str


@dataclass(frozen=True)
class Native:
    """A function that both languages have: how it is called in C, and in Python where all is known."""

    name: str
    known: Callable[..., Any] | None = None


@dataclass(frozen=True)
class Kind:
    """A class of named fields."""

    node: ast.ClassDef
    module: Module


@dataclass(frozen=True)
class Record:
    """One of its instances."""

    fields: dict[str, Value]


@dataclass(frozen=True)
class Each:
    """What is made of every node of a rule, asked for by a sum."""

    element: ast.expr
    loop: ast.comprehension
    pairs: Number
    scope: Scope


class _SeveralValuesError(Exception):
    """A function gives no single number, and is written where it is called."""


class _Over(Exception):  # noqa: N818 - no error: what stands behind is never reached
    """A statement was left for good."""


def _least(x: float, y: float) -> float:
    return x if x < y or x != x else y


def _greatest(x: float, y: float) -> float:
    return x if x > y or x != x else y


def _or_none(function: Callable[..., float]) -> Callable[..., float]:
    """A function of `math` that gives what C gives where Python has an error."""

    def called(*given: float) -> float:
        try:
            return function(*given)
        except ValueError:
            return math.nan

    return called


SAME = ("exp", "expm1", "sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "asinh", "hypot", "cbrt", "atan2")
BOUNDED = ("sqrt", "log", "log1p", "acos", "asin", "atanh", "acosh", "pow")
NATIVES: dict[str, Native] = {
    **{name: Native(name, getattr(math, name)) for name in SAME},
    **{name: Native(name, _or_none(getattr(math, name))) for name in BOUNDED},
    "arctan": Native("atan", math.atan),
    "arctan2": Native("atan2", math.atan2),
    "arctanh": Native("atanh", _or_none(math.atanh)),
    "arcsinh": Native("asinh", math.asinh),
    "power": Native("pow", math.pow),
    "exp2": Native("exp2", lambda x: 2.0**x),
    "gamma": Native("tgamma", math.gamma),
    "lgamma": Native("lgamma", math.lgamma),
    "abs": Native("fabs", abs),
    "minimum": Native("minimum", _least),
    "maximum": Native("maximum", _greatest),
    "copysign": Native("copysign", math.copysign),
    "nextafter": Native("nextafter", math.nextafter),
}
"""Functions by Python's and NumPy's names."""
WORDS = frozenset(
    "auto break case char const continue default do double else enum extern float for goto if inline int long register "
    "restrict return short signed sizeof static struct switch typedef union unsigned void volatile while "
    "minimum maximum lower higher sum_of pairs_of j0 j1 jn y0 y1 yn gamma main log exp".split()
)
"""Names that mean something else in C."""
CONSTANTS = {"pi": math.pi, "e": math.e, "inf": math.inf, "nan": math.nan}
LIKE = ("asarray", "float64", "vectorize")
FULL = {"ones_like": 1.0, "zeros_like": 0.0, "zeros": 0.0, "ndim": 0}
TRUTHS = ("any", "all", "count_nonzero")
ARITHMETIC: dict[type, tuple[str, int, Callable[[Any, Any], Any]]] = {
    ast.Add: ("+", 5, operator.add), ast.Sub: ("-", 5, operator.sub),
    ast.Mult: ("*", 6, operator.mul), ast.Div: ("/", 6, operator.truediv),
    ast.Mod: ("%", 6, operator.mod), ast.BitAnd: ("&", 2, operator.and_), ast.BitOr: ("|", 1, operator.or_),
}  # fmt: skip
COMPARED: dict[type, tuple[str, Callable[[Any, Any], Any]]] = {
    ast.Lt: ("<", operator.lt), ast.LtE: ("<=", operator.le), ast.Gt: (">", operator.gt), ast.GtE: (">=", operator.ge),
    ast.Eq: ("==", operator.eq), ast.NotEq: ("!=", operator.ne),
}  # fmt: skip


class File:
    """The functions of one file of C, and all that they need."""

    def __init__(self, package: Package) -> None:
        self.package = package
        self.texts: dict[object, str] = {}
        self.made: dict[object, str] = {}
        self.counts: set[int] = set()
        self.variables: set[str] = set()
        self.taken: set[str] = set()
        """Names of variables, and of functions."""
        self._constants: dict[tuple[str, str], Value] = {}

    def add(self, module: str, function: str, name: str, known: Mapping[str, Value] | None = None) -> list[str]:
        """Take a public function along under a name; the arguments it has in C, in their order.

        Those `known` are none: a number is written into the file; a sequence of texts stands for arguments of that
        names, as the coefficients of a polynomial.

        Raises
        ------
        NoProgramError
            If it, or something it calls, is evaluated over arrays only, or gives more than one number.
        """
        home, node = self.package.program(module, function)
        before = dict(self.texts), dict(self.made), set(self.counts)
        arguments: list[str] = []
        given: list[Value] = []
        for own in node.args.args:
            value = (known or {}).get(own.arg)
            spelled = isinstance(value, tuple) and all(isinstance(one, str) for one in value)
            letters = value if spelled and value else (own.arg,) if value is None else ()
            arguments += letters
            numbers = tuple(Number(_word(one), names=frozenset((_word(one),))) for one in letters)
            given.append(numbers if spelled else numbers[0] if numbers else value)
        try:
            writer = Writer(self)
            text = writer.whole(Closure(node, home), given, name, [_word(one) for one in arguments], "double")
        except (NoProgramError, _SeveralValuesError) as error:
            self.texts, self.made, self.counts = before
            if isinstance(error, NoProgramError):
                raise
            message = f"{module}.{function} gives no single number"
            raise NoProgramError(message) from None
        self.texts["public", name] = text
        return arguments

    def text(self) -> str:
        """The whole file; what is needed stands in front of what needs it."""
        nodes = self.package.module("_runtime.nodes")
        assert nodes is not None
        halves = ast.literal_eval(_value_of(nodes.bound["_LOWER_HALVES"])) if self.counts else {}
        tables = [_table(count, halves[count]) for count in sorted(self.counts)]
        return "\n".join([HELPERS.read_text(encoding="utf-8"), *tables, *self.texts.values()])

    def function(self, closure: Closure, given: Sequence[Value]) -> tuple[str, list[Number]]:
        """The name of the function of C for what is known of the arguments, and those that are left."""
        left: list[Number] = []
        shape = tuple(_shape(value, left) for value in given)
        assert isinstance(closure.node, ast.FunctionDef)
        key = (closure.module.name, closure.node.name, shape)
        name = self.made.get(key)
        if name == "":
            raise _SeveralValuesError
        if name is None:
            home = closure.module.name.rpartition(".")[2].lstrip("_")
            name = self._free(f"{home}_{closure.node.name.lstrip('_')}")
            self.made[key] = name
            letters = [f"x{place}" for place in range(len(left))]
            numbers = iter([Number(x, own.kind, 9, frozenset((x,))) for x, own in zip(letters, left, strict=True)])
            known = [_renamed(value, numbers) for value in given]
            kinds = [own.kind for own in left]
            try:
                text = Writer(self).whole(closure, known, name, letters, "static double", kinds)
            except BaseException:
                self.made[key] = ""
                raise
            self.texts[key] = text
        return name, left

    def _free(self, plain: str) -> str:
        name = next(one for one in _like(plain) if one not in self.taken and one not in self.variables)
        self.taken.add(name)
        return name

    def constant(self, module: Module, name: str) -> Value:
        """What a module binds to a name."""
        key = (module.name, name)
        if key not in self._constants:
            node = module.bound[name]
            if isinstance(node, ast.FunctionDef):
                made: Value = Closure(node, module)
                for decorator in node.decorator_list:
                    if isinstance(decorator, ast.Name) and decorator.id == "in_groups":
                        writer = Writer(self)
                        scope = Scope(module)
                        made = writer.call(writer.named(scope, "in_groups"), [made], {})
            elif isinstance(node, ast.ClassDef):
                made = Kind(node, module)
            else:
                made = Writer(self).expr(_value_node(node), Scope(module))
            self._constants[key] = made
        return self._constants[key]


class Writer:
    """Writes one function of C."""

    def __init__(self, file: File) -> None:
        self.file = file
        self.lines: list[tuple[int, str, str | None, frozenset[str]]] = []
        """Of each line its depth, text, the variable that it sets, and those that it needs."""
        self.kinds: dict[str, str] = {}
        self.depth, self.inlined, self.labels = 1, 0, 0

    def whole(
        self,
        closure: Closure,
        given: Sequence[Value],
        name: str,
        letters: Sequence[str],
        returns: str,
        kinds: Sequence[str] = (),
    ) -> str:
        """The text of a function whose arguments have these letters."""
        assert isinstance(closure.node, ast.FunctionDef)
        self.kinds |= dict.fromkeys(letters, "")
        scope = Scope(closure.module, names=dict(zip(_names(closure.node.args), given, strict=True)), alone=True)
        try:
            self.block(closure.node.body, scope)
        except _Over:
            pass
        else:
            raise _missing(scope, f"{name} without a result")
        typed = [f"{kind} {letter}" for letter, kind in zip(letters, kinds or ["double"] * len(letters), strict=True)]
        kept = self._needed()
        used = {need for _, text, _, needs in kept for need in needs} | {own for _, _, own, _ in kept if own}
        declared = [f"  {_declared(kind, own)};" for own, kind in self.kinds.items() if kind and own in used]
        unused = [f"  (void){letter};" for letter in letters if letter not in used]
        body = [f"{'  ' * depth}{text}" for depth, text, _, _ in kept]
        return "\n".join([f"{returns} {name}({', '.join(typed) or 'void'})", "{", *declared, *unused, *body, "}", ""])

    def _needed(self) -> list[tuple[int, str, str | None, frozenset[str]]]:
        """The lines without those that set what nothing reads."""
        lines = self.lines
        while True:
            read = {name for _, _, own, needs in lines for name in needs if name != own}
            kept = [line for line in lines if line[2] is None or line[2] in read]
            if len(kept) == len(lines):
                return kept
            lines = kept

    def emit(self, text: str, sets: str | None = None, needs: Iterable[str] = ()) -> None:
        """A line of the function."""
        self.lines.append((self.depth, text, sets, frozenset(needs)))

    def variable(self, name: str, kind: str) -> Number:
        """A variable of C of that name, or of one like it where another is there."""
        plain = _word(name)
        own = next(one for one in _like(plain) if one not in self.kinds and one not in self.file.taken)
        self.kinds[own] = kind
        self.file.variables.add(own)
        return Number(own, kind, 9, frozenset((own,)))

    def set(self, target: Number, value: Value) -> None:
        """A variable gets a value."""
        number = _number(value, target.kind)
        if number.text != target.text:
            self.emit(f"{target.text} = {number.text};", target.text, number.names)

    def bind(self, scope: Scope, name: str, value: Value) -> None:
        """A name of Python gets a value; numbers of C are kept in a variable of that name."""
        old = scope.names.get(name)
        scope.names[name] = self._kept(name, value, old if scope.divided else None, scope)

    def _kept(self, name: str, value: Value, old: Value, scope: Scope) -> Value:
        if isinstance(value, tuple | list) and any(map(_is_number, _leaves(value))):
            olds = old if isinstance(old, tuple | list) and len(old) == len(value) else [None] * len(value)
            kept = [self._kept(name, one, before, scope) for one, before in zip(value, olds, strict=True)]
            return kept if isinstance(value, list) else tuple(kept)
        if not _is_number(value) or (isinstance(value, bool | int | float) and not scope.divided):
            if scope.divided and old is not None and old is not value and old != value:
                raise _missing(scope, f"{name}, which is one thing or another")
            return value
        kind = value.kind if isinstance(value, Number) else "int" if isinstance(value, bool) else "double"
        if isinstance(old, Number) and old.kind in ("int", "double"):
            if old.kind != kind and "double" not in (old.kind,):
                raise _missing(scope, f"{name}, a number of two kinds")
            self.set(old, value)
            return old
        own = self.variable(name, kind)
        self.set(own, value)
        return own

    def divide(self, scope: Scope, body: Sequence[ast.stmt], loop: bool = False) -> None:
        """Make variables of what is known in front of a branch or a loop, and may change in it."""
        stored = {one.id for node in body for one in _inside(node) if isinstance(one, ast.Name)
                  and isinstance(one.ctx, ast.Store)}  # fmt: skip
        grown = {call.func.value.id for node in body for call in _inside(node) if isinstance(call, ast.Call)
                 and isinstance(call.func, ast.Attribute) and call.func.attr == "append"
                 and isinstance(call.func.value, ast.Name)}  # fmt: skip
        for name in sorted(stored & scope.names.keys()):
            scope.names[name] = self._variables(name, scope.names[name])
        for name in sorted(grown & scope.names.keys()):
            if loop and scope.names[name] == []:
                scope.names[name] = total = self.variable(name, "sum")
                self.emit(f"{total.text}.count = 0;", None, total.names)

    def _variables(self, name: str, value: Value) -> Value:
        if isinstance(value, tuple | list):
            return type(value)(self._variables(name, one) for one in value)
        if not isinstance(value, bool | int | float):
            return value
        own = self.variable(name, "int" if isinstance(value, bool) else "double")
        self.set(own, value)
        return own

    # statements

    def block(self, body: Sequence[ast.stmt], scope: Scope) -> None:
        """Statements, one after another."""
        for statement in body:
            self.statement(statement, scope)

    def inside(self, body: Sequence[ast.stmt], scope: Scope) -> bool:
        """The statements of a branch or a loop, deeper by one; whether they end there."""
        self.depth += 1
        scope.divided += 1
        try:
            self.block(body, scope)
        except _Over:
            return True
        finally:
            self.depth -= 1
            scope.divided -= 1
        return False

    def statement(self, node: ast.stmt, scope: Scope) -> None:
        """One statement; what is known decides branches here."""
        match node:
            case ast.Expr(ast.Constant()) | ast.Pass() | ast.ImportFrom():
                return
            case ast.Expr(ast.Call(ast.Attribute(ast.Name(name), "append"), [item])):
                self._append(scope, name, self.expr(item, scope))
            case ast.Expr(value):
                self.expr(value, scope)
            case ast.Return(value):
                self._return(scope, self.expr(value, scope) if value else None)
            case ast.Assign(targets, value):
                made = self.expr(value, scope)
                for target in targets:
                    self.assign(target, made, scope)
            case ast.AugAssign(ast.Name(name), kind, value):
                self.bind(scope, name, self._arithmetic(kind, scope.names[name], self.expr(value, scope), scope))
            case ast.If(test, body, orelse):
                self._if(self.expr(test, scope), body, orelse, scope)
            case ast.For(target, iterated, body):
                self._for(target, self.expr(iterated, scope), body, scope)
            case ast.FunctionDef():
                scope.names[node.name] = Closure(node, scope.module, scope)
            case ast.Break():
                self._leave(scope.loops[-1], "break;")
            case ast.Raise():
                # panels that Python leaves to the arrays are summed here
                if scope.module.name != PLAIN:
                    self._return(scope, math.nan)
            case _:
                raise _missing(scope, ast.unparse(node))

    def _leave(self, label: str, otherwise: str) -> None:
        self.emit(f"goto {label};" if label else otherwise, None, [label] if label else [])
        raise _Over

    def assign(self, target: ast.expr, value: Value, scope: Scope) -> None:
        """What stands left of an equals sign gets a value."""
        match target:
            case ast.Name(name):
                self.bind(scope, name, value)
            case ast.Tuple(targets) | ast.List(targets):
                for one, own in zip(targets, self._items(value, scope), strict=True):
                    self.assign(one, own, scope)
            case _:
                raise _missing(scope, ast.unparse(target))

    def _append(self, scope: Scope, name: str, value: Value) -> None:
        known = scope.names[name]
        if isinstance(known, list) and not scope.divided:
            known.append(value)
            return
        if not (isinstance(known, Number) and known.kind == "sum"):
            raise _missing(scope, f"{name}.append")
        self._add(known, value)

    def _add(self, total: Number, value: Value) -> None:
        number = _number(value)
        self.emit(f"sum_add(&{total.text}, {number.text});", None, total.names | number.names)

    def _if(self, test: Value, body: Sequence[ast.stmt], orelse: Sequence[ast.stmt], scope: Scope) -> None:
        if not isinstance(test, Number):
            self.block(body if test else orelse, scope)
            return
        self.divide(scope, [*body, *orelse])
        before = dict(scope.names)
        self.emit(f"if ({test.text}) {{", None, test.names)
        over = self.inside(body, scope)
        first = dict(scope.names)
        scope.names.update({name: own for name, own in before.items()})
        otherwise = False
        if orelse:
            for name in first.keys() - before.keys():
                if not isinstance(first[name], Closure):
                    scope.names[name] = first[name]
            self.emit("} else {")
            otherwise = self.inside(orelse, scope)
        self.emit("}")
        if not over:
            scope.names.update({name: own for name, own in first.items() if name not in before or over})
        if over and otherwise:
            raise _Over

    def _for(self, target: ast.expr, iterated: Value, body: Sequence[ast.stmt], scope: Scope) -> None:
        if isinstance(iterated, Number) and iterated.kind == "pairs":
            self.divide(scope, body, loop=True)
            node, weight = self._start_rule(iterated)
            self._loop(body, scope, lambda: self.assign(target, (node, weight), scope))
        elif isinstance(iterated, range) and (len(iterated) > SPELLED or not isinstance(iterated, range)):
            self.divide(scope, body, loop=True)
            own = self.variable(ast.unparse(target), "int")
            start, stop, step = iterated.start, iterated.stop, iterated.step
            sign = "<" if step > 0 else ">"
            self.emit(f"for ({own.text} = {start}; {own.text} {sign} {stop}; {own.text} += {step}) {{", None, own.names)
            self._loop(body, scope, lambda: self.assign(target, own, scope))
        elif isinstance(iterated, Counted):
            self.divide(scope, body, loop=True)
            own = self.variable(ast.unparse(target), "int")
            start, stop = _number(iterated.start, "int"), _number(iterated.stop, "int")
            sign = "<" if iterated.step > 0 else ">"
            step = f"{own.text} += {iterated.step}"
            head = f"for ({own.text} = {start.text}; {own.text} {sign} {stop.text}; {step}) {{"
            self.emit(head, None, own.names | start.names | stop.names)
            self._loop(body, scope, lambda: self.assign(target, own, scope))
        else:
            self._turns(target, self._items(iterated, scope), body, scope)

    def _loop(self, body: Sequence[ast.stmt], scope: Scope, begin: Callable[[], None]) -> None:
        scope.loops.append("")
        self.depth += 1
        scope.divided += 1
        begin()
        self.depth -= 1
        scope.divided -= 1
        self.inside(body, scope)
        self.emit("}")
        scope.loops.pop()

    def _turns(self, target: ast.expr, items: Sequence[Value], body: Sequence[ast.stmt], scope: Scope) -> None:
        left = any(isinstance(one, ast.Break) for node in body for one in _inside(node))
        label = self._label("done") if left else ""
        if left:
            self.divide(scope, body)
            scope.divided += 1
        scope.loops.append(label)
        try:
            for item in items:
                self.assign(target, item, scope)
                self.block(body, scope)
        except _Over:
            if not left:
                raise
        finally:
            scope.loops.pop()
            scope.divided -= left
        self._place(label)

    def _label(self, name: str) -> str:
        self.labels += 1
        return f"{name}_{self.labels}"

    def _place(self, label: str) -> None:
        if label and any(label in needs for _, _, _, needs in self.lines):
            self.emit(f"{label}:;")

    def _return(self, scope: Scope, value: Value) -> None:
        if scope.alone:
            number = self._single(value)
            self.emit(f"return {number.text};", None, number.names)
        elif scope.divided or scope.result is not None:
            scope.result = self._joined(scope, value)
            self._leave(scope.end, "")
        else:
            scope.result = value
        raise _Over

    @staticmethod
    def _single(value: Value) -> Number:
        if not _is_number(value) or (isinstance(value, Number) and value.kind in ("pairs", "sum")):
            raise _SeveralValuesError
        return _number(value)

    def _joined(self, scope: Scope, value: Value) -> Value:
        """The variables in which a function that returns at several places leaves what it gives."""

        def joined(known: Value, one: Value) -> Value:
            if isinstance(one, tuple | list):
                knowns = known if known is not None else [None] * len(one)
                return type(one)(map(joined, knowns, one))
            if not _is_number(one):
                if known is not None and known != one:
                    raise _missing(scope, "a function that gives one thing or another")
                return one
            if known is None:
                kind = one.kind if isinstance(one, Number) else "double"
                known = self.variable("result", "double" if kind == "int" else kind)
            self.set(known, one)
            return known

        return joined(scope.result, value)

    # expressions

    def expr(self, node: ast.expr, scope: Scope) -> Value:
        """The value of an expression: known, or a number of C."""
        match node:
            case ast.Constant(value):
                return value
            case ast.Name(name):
                return self.named(scope, name)
            case ast.Attribute(value, attribute):
                return self._attribute(self.expr(value, scope), attribute, scope)
            case ast.BinOp(left, kind, right):
                return self._arithmetic(kind, self.expr(left, scope), self.expr(right, scope), scope)
            case ast.UnaryOp(kind, operand):
                return self._unary(kind, self.expr(operand, scope), scope)
            case ast.BoolOp(kind, values):
                return self._bool(isinstance(kind, ast.Or), values, scope)
            case ast.Compare(left, kinds, others):
                return self._compare(kinds, [self.expr(one, scope) for one in (left, *others)], scope)
            case ast.IfExp(test, body, orelse):
                return self._choice(self.expr(test, scope), body, orelse, scope)
            case ast.Tuple(values):
                return tuple(self._spread(values, scope))
            case ast.List(values):
                return list(self._spread(values, scope))
            case ast.Dict(keys, values):
                return {self.expr(k, scope): self.expr(v, scope) for k, v in zip(keys, values, strict=True) if k}
            case ast.Lambda():
                return Closure(node, scope.module, scope)
            case ast.ListComp(element, [loop]) | ast.GeneratorExp(element, [loop]):
                return self._each(element, loop, scope)
            case ast.Subscript(value, place):
                return self._item(self.expr(value, scope), place, scope)
            case ast.Call(function, given, keywords):
                named = {own.arg: self.expr(own.value, scope) for own in keywords if own.arg}
                return self.call(self.expr(function, scope), list(self._spread(given, scope)), named, scope)
        raise _missing(scope, ast.unparse(node))

    def _spread(self, values: Sequence[ast.expr], scope: Scope) -> Iterator[Value]:
        for value in values:
            if isinstance(value, ast.Starred):
                yield from self._items(self.expr(value.value, scope), scope)
            else:
                yield self.expr(value, scope)

    def _items(self, value: Value, scope: Scope) -> Sequence[Value]:
        if isinstance(value, Record):
            return list(value.fields.values())
        if isinstance(value, tuple | list | range):
            return value
        raise _missing(scope, f"the parts of {value!r}")

    def named(self, scope: Scope, name: str) -> Value:
        """What a name stands for, inside or outside of the function."""
        around: Scope | None = scope
        while around is not None:
            if name in around.names:
                return around.names[name]
            around = around.around
        package = self.file.package
        if name == "bodies" and name not in scope.module.bound:
            return Whole("bodies:" + scope.module.name.removeprefix(f"{FOLDER}."))
        found = package.resolved(scope.module.name, name)
        if found is None:
            return NATIVES["abs"] if name == "abs" else Native(name)
        home, own = found
        if home == "functools":
            return Native(own)
        if own == "" or (home, own) == (PLAIN, "MATH"):
            return Whole("numpy" if (home, own) == (PLAIN, "MATH") else home)
        if home in ("math", "numpy"):
            return self._of_numpy(own, scope)
        if home == PLAIN and own in ("rule", "_pairs", "gauss_legendre", "sqrt", "log", "log1p"):
            return NATIVES.get(own) or Native(own)
        there = package.module(home)
        if there is None:
            raise _missing(scope, name)
        return self.file.constant(there, own)

    def _of_numpy(self, name: str, scope: Scope) -> Value:
        if name in CONSTANTS:
            return CONSTANTS[name]
        return NATIVES.get(name) or Native(name)

    def _attribute(self, value: Value, attribute: str, scope: Scope) -> Value:
        if isinstance(value, Record):
            return value.fields[attribute]
        if not isinstance(value, Whole):
            return Native(f".{attribute}")
        if value.name in ("numpy", "math"):
            return self._of_numpy(attribute, scope)
        if value.name.startswith("bodies:"):
            own = value.name.removeprefix("bodies:")
            homes = [self.file.package.module(f"{place}{own}") for place in (f"{BODIES}.", "")]
            home = next((one for one in homes if one and attribute in one.bound), None)
        else:
            home = self.file.package.module(value.name)
        if home is None:
            raise _missing(scope, attribute)
        found = self.file.package.resolved(home.name, attribute)
        there = self.file.package.module(found[0]) if found else None
        if not found or there is None:
            raise _missing(scope, attribute)
        return self.file.constant(there, found[1])

    def _arithmetic(self, kind: ast.operator, left: Value, right: Value, scope: Scope) -> Value:
        if isinstance(kind, ast.Pow):
            if not isinstance(left, Number) and not isinstance(right, Number):
                return left**right
            return self._native(NATIVES["pow"], [left, right])
        if isinstance(kind, ast.FloorDiv) and not isinstance(left, Number) and not isinstance(right, Number):
            return left // right
        if type(kind) not in ARITHMETIC:
            raise _missing(scope, f"the operator {type(kind).__name__}")
        sign, rank, known = ARITHMETIC[type(kind)]
        if isinstance(left, tuple | list) and isinstance(right, tuple | list):
            return type(left)([*left, *right])
        if not isinstance(left, Number) and not isinstance(right, Number):
            if isinstance(left, bool | int | float) and isinstance(right, int | float) and sign == "/" and right == 0:
                return math.nan if left == 0 or left != left else math.copysign(math.inf, left)
            return known(left, right)
        kinds = {_kind(left), _kind(right)}
        whole = kinds == {"int"} and sign != "/"
        if sign in "%&|" and not whole:
            raise _missing(scope, f"{sign} of numbers that are not whole")
        inner = "int" if whole else "double"
        a, b = _number(left, inner), _number(right, inner)
        first = a.text if a.rank >= rank else f"({a.text})"
        second = b.text if b.rank > rank and not b.text.startswith("-") else f"({b.text})"
        if sign == "&":
            sign, rank = "&&", 2
            first, second = _bracketed(a, 3), _bracketed(b, 3)
        elif sign == "|":
            sign, rank = "||", 1
            first, second = _bracketed(a, 3), _bracketed(b, 3)
        return Number(f"{first} {sign} {second}", inner, rank, a.names | b.names)

    def _unary(self, kind: ast.unaryop, value: Value, scope: Scope) -> Value:
        if not isinstance(value, Number):
            return {ast.USub: operator.neg, ast.UAdd: operator.pos, ast.Not: operator.not_}[type(kind)](value)
        if isinstance(kind, ast.Not):
            return Number(f"!{_bracketed(value, 9)}", "int", 8, value.names)
        return Number(f"-{_bracketed(value, 9)}", value.kind, 7, value.names) if isinstance(kind, ast.USub) else value

    def _bool(self, either: bool, values: Sequence[ast.expr], scope: Scope) -> Value:
        made: list[Number] = []
        value: Value = not either
        for node in values:
            value = self.expr(node, scope)
            if isinstance(value, Number):
                made.append(value)
            elif bool(value) is either:
                # the rest is not asked for
                if not made or either is False:
                    return value if not made else 0
                return 1
        if not made:
            return value
        sign, rank = ("||", 1) if either else ("&&", 2)
        text = f" {sign} ".join(_bracketed(one, 3) for one in made)
        return Number(text, "int", rank if len(made) > 1 else made[0].rank, _names_of(made))

    def _compare(self, kinds: Sequence[ast.cmpop], values: Sequence[Value], scope: Scope) -> Value:
        made: list[Number] = []
        for left, kind, right in zip(values[:-1], kinds, values[1:], strict=True):
            if isinstance(kind, ast.Is | ast.IsNot):
                same = left is right if not isinstance(left, Number) else False
                value: Value = same is isinstance(kind, ast.Is)
            elif isinstance(left, Number) or isinstance(right, Number):
                sign, _ = COMPARED[type(kind)]
                inner = "int" if {_kind(left), _kind(right)} == {"int"} else "double"
                a, b = _number(left, inner), _number(right, inner)
                value = Number(f"{_bracketed(a, 5)} {sign} {_bracketed(b, 5)}", "int", 3, a.names | b.names)
            else:
                value = COMPARED[type(kind)][1](left, right)
            if isinstance(value, Number):
                made.append(value)
            elif not value:
                return False
        if not made:
            return True
        return made[0] if len(made) == 1 else Number(" && ".join(one.text for one in made), "int", 2, _names_of(made))

    def _choice(self, test: Value, body: ast.expr, orelse: ast.expr, scope: Scope) -> Value:
        if not isinstance(test, Number):
            return self.expr(body if test else orelse, scope)
        outer, self.lines = self.lines, []
        self.depth += 1
        scope.divided += 1
        first = self.expr(body, scope)
        firsts, self.lines = self.lines, []
        second = self.expr(orelse, scope)
        seconds, self.lines = self.lines, outer
        scope.divided -= 1
        self.depth -= 1
        if not _same_shape(first, second):
            raise _missing(scope, f"{ast.unparse(body)} or {ast.unparse(orelse)}")
        if not firsts and not seconds and _is_number(first):
            inner = "int" if {_kind(first), _kind(second)} == {"int"} else "double"
            a, b = _number(first, inner), _number(second, inner)
            text = f"{_bracketed(test, 1)} ? {_bracketed(a, 1)} : {_bracketed(b, 1)}"
            return Number(text, inner, 0, test.names | a.names | b.names)
        own = _mapped(first, lambda one, other: self.variable("chosen", _joint(one, other)), second)
        self.emit(f"if ({test.text}) {{", None, test.names)
        for place, (lines, value) in enumerate(((firsts, first), (seconds, second))):
            if place:
                self.emit("} else {")
            self.lines += lines
            self.depth += 1
            _mapped(own, self.set, value)
            self.depth -= 1
        self.emit("}")
        return own

    def _each(self, element: ast.expr, loop: ast.comprehension, scope: Scope) -> Value:
        iterated = self.expr(loop.iter, scope)
        if isinstance(iterated, Number) and iterated.kind == "pairs":
            return Each(element, loop, iterated, scope)
        made = []
        for item in self._items(iterated, scope):
            inner = Scope(scope.module, scope, divided=scope.divided)
            self._name(loop.target, item, inner)
            if all(self._holds(test, inner) for test in loop.ifs):
                made.append(self.expr(element, inner))
        return tuple(made)

    def _holds(self, test: ast.expr, scope: Scope) -> bool:
        # a term that is left out where it is nothing may as well be added
        value = self.expr(test, scope)
        return isinstance(value, Number) or bool(value)

    def _name(self, target: ast.expr, value: Value, scope: Scope) -> None:
        """Names for what is there already, without variables."""
        if isinstance(target, ast.Name):
            scope.names[target.id] = value
            return
        assert isinstance(target, ast.Tuple | ast.List)
        for one, own in zip(target.elts, self._items(value, scope), strict=True):
            self._name(one, own, scope)

    def _item(self, value: Value, place: ast.expr, scope: Scope) -> Value:
        if isinstance(place, ast.Slice):
            ends = [None if one is None else self.expr(one, scope) for one in (place.lower, place.upper, place.step)]
            return self._items(value, scope)[slice(*ends)]
        index = self.expr(place, scope)
        if isinstance(index, Number) or not isinstance(value, tuple | list | range | dict):
            raise _missing(scope, f"part {ast.unparse(place)} of something")
        return value[index]

    # calls

    def call(self, function: Value, given: list[Value], named: dict[str, Value], scope: Scope | None = None) -> Value:
        """What a function gives."""
        match function:
            case Closure():
                return self._closure(function, given, named)
            case Kind(node, module):
                fields = _fields(node)
                values = dict(zip(fields, given, strict=False)) | named
                own = Scope(module)
                return Record({
                    name: values[name] if name in values else self.expr(value, own)
                    for name, value in fields.items() if name in values or value
                })  # fmt: skip
            case Rule(lengths):
                return self._rule(lengths, given[0])
            case Native():
                return self._natively(function, given, named, scope or Scope(Module("", "")))
        raise _missing(scope, f"a call of {function!r}")

    def _closure(self, closure: Closure, given: Sequence[Value], named: Mapping[str, Value]) -> Value:
        bound = self._bound(closure, given, named)
        leaves = [leaf for value in bound.values() for leaf in _leaves(value)]
        numbers = all(_is_number(leaf) or isinstance(leaf, str) or leaf is None for leaf in leaves)
        if closure.scope is None and numbers and any(isinstance(leaf, Number) for leaf in leaves):
            try:
                name, left = self.file.function(closure, list(bound.values()))
            except _SeveralValuesError:
                pass
            else:
                text = ", ".join(own.text for own in left)
                return Number(f"{name}({text})", "double", 9, _names_of(left))
        return self._inlined(closure, bound)

    def _inlined(self, closure: Closure, bound: dict[str, Value]) -> Value:
        if self.inlined >= INLINE:
            raise _missing(Scope(closure.module), "functions within functions without an end")
        self.inlined += 1
        scope = Scope(closure.module, closure.scope, end=self._label("end"))
        if isinstance(closure.node, ast.Lambda):
            scope.names = bound
            value = self.expr(closure.node.body, scope)
        else:
            for name, own in bound.items():
                scope.names[name] = self._kept(name, own, None, scope)
            try:
                self.block(closure.node.body, scope)
            except _Over:
                pass
            self._place(scope.end)
            value = scope.result
        self.inlined -= 1
        return value

    def _bound(self, closure: Closure, given: Sequence[Value], named: Mapping[str, Value]) -> dict[str, Value]:
        arguments = closure.node.args
        plain = [own.arg for own in (*arguments.posonlyargs, *arguments.args)]
        outer = closure.scope or Scope(closure.module)
        values = dict(zip(plain, given, strict=False))
        if arguments.vararg:
            values[arguments.vararg.arg] = tuple(given[len(plain) :])
        values |= named
        defaults = dict(zip(plain[len(plain) - len(arguments.defaults) :], arguments.defaults, strict=True))
        defaults |= {
            own.arg: value
            for own, value in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True) if value is not None
        }  # fmt: skip
        order = _names(arguments)
        return {name: values[name] if name in values else self.expr(defaults[name], outer) for name in order}

    def _native(self, native: Native, given: Sequence[Value]) -> Value:
        if native.known and not any(isinstance(one, Number) for one in given):
            try:
                return native.known(*given)
            except (OverflowError, ZeroDivisionError):
                pass
        numbers = [_number(one) for one in given]
        text = ", ".join(own.text for own in numbers)
        return Number(f"{native.name}({text})", "double", 9, _names_of(numbers))

    def _natively(self, native: Native, given: list[Value], named: Mapping[str, Value], scope: Scope) -> Value:
        """A function of Python, NumPy or the rules that C has, or that is worked out here."""
        name, known = native.name, not any(isinstance(leaf, Number | Each) for leaf in _leaves(given))
        if NATIVES.get(name) is native or native.known:
            return self._native(native, given)
        if name in LIKE:
            return given[0]
        if name in FULL:
            return FULL[name]
        if name in ("full_like", "full"):
            return given[1]
        if name in TRUTHS or name == "bool":
            return given[0]
        match name:
            case "hasattr":
                return False
            case "len":
                return len(self._items(given[0], scope))
            case "range":
                if known:
                    return range(*given)
                start, stop, step = (*given, 1)[:3] if len(given) > 1 else (0, given[0], 1)
                return Counted(start, stop, step)
            case "enumerate" if not isinstance(given[0], Number):
                return tuple(enumerate(self._items(given[0], scope), *(given[1:] or [0])))
            case "zip":
                return tuple(zip(*(self._items(one, scope) for one in given), strict=False))
            case "reversed":
                return tuple(reversed(self._items(given[0], scope)))
            case "tuple" | "list" if not isinstance(given[0], Each):
                return (list if name == "list" else tuple)(self._items(given[0], scope))
            case "reduce":
                return reduce(lambda a, b: self.call(given[0], [a, b], {}, scope), self._items(given[1], scope))
            case "logical_not":
                return self._unary(ast.Not(), given[0], scope)
            case "isfinite" | "isnan":
                return getattr(math, name)(given[0]) if known else self._test(name, given[0])
            case "where":
                return self._where(*given)
            case "prod":
                return reduce(operator.mul, self._items(given[0], scope), 1)
            case "fsum" | "sum":
                return self._sum(name, given, scope)
            case "max" | "min" if len(given) > 1 or known:
                if known:
                    return (max if name == "max" else min)(*given)
                order = Native("higher" if name == "max" else "lower")
                return reduce(lambda a, b: self._of_kind(order, a, b), given)
            case "max":
                return given[0]
            case "float" | "int":
                if known:
                    return (float if name == "float" else int)(given[0])
                own = _number(given[0])
                return own if name == "float" else Number(f"(int){_bracketed(own, 9)}", "int", 8, own.names)
            case "ldexp":
                if known:
                    return math.ldexp(*given)
                x, power = _number(given[0]), _number(given[1], "int")
                return Number(f"ldexp({x.text}, {power.text})", "double", 9, x.names | power.names)
            case "frexp":
                return self._frexp(given[0])
            case "floor" | "ceil":
                return getattr(math, name)(given[0]) if known else self._native(Native(name), given)
            case "clip":
                return self._native(NATIVES["minimum"], [self._native(NATIVES["maximum"], given[:2]), given[2]])
            case "rule":
                return Rule(given[0])
            case "_pairs":
                return self._pairs(*given)
        raise _missing(scope, name)

    def _of_kind(self, order: Native, a: Value, b: Value) -> Number:
        if {_kind(a), _kind(b)} == {"int"}:
            x, y = _number(a, "int"), _number(b, "int")
            sign = ">" if order.name == "higher" else "<"
            first, second = _bracketed(x, 5), _bracketed(y, 5)
            return Number(f"{first} {sign} {second} ? {first} : {second}", "int", 0, x.names | y.names)
        made: Number = self._native(order, [a, b])
        return made

    @staticmethod
    def _test(name: str, value: Value) -> Number:
        own = _number(value)
        return Number(f"({name}({own.text}) != 0)", "int", 9, own.names)

    def _where(self, test: Value, first: Value, second: Value) -> Value:
        if not isinstance(test, Number):
            return first if test else second
        a, b = _number(first), _number(second)
        return Number(f"{_bracketed(test, 1)} ? {_bracketed(a, 1)} : {_bracketed(b, 1)}", "double", 0,
                      test.names | a.names | b.names)  # fmt: skip

    def _frexp(self, value: Value) -> Value:
        if not isinstance(value, Number):
            return math.frexp(value)
        power, share = self.variable("power", "int"), self.variable("share", "double")
        self.emit(f"{share.text} = frexp({value.text}, &{power.text});", None, share.names | power.names | value.names)
        return share, power

    def _sum(self, name: str, given: Sequence[Value], scope: Scope) -> Value:
        terms = given[0]
        if isinstance(terms, Number) and terms.kind == "sum":
            return Number(f"sum_of(&{terms.text})", "double", 9, terms.names)
        if isinstance(terms, Each):
            total = self.variable("total", "sum")
            self.emit(f"{total.text}.count = 0;", None, total.names)
            inner = Scope(terms.scope.module, terms.scope)
            node, weight = self._start_rule(terms.pairs)
            self._name(terms.loop.target, (node, weight), inner)
            self.depth += 1
            inner.divided += 1
            self._add(total, self.expr(terms.element, inner))
            self.depth -= 1
            self.emit("}")
            return Number(f"sum_of(&{total.text})", "double", 9, total.names)
        items = self._items(terms, scope)
        if name == "sum":
            start = given[1] if len(given) > 1 else 0
            return reduce(lambda a, b: self._arithmetic(ast.Add(), a, b, scope), items, start)
        if not any(isinstance(one, Number) for one in items):
            return math.fsum(items)
        total = self.variable("total", "sum")
        self.emit(f"{total.text}.count = 0;", None, total.names)
        for item in items:
            self._add(total, item)
        return Number(f"sum_of(&{total.text})", "double", 9, total.names)

    # rules of integration

    def _start_rule(self, pairs: Number) -> tuple[Number, Number]:
        """The head of a loop over the nodes of a rule, and the variables of node and weight."""
        place = self.variable("place", "int")
        node, weight = self.variable("node", "double"), self.variable("weight", "double")
        count = f"{pairs.text}.count * {pairs.text}.panels"
        head = f"for ({place.text} = 0; {place.text} < {count}; {place.text}++) {{"
        self.emit(head, None, place.names | pairs.names)
        self.depth += 1
        given = f"&{pairs.text}, {place.text}, &{weight.text}"
        needs = place.names | pairs.names | weight.names | node.names
        self.emit(f"{node.text} = node_of({given});", None, needs)
        self.depth -= 1
        return node, weight

    def _pairs(self, count: Value, panels: Value) -> Number:
        own = self.variable("nodes", "pairs")
        self._set_pairs(own, count, panels)
        return own

    def _set_pairs(self, own: Number, count: int, panels: Value) -> None:
        self.file.counts.add(count)
        number = _number(panels, "int")
        text = f"{own.text}.half = NODES_{count}; {own.text}.count = {count}; {own.text}.panels = {number.text};"
        self.emit(text, None, own.names | number.names)

    def _rule(self, lengths: Sequence[tuple[float, int]], length: Value) -> Number:
        own = self.variable("nodes", "pairs")
        x = self.variable("length", "double")
        self.set(x, length)
        for place, (longest, count) in enumerate(lengths):
            test = f"if ({x.text} <= {_literal(longest)})"
            self.emit(f"{'} else ' if place else ''}{test} {{", None, x.names)
            self.depth += 1
            self._set_pairs(own, count, 1)
            self.depth -= 1
        longest, count = lengths[-1]
        self.emit("} else {")
        self.depth += 1
        panels = Number(f"panels_of({x.text} / {_literal(longest)})", "int", 9, x.names)
        self._set_pairs(own, count, panels)
        self.depth -= 1
        self.emit("}")
        return own


@dataclass(frozen=True)
class Rule:
    """Numbers of nodes for intervals up to a length."""

    lengths: Sequence[tuple[float, int]]


@dataclass(frozen=True)
class Counted:
    """A range whose ends the program finds."""

    start: Value
    stop: Value
    step: int


def _like(name: str) -> Iterator[str]:
    """A name, and with a number behind it."""
    yield name
    yield from (f"{name}_{number}" for number in count(2))


def _table(size: int, half: Sequence[tuple[float, float]]) -> str:
    rows = ",\n".join(f"  {{{node!r}, {weight!r}}}" for node, weight in half)
    return f"static const double NODES_{size}[{len(half)}][2] = {{\n{rows}\n}};\n"


def _declared(kind: str, name: str) -> str:
    return {"sum": f"struct sum {name}", "pairs": f"struct pairs {name}"}.get(kind, f"{kind} {name} = 0")


def _value_node(node: ast.stmt) -> ast.expr:
    assert isinstance(node, ast.Assign | ast.AnnAssign) and node.value
    return node.value


def _value_of(node: ast.stmt) -> ast.expr:
    return _value_node(node)


def _fields(node: ast.ClassDef) -> dict[str, ast.expr | None]:
    return {
        one.target.id: one.value
        for one in node.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name)
    }  # fmt: skip


def _names(arguments: ast.arguments) -> list[str]:
    own = [*arguments.posonlyargs, *arguments.args, *([arguments.vararg] if arguments.vararg else [])]
    return [one.arg for one in (*own, *arguments.kwonlyargs)]


def _inside(node: ast.AST) -> Iterator[ast.AST]:
    """A statement and what is in it, without functions of its own."""
    yield node
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, ast.FunctionDef | ast.Lambda | ast.ListComp | ast.GeneratorExp):
            yield from _inside(child)


def _leaves(value: Value) -> Iterator[Value]:
    if isinstance(value, tuple | list):
        for one in value:
            yield from _leaves(one)
    else:
        yield value


def _is_number(value: Value) -> bool:
    return isinstance(value, Number | bool | int | float)


def _same_shape(one: Value, other: Value) -> bool:
    if isinstance(one, tuple | list) and isinstance(other, tuple | list):
        return len(one) == len(other) and all(map(_same_shape, one, other))
    return _is_number(one) and _is_number(other)


def _mapped(value: Value, function: Callable[[Value, Value], Value], other: Value) -> Value:
    if isinstance(value, tuple | list):
        return tuple(_mapped(one, function, own) for one, own in zip(value, other, strict=True))
    return function(value, other)


def _joint(one: Value, other: Value) -> str:
    kinds = {_kind(one), _kind(other)}
    return kinds.pop() if len(kinds) == 1 else "double"


def _kind(value: Value) -> str:
    return value.kind if isinstance(value, Number) else "int" if isinstance(value, int) else "double"


def _shape(value: Value, left: list[Number]) -> object:
    """What is known of an argument; numbers of C are put aside."""
    if isinstance(value, Number):
        left.append(value)
        return value.kind, "left"
    if isinstance(value, tuple | list):
        return tuple(_shape(one, left) for one in value)
    return type(value).__name__, value


def _renamed(value: Value, numbers: Iterator[Number]) -> Value:
    if isinstance(value, Number):
        return next(numbers)
    if isinstance(value, tuple | list):
        return type(value)(_renamed(one, numbers) for one in value)
    return value


def _literal(value: float) -> str:
    number = float(value)
    if math.isnan(number):
        return "NAN"
    if math.isinf(number):
        return "INFINITY" if number > 0.0 else "-INFINITY"
    return repr(number)


def _number(value: Value, kind: str = "double") -> Number:
    """A value as an expression of C, for arithmetic of that kind."""
    if isinstance(value, Number):
        if kind == "int" and value.kind == "double":
            return Number(f"(int){_bracketed(value, 9)}", "int", 8, value.names)
        if kind == "double" and value.kind == "int":
            return Number(f"(double){_bracketed(value, 9)}", "double", 8, value.names)
        return value
    if not isinstance(value, bool | int | float):
        raise _missing(None, f"{value!r} as a number")
    text = str(int(value)) if kind == "int" else _literal(value)
    return Number(text, kind, 7 if text.startswith("-") else 9)


def _bracketed(number: Number, rank: int) -> str:
    return number.text if number.rank >= rank else f"({number.text})"


def _names_of(numbers: Iterable[Number]) -> frozenset[str]:
    return frozenset(name for own in numbers for name in own.names)


def _word(name: str) -> str:
    return f"{name}_" if name in WORDS or re.fullmatch(r"x\d+", name) else name


def _missing(scope: Scope | None, what: str) -> NoProgramError:
    where = f" in {scope.module.name}" if scope else ""
    return NoProgramError(f"C has no counterpart of {what}{where}")
