"""Statements: branches and loops that are known are written out, the others are those of C."""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from ..reach import PLAIN, NoProgramError
from .lines import declared, inside
from .values import (
    Closure,
    Counted,
    Growing,
    Number,
    Over,
    Record,
    Scope,
    SeveralValuesError,
    Text,
    Value,
    is_number,
    kind_of,
    mapped,
    missing,
    names_of,
    number_of,
)
from .walks import Found, Walks

SPELLED = 32
"""Turns of a loop that are written out, at most."""


class Writer(Walks):
    """Writes one function of C."""

    def whole(self, closure: Closure, given: Sequence[Value], name: str, returns: str, part: str = "") -> Text:
        """The text of a function with as many arguments as there are numbers of C among those given.

        Of a record that it gives the number is a `part`.
        """
        self.part = part
        assert isinstance(closure.node, ast.FunctionDef)
        letters: list[Number] = []

        def letter(argument: str, value: Value) -> Value:
            if isinstance(value, tuple | list):
                return type(value)(letter(f"{argument}_{place}", one) for place, one in enumerate(value, 1))
            if isinstance(value, Number):
                letters.append(replace(self.variable(argument, "argument"), kind=value.kind))
                return letters[-1]
            return value

        names = {own: letter(own, value) for own, value in zip(names_of(closure.node.args), given, strict=True)}
        scope = Scope(closure.module, names=names, alone=True)
        try:
            self.block(closure.node.body, scope)
        except Over:
            pass
        else:
            raise missing(scope, f"{name} without a result")
        kept = self._needed()
        needs = frozenset(need for _, _, own, needs in kept for need in (*needs, *([own] if own else [])))
        kinds = {own: kind for own, kind in self.kinds.items() if own in needs and kind != "argument"}
        variables = [f"  {declared(kind, own)};" for own, kind in kinds.items()]
        unused = [f"  (void){own.text};" for own in letters if own.text not in needs]
        body = [f"{'  ' * depth}{text}" for depth, text, _, _ in kept]
        arguments = tuple(f"{own.kind} {own.text}" for own in letters)
        head = f"{returns} {name}({', '.join(arguments) or 'void'})"
        return Text("\n".join([head, "{", *variables, *unused, *body, "}", ""]), needs, arguments)

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
        except Over:
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
            case ast.AnnAssign(target, _, ast.expr() as value):
                self.assign(target, self.expr(value, scope), scope)
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
            case ast.Try(body, [handler]):
                self._either(body, handler.body, scope)
            case ast.Raise():
                # panels that Python leaves to the arrays are summed here
                if scope.module.name != PLAIN:
                    self._return(scope, math.nan)
            case _:
                raise missing(scope, ast.unparse(node))

    def _either(self, body: Sequence[ast.stmt], otherwise: Sequence[ast.stmt], scope: Scope) -> None:
        """Statements, or others where C has no counterpart of those."""
        lines, depth, inlined, divided, names = list(self.lines), self.depth, self.inlined, scope.divided, scope.names
        scope.names = dict(names)
        try:
            self.block(body, scope)
        except NoProgramError:
            self.lines, self.depth, self.inlined, scope.divided, scope.names = lines, depth, inlined, divided, names
            self.block(otherwise, scope)

    def _leave(self, label: str, otherwise: str) -> None:
        self.emit(f"goto {label};" if label else otherwise, None, [label] if label else [])
        raise Over

    def assign(self, target: ast.expr, value: Value, scope: Scope) -> None:
        """What stands left of an equals sign gets a value."""
        match target:
            case ast.Name(name):
                self.bind(scope, name, value)
            case ast.Tuple(targets) | ast.List(targets):
                items = self._items(value, scope)
                rest = targets[-1]
                if isinstance(rest, ast.Starred):
                    targets = targets[:-1]
                    self.assign(rest.value, tuple(items[len(targets) :]), scope)
                    items = items[: len(targets)]
                held = self._held(targets, items, scope)
                for one, own in zip(targets, held, strict=True):
                    self.assign(one, own, scope)
            case _:
                raise missing(scope, ast.unparse(target))

    def _held(self, targets: Sequence[ast.expr], values: Sequence[Value], scope: Scope) -> list[Value]:
        """The values, those aside that rest on what is assigned before them."""
        changed, held = set[str](), list[Value]()
        for target, value in zip(targets, values, strict=True):
            if isinstance(value, Number) and value.names & changed:
                own = self.variable("held", value.kind)
                self.set(own, value)
                value = own
            held.append(value)
            old = scope.names.get(target.id) if isinstance(target, ast.Name) else None
            changed |= old.names if isinstance(old, Number) else set()
        return held

    def _append(self, scope: Scope, name: str, value: Value) -> None:
        if name not in scope.names:
            self._append_outside(scope, name, value)
            return
        known = scope.names[name]
        if isinstance(known, list) and not scope.divided:
            known.append(value)
            return
        if not (isinstance(known, Number) and known.kind == "sum"):
            raise missing(scope, f"{name}.append")
        self.add_to(known, value)

    def _append_outside(self, scope: Scope, name: str, value: Value) -> None:
        """What a function leaves in a list of the one around it, of which that may ask for the last two items."""
        home = scope.around
        while home is not None and name not in home.names:
            home = home.around
        known = home.names[name] if home else None
        if not isinstance(known, Growing) or known:
            raise missing(scope, f"{name}.append")
        if known.last is None:
            known.before, known.last = (
                mapped(value, lambda one, _: self.variable(own, kind_of(one)), value)  # noqa: B023 - called at once
                for own in (f"{name}_before", name)
            )
        mapped(known.before, self.set, known.last)
        mapped(known.last, self.set, value)
        self.emit(f"if (!{known.filled.text}) {{", None, known.filled.names)
        self.depth += 1
        mapped(known.before, self.set, known.last)
        self.depth -= 1
        self.emit("}")
        self.set(known.filled, 1)

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
            raise Over

    def _for(self, target: ast.expr, iterated: Value, body: Sequence[ast.stmt], scope: Scope) -> None:
        if isinstance(iterated, Number) and iterated.kind == "pairs":
            self.divide(scope, body, loop=True)
            node, weight = self._start_rule(iterated)
            self._loop(body, scope, lambda: self.assign(target, (node, weight), scope))
        elif isinstance(iterated, Found):
            self.divide(scope, body, loop=True)
            scope.loops.append("")
            self.each_branch(iterated, scope, lambda *ends: self._look(target, ends, body, scope))
            scope.loops.pop()
        elif isinstance(iterated, Counted) or (isinstance(iterated, range) and len(iterated) > SPELLED):
            self.divide(scope, body, loop=True)
            own = self.variable(ast.unparse(target), "int")
            start, stop = number_of(iterated.start, "int"), number_of(iterated.stop, "int")
            sign = "<" if iterated.step > 0 else ">"
            step = f"{own.text} += {iterated.step}"
            head = f"for ({own.text} = {start.text}; {own.text} {sign} {stop.text}; {step}) {{"
            self.emit(head, None, own.names | start.names | stop.names)
            self._loop(body, scope, lambda: self.assign(target, own, scope))
        else:
            self._turns(target, self._items(iterated, scope), body, scope)

    def _look(self, target: ast.expr, ends: tuple[Number, ...], body: Sequence[ast.stmt], scope: Scope) -> None:
        self.assign(target, ends, scope)
        self.block(body, scope)

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
        left = any(isinstance(one, ast.Break) for node in body for one in inside(node))
        label = self._label("done") if left else ""
        if left:
            self.divide(scope, body)
            scope.divided += 1
        scope.loops.append(label)
        try:
            for item in items:
                self.assign(target, item, scope)
                self.block(body, scope)
        except Over:
            if not left:
                raise
        finally:
            scope.loops.pop()
            scope.divided -= left
        self._place(label)

    def _return(self, scope: Scope, value: Value) -> None:
        if scope.alone:
            number = self._single(value.fields.get(self.part) if isinstance(value, Record) else value)
            self.emit(f"return {number.text};", None, number.names)
        elif scope.divided or scope.result is not None:
            scope.result = self._joined(scope, value)
            self._leave(scope.end, "")
        else:
            scope.result = value
        raise Over

    @staticmethod
    def _single(value: Value) -> Number:
        if not is_number(value) or (isinstance(value, Number) and value.kind in ("pairs", "sum")):
            raise SeveralValuesError
        return number_of(value)

    def _joined(self, scope: Scope, value: Value) -> Value:
        """The variables in which a function that returns at several places leaves what it gives."""

        def joined(known: Value, one: Value) -> Value:
            if isinstance(one, tuple | list):
                knowns = known if known is not None else [None] * len(one)
                return type(one)(map(joined, knowns, one))
            if not is_number(one):
                if known is not None and known != one:
                    raise missing(scope, "a function that gives one thing or another")
                return one
            if known is None:
                kind = one.kind if isinstance(one, Number) else "double"
                known = self.variable("result", "double" if kind == "int" else kind)
            self.set(known, one)
            return known

        return joined(scope.result, value)
