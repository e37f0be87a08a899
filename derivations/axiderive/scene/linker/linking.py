"""A self-contained module out of generated ones: what the wanted functions reach, frozen parameters as constants.

Functions are written where they are called if they are used once, straight lines, with plain names as arguments.
"""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass

from ...code.module import PLACE
from .binding import bind
from .library import (
    Module,
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
from .written import class_text, constant_text, function_head, function_text

OWN = "scene"
"""Module of functions that are written for the scene: they keep their names."""
SHARED = {
    "_runtime.integrals:integral": "_integral",
    "_runtime.nodes:_LOWER_HALVES": "_NODES",
    "_runtime.interface:numbers": "_bare",
}
"""Names of what is written anew for a scene, in fewer lines."""
WRITTEN = {*SHARED.values(), "_bare", "_elementwise", "_require", "_DOMAINS", "_UNITS"}


@dataclass(frozen=True)
class Wanted:
    """A function of the interface: what stands behind it, its name, docstring and keywords."""

    key: str
    name: str
    doc: str
    keywords: tuple[str, ...]
    fields: tuple[str, ...] = ()
    """What it takes in arrays; without any it is written for the scene and has one result."""
    leading: str = ""
    """Arguments in front of the keywords where there are no fields."""
    signed: bool = False
    """Whether a field may be negative."""
    parity: str = ""
    """Whether it is even or odd in its first field."""
    whole: bool = False
    """Whether it goes over arrays by itself, and has several results."""

    @property
    def elementwise(self) -> bool:
        """Whether it is a formula for each number of its fields."""
        return bool(self.fields) and not self.whole


class Linker:
    """The reachable definitions with the parameters that are left to each one, and the names they get.

    Of the `frozen` parameters no line needs to ask whether those that are `positive` are above zero.  What is written
    for the scene is there for itself.
    """

    def __init__(
        self, modules: Mapping[str, Module], wanted: Sequence[Wanted], frozen: frozenset[str], positive: frozenset[str]
    ) -> None:
        self.wanted, self.frozen = wanted, frozen
        written = [f"{OWN}:{name}" for name in modules[OWN].definitions]
        self.program = Program(modules, [*(w.key for w in wanted), *written], frozenset(SHARED))
        bind(self.program, frozen, positive)
        self.merged = {w.key for w in wanted if w.elementwise and self._merged(w)}
        names = [*self.program.trees]
        inline(self.program, frozen)
        functions = self.program.functions
        for node in functions.values():
            _Shortened(functions).visit(node)
        self.names = self._named(names) | SHARED

    @property
    def decorators(self) -> list[str]:
        """Functions that stand above others as a mark, and so have to be known before them."""
        functions = self.program.functions
        names = (name.id for node in functions.values() for mark in node.decorator_list for name in references(mark))
        return [*dict.fromkeys(name for name in names if name in functions)]

    def _merged(self, wanted: Wanted) -> bool:
        """Whether the private function itself can be the public one: it takes the fields and nothing else."""
        trees = self.program.trees
        shadowed = any(
            wanted.name in bound(node) and any(name.id == wanted.key for name in references(node))
            for node in self.program.functions.values()
        )
        handed_on = any(
            name.id == wanted.key and id(name) not in {id(call.func) for call, _ in calls(node)}
            for node in trees.values() for name in references(node)
        )  # fmt: skip
        plain = parameters(trees[wanted.key]) == [*wanted.fields] and not handed_on
        return plain and not shadowed

    def _named(self, keys: Sequence[str]) -> dict[str, str]:
        names = {w.key: w.name for w in self.wanted if w.key in self.merged or not w.elementwise}
        taken = {w.name for w in self.wanted} | self.frozen | WRITTEN
        for key in keys:
            if key not in names:
                module, _, own = key.partition(":")
                stem = own.lstrip("_")
                name = stem if stem[0].isupper() and stem not in taken else f"_{stem}"
                names[key] = f"_{_group(module)}_{stem}" if name in taken else name
                taken.add(names[key])
        return names

    def text(self, key: str, doc: str = "", head: Sequence[str] = ()) -> str:
        """The text of a definition; `doc` replaces a docstring, `head` the line of `def`."""
        node, name = self.program.trees[key], self.names[key]
        match node:
            case ast.FunctionDef():
                return function_text(head or function_head(name, node, self.names), node, self.names, doc)
            case ast.ClassDef():
                return class_text(name, node, self.names)
        assert isinstance(node, ast.Assign)
        return "\n".join([*self.program.remarks[key], constant_text(name, node.value, self.names)])


class _Shortened(ast.NodeTransformer):
    """A function for `lambda t: _slope(t)`."""

    def __init__(self, functions: Collection[str]) -> None:
        self.functions = functions

    def visit_Lambda(self, node: ast.Lambda) -> ast.AST:
        """The function, if it is handed what the lambda takes."""
        self.generic_visit(node)
        match node.body:
            case ast.Call(func=ast.Name(id=key) as function, args=given, keywords=[]) if key in self.functions:
                return function if [*map(ast.unparse, given)] == [arg.arg for arg in node.args.args] else node
        return node


def _group(module: str) -> str:
    """What tells functions of one name apart: their file of the run time, or the package of a module."""
    file = module.removeprefix(f"{PLACE}.").removeprefix("physics.").removeprefix("shapes.")
    group = module.rpartition(".")[0] if file == module != OWN else file
    return group.replace(".", "_")


INNER = (ast.Lambda, ast.IfExp, ast.GeneratorExp, ast.ListComp, ast.SetComp, ast.DictComp)
"""Expressions that have names of their own, or of which a part is not evaluated."""
WIDTH, KEYS = 107, re.compile(r"[\w.]+:(?=\w)")


class Exchanged(ast.NodeTransformer):
    """Other expressions in the place of some."""

    def __init__(self, others: Mapping[ast.AST, ast.expr]) -> None:
        self.others = others

    def visit(self, node: ast.AST) -> ast.AST:
        """The other expression, if there is one."""
        return self.others.get(node) or super().visit(node)


class _Renamed(ast.NodeTransformer):
    def __init__(self, names: Mapping[str, str]) -> None:
        self.names = names

    def visit_Name(self, node: ast.Name) -> ast.Name:
        """Another name."""
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
        scopes = (s for s in ast.walk(own) if isinstance(s, INNER))
        simple = isinstance(own, (ast.Assign, ast.Return))
        return simple and not any(node is self.call for scope in scopes for node in ast.walk(scope))


def inline(program: Program, frozen: frozenset[str]) -> None:
    """Write functions out where they are called; `frozen` are the names of constants that all of them know."""
    uses = Counter(name.id for node in program.trees.values() for name in references(node))
    for key, count in uses.items():
        callee = program.functions.get(key)
        # whose decorators do more than its lines
        if callee is None or key in program.wanted or count > 1 or callee.decorator_list:
            continue
        lines, site = _lines(callee), next(_sites(program, key), None)
        if lines is None or site is None or site.owner is callee or not _means_the_same(site, callee, frozen):
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
