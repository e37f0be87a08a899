"""The lines and variables of a function of C."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Sequence
from itertools import count
from typing import TYPE_CHECKING

from .natives import word
from .values import Growing, Number, Scope, Value, is_number, leaves, missing, number_of

if TYPE_CHECKING:
    from .file import File


class Lines:
    """Collects what is written."""

    def __init__(self, file: File) -> None:
        self.file = file
        self.lines: list[tuple[int, str, str | None, frozenset[str]]] = []
        """Of each line its depth, text, the variable that it sets, and those that it needs."""
        self.kinds: dict[str, str] = {}
        self.depth, self.inlined, self.labels = 1, 0, 0

    def emit(self, text: str, sets: str | None = None, needs: Iterable[str] = ()) -> None:
        """A line of the function."""
        self.lines.append((self.depth, text, sets, frozenset(needs)))

    def variable(self, name: str, kind: str) -> Number:
        """A variable of C of that name, or of one like it where another is there."""
        plain = word(name)
        own = next(one for one in like(plain) if one not in self.kinds and one not in self.file.written)
        self.kinds[own] = kind
        self.file.variables.add(own)
        return Number(own, kind, 9, frozenset((own,)))

    def set(self, target: Number, value: Value) -> None:
        """A variable gets a value."""
        number = number_of(value, target.kind)
        if number.text != target.text:
            self.emit(f"{target.text} = {number.text};", target.text, number.names)

    def bind(self, scope: Scope, name: str, value: Value) -> None:
        """A name of Python gets a value; numbers of C are kept in a variable of that name."""
        if value == []:
            value = Growing(self.variable(f"{name}_filled", "int"))
            self.set(value.filled, 0)
        old = scope.names.get(name)
        scope.names[name] = self._kept(name, value, old if scope.divided else None, scope)

    def _kept(self, name: str, value: Value, old: Value, scope: Scope) -> Value:
        if isinstance(value, tuple | list) and any(map(is_number, leaves(value))):
            olds = old if isinstance(old, tuple | list) and len(old) == len(value) else [None] * len(value)
            kept = [self._kept(name, one, before, scope) for one, before in zip(value, olds, strict=True)]
            return kept if isinstance(value, list) else tuple(kept)
        if not is_number(value) or (isinstance(value, bool | int | float) and not scope.divided):
            if scope.divided and old is not None and old is not value and old != value:
                raise missing(scope, f"{name}, which is one thing or another")
            return value
        kind = value.kind if isinstance(value, Number) else "int" if isinstance(value, bool) else "double"
        if isinstance(old, Number) and old.kind in ("int", "double"):
            if old.kind != kind and "double" not in (old.kind,):
                raise missing(scope, f"{name}, a number of two kinds")
            self.set(old, value)
            return old
        own = self.variable(name, kind)
        self.set(own, value)
        return own

    def add_to(self, total: Number, value: Value) -> None:
        """A term for an exact sum."""
        number = number_of(value)
        self.emit(f"sum_add(&{total.text}, {number.text});", None, total.names | number.names)

    def divide(self, scope: Scope, body: Sequence[ast.stmt], loop: bool = False) -> None:
        """Make variables of what is known in front of a branch or a loop, and may change in it."""
        stored = {one.id for node in body for one in inside(node) if isinstance(one, ast.Name)
                  and isinstance(one.ctx, ast.Store)}  # fmt: skip
        loops = body if loop else [one for node in body for one in inside(node) if isinstance(one, ast.For)]
        grown = {call.func.value.id for node in loops for call in inside(node) if isinstance(call, ast.Call)
                 and isinstance(call.func, ast.Attribute) and call.func.attr == "append"
                 and isinstance(call.func.value, ast.Name)}  # fmt: skip
        for name in sorted(stored & scope.names.keys()):
            scope.names[name] = self._variables(name, scope.names[name])
        for name in sorted(grown & scope.names.keys()):
            if scope.names[name] == []:
                scope.names[name] = total = self.variable(name, "sum")
                self.emit(f"{total.text}.high = {total.text}.low = 0.0;", None, total.names)

    def _variables(self, name: str, value: Value) -> Value:
        if isinstance(value, tuple | list):
            return type(value)(self._variables(name, one) for one in value)
        if not isinstance(value, bool | int | float):
            return value
        own = self.variable(name, "int" if isinstance(value, bool) else "double")
        self.set(own, value)
        return own

    def _label(self, name: str) -> str:
        self.labels += 1
        return f"to_{name}_{self.labels}"

    def _place(self, label: str) -> None:
        if label and any(label in needs for _, _, _, needs in self.lines):
            self.emit(f"{label}:;")

    def _needed(self) -> list[tuple[int, str, str | None, frozenset[str]]]:
        """The lines without those that set what nothing reads."""
        lines = self.lines
        while True:
            read = {name for _, _, own, needs in lines for name in needs if name != own}
            kept = [line for line in lines if line[2] is None or line[2] in read]
            if len(kept) == len(lines):
                return kept
            lines = kept


def like(name: str) -> Iterator[str]:
    """A name, and with a number behind it."""
    yield name
    yield from (f"{name}_{number}" for number in count(2))


def declared(kind: str, name: str) -> str:
    """The declaration of a variable of a kind."""
    kind, _, count = kind.partition(" ")
    own = {
        "sum": f"struct sum {name}", "pairs": f"struct pairs {name}", "weights": f"KEPT struct products {name} = {{0}}",
        "kept": f"KEPT double {name}[{count}] = {{0}}" if count else f"KEPT int {name} = 0",
    }  # fmt: skip
    return own.get(kind, f"{kind} {name} = 0")


def inside(node: ast.AST) -> Iterator[ast.AST]:
    """A statement and what is in it, without functions of its own."""
    yield node
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, ast.FunctionDef | ast.Lambda | ast.ListComp | ast.GeneratorExp):
            yield from inside(child)
