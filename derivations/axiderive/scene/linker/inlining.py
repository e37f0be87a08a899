"""Functions that are written where they are called: used once, straight lines, plain names as arguments."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from .library import (
    Program,
    arguments,
    bound,
    calls,
    documentation,
    is_comment,
    loaded,
    parameters,
    references,
    source,
    stored,
)

WIDTH, KEYS = 107, re.compile(r"[\w.]+:(?=\w)")


class Exchanged(ast.NodeTransformer):
    """Other expressions in the place of some."""

    def __init__(self, others: Mapping[ast.AST, ast.expr]) -> None:
        self.others = others

    def visit(self, node: ast.AST) -> ast.AST:
        return self.others.get(node) or super().visit(node)


class _Renamed(ast.NodeTransformer):
    def __init__(self, names: Mapping[str, str]) -> None:
        self.names = names

    def visit_Name(self, node: ast.Name) -> ast.Name:
        return ast.Name(self.names.get(node.id, node.id), node.ctx)


@dataclass
class _Site:
    """The one place where a function is used."""

    owner: ast.FunctionDef
    call: ast.Call

    @property
    def statement(self) -> ast.stmt:
        """The statement of the owner that holds it."""
        return next(s for s in self.owner.body if any(node is self.call for node in ast.walk(s)))

    def fits(self, value: ast.expr) -> bool:
        """Whether a value fits on the line in the place of the call."""
        inside = (s for s in ast.walk(self.statement) if isinstance(s, ast.stmt))
        *outer, line = [s for s in inside if any(node is self.call for node in ast.walk(s))]
        whole, part, new = (len(KEYS.sub("", source(node))) for node in (line, self.call, value))
        return 4 * len(outer) + whole - part + new <= WIDTH

    @property
    def straight(self) -> bool:
        """Whether the call stands in a simple statement of the function itself, so that lines can go before it."""
        own = self.statement
        scopes = (s for s in ast.walk(own) if isinstance(s, (ast.Lambda, ast.GeneratorExp, ast.IfExp)))
        simple = isinstance(own, (ast.Assign, ast.Return))
        return simple and not any(node is self.call for scope in scopes for node in ast.walk(scope))


def inline(program: Program, frozen: frozenset[str]) -> None:
    """Write functions out where they are called; `frozen` are the names of constants that all of them know."""
    uses = Counter(name.id for node in program.trees.values() for name in references(node))
    for key, count in uses.items():
        callee = program.functions.get(key)
        site = next(_sites(program, key), None)
        if callee is None or key in program.wanted or count > 1 or site is None or site.owner is callee:
            continue
        lines = _lines(callee)
        if lines is None or not _means_the_same(site, callee, frozen):
            continue
        name = "" if site.fits(_value(callee)) else f"plain_{key.partition(':')[2].lstrip('_')}"
        if (lines or name) and not site.straight or name in bound(site.owner):
            continue
        _write(site, callee, lines, name)
        del program.trees[key]


def _value(function: ast.FunctionDef) -> ast.expr:
    """What a function returns at its end."""
    last = function.body[-1]
    assert isinstance(last, ast.Return) and last.value is not None
    return last.value


def _sites(program: Program, key: str) -> Iterator[_Site]:
    for owner in program.functions.values():
        yield from (_Site(owner, call) for call, called in calls(owner) if called == key)


def _lines(function: ast.FunctionDef) -> list[ast.stmt] | None:
    """The assignments, also under conditions, of a function that is nothing else but what it returns."""
    *body, last = function.body[1:] if documentation(function) else function.body
    return body if isinstance(last, ast.Return) and last.value and all(map(_assigns, body)) else None


def _assigns(statement: ast.stmt) -> bool:
    if isinstance(statement, ast.If):
        return all(_assigns(s) for s in (*statement.body, *statement.orelse))
    return isinstance(statement, ast.Assign) or is_comment(statement)


def _means_the_same(site: _Site, callee: ast.FunctionDef, frozen: frozenset[str]) -> bool:
    """Whether the lines mean the same in the place of the call, with its arguments for the parameters."""
    taken, own, outer = set(parameters(callee)), bound(callee), bound(site.owner)
    given = arguments(site.call, parameters(callee))
    if not all(isinstance(given.get(name), ast.Name) for name in taken) or stored(callee) & taken:
        return False
    free = {n.id.rpartition(":")[2] for n in ast.walk(callee) if isinstance(n, ast.Name)} - own
    return not (own - taken) & outer and not free & (outer - frozen)


def _write(site: _Site, callee: ast.FunctionDef, lines: Sequence[ast.stmt], name: str) -> None:
    given = arguments(site.call, parameters(callee))
    renamed = _Renamed({p: value.id for p, value in given.items() if isinstance(value, ast.Name)})
    before = [renamed.visit(line) for line in lines]
    value: ast.expr = renamed.visit(_value(callee))
    if name:
        before.append(ast.Assign(targets=[ast.Name(name, ast.Store())], value=value))
        value = loaded(name)
    place = site.owner.body.index(site.statement)
    Exchanged({site.call: value}).visit(site.owner)
    site.owner.body[place:place] = before
