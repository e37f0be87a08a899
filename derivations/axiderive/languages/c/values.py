"""What an expression stands for while a program is written: a number of C, or what is known of Python."""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from ..reach import Module, NoProgramError

Value: TypeAlias = Any
"""A number of C, or what is known of Python: a number, text, None, a sequence of values, a function."""


@dataclass(frozen=True)
class Number:
    """An expression of C, how tightly it is bound, and the variables in it."""

    text: str
    kind: str = "double"
    rank: int = 9
    names: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Text:
    """A function of C, the names in it, and its arguments as they are declared."""

    text: str
    needs: frozenset[str]
    arguments: tuple[str, ...]


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


@dataclass(frozen=True)
class Partial:
    """A function some of whose arguments are there already."""

    function: Value
    held: dict[str, Value]


class Growing(list[Value]):
    """A list without items; one that a function inside fills has its last two in variables, a single one as both."""

    def __init__(self, filled: Number) -> None:
        super().__init__()
        self.filled = filled
        self.before: Value = None
        self.last: Value = None


class SeveralValuesError(Exception):
    """A function gives no single number, and is written where it is called."""


class Over(Exception):  # noqa: N818 - no error: what stands behind is never reached
    """A statement was left for good."""


def bound_value(node: ast.stmt) -> ast.expr:
    """What a statement binds its name to."""
    assert isinstance(node, ast.Assign | ast.AnnAssign) and node.value
    return node.value


def fields_of(node: ast.ClassDef) -> dict[str, ast.expr | None]:
    """The fields of a class, with what they are if nothing is said."""
    return {
        one.target.id: one.value
        for one in node.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name)
    }  # fmt: skip


def names_of(arguments: ast.arguments) -> list[str]:
    """Names of the arguments of a function."""
    own = [*arguments.posonlyargs, *arguments.args, *([arguments.vararg] if arguments.vararg else [])]
    return [one.arg for one in (*own, *arguments.kwonlyargs)]


def leaves(value: Value) -> Iterator[Value]:
    """The values in sequences of sequences, one by one."""
    if isinstance(value, tuple | list):
        for one in value:
            yield from leaves(one)
    else:
        yield value


def is_number(value: Value) -> bool:
    """Whether a value is a number, of C or known."""
    return isinstance(value, Number | bool | int | float)


def same_shape(one: Value, other: Value) -> bool:
    """Whether two values are numbers, or sequences of the same form."""
    if isinstance(one, tuple | list) and isinstance(other, tuple | list):
        return len(one) == len(other) and all(map(same_shape, one, other))
    return is_number(one) and is_number(other)


def mapped(value: Value, function: Callable[[Value, Value], Value], other: Value) -> Value:
    """A function of every number of two values of the same form."""
    if isinstance(value, tuple | list):
        return tuple(mapped(one, function, own) for one, own in zip(value, other, strict=True))
    return function(value, other)


def joint(one: Value, other: Value) -> str:
    """The kind of what is one number or another."""
    kinds = {kind_of(one), kind_of(other)}
    return kinds.pop() if len(kinds) == 1 else "double"


def kind_of(value: Value) -> str:
    """The kind of a number."""
    return value.kind if isinstance(value, Number) else "int" if isinstance(value, int) else "double"


def shape(value: Value, left: list[Number]) -> object:
    """What is known of an argument; numbers of C are put aside."""
    if isinstance(value, Number):
        left.append(value)
        return value.kind, "left"
    if isinstance(value, tuple | list):
        return tuple(shape(one, left) for one in value)
    return type(value).__name__, value


def literal(value: float) -> str:
    """A number as C writes it."""
    number = float(value)
    if math.isnan(number):
        return "NAN"
    if math.isinf(number):
        return "INFINITY" if number > 0.0 else "-INFINITY"
    return repr(number)


def number_of(value: Value, kind: str = "double") -> Number:
    """A value as an expression of C, for arithmetic of that kind."""
    if isinstance(value, Number):
        if kind == "int" and value.kind == "double":
            return Number(f"(int){bracketed(value, 9)}", "int", 8, value.names)
        if kind == "double" and value.kind == "int":
            return Number(f"(double){bracketed(value, 9)}", "double", 8, value.names)
        return value
    if not isinstance(value, bool | int | float):
        raise missing(None, f"{value!r} as a number")
    text = str(int(value)) if kind == "int" else literal(value)
    return Number(text, kind, 7 if text.startswith("-") else 9)


def bracketed(number: Number, rank: int) -> str:
    """The text of a number, in brackets where it is bound less tightly."""
    return number.text if number.rank >= rank else f"({number.text})"


def variables_of(numbers: Iterable[Number]) -> frozenset[str]:
    """The names in numbers."""
    return frozenset(name for own in numbers for name in own.names)


def missing(scope: Scope | None, what: str) -> NoProgramError:
    """The error that C has no counterpart of something."""
    where = f" in {scope.module.name}" if scope else ""
    return NoProgramError(f"C has no counterpart of {what}{where}")
