"""A self-contained module out of generated ones: what the wanted functions reach, frozen parameters as constants."""

from __future__ import annotations

import ast
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from ...code.module import PLACE
from .binding import bind
from .inlining import inline
from .library import Module, Program, bound, calls, parameters, references
from .written import class_text, constant_text, function_head, function_text

OWN = "scene"
"""Module of functions that are written for the scene: they keep their names."""
SHARED = {
    "_runtime.integrals:integral": "_integral",
    "_runtime.nodes:_LOWER_HALVES": "_NODES",
}
"""Names of what is written anew for a scene, in fewer lines."""
WRITTEN = {*SHARED.values(), "_bare", "_elementwise", "_require", "_DOMAINS", "_UNITS"}


@dataclass(frozen=True)
class Wanted:
    """A function of the interface: the private function behind it, its name, fields, keywords and docstring."""

    key: str
    name: str
    fields: tuple[str, ...]
    keywords: tuple[str, ...]
    doc: str
    signed: bool = False
    """Whether a field may be negative."""
    parity: str = ""
    """Whether it is even or odd in its first field."""


class Linker:
    """The reachable definitions with the parameters that are left to each one, and the names they get.

    Of the `frozen` parameters no line needs to ask whether those that are `positive` are above zero; `roots` are
    wanted for themselves, with names of their own.
    """

    def __init__(
        self, modules: Mapping[str, Module], wanted: Sequence[Wanted], frozen: frozenset[str],
        positive: frozenset[str] = frozenset(), roots: Sequence[str] = (),
    ) -> None:  # fmt: skip
        self.wanted, self.frozen, self.roots = wanted, frozen, roots
        self.program = Program(modules, [*(w.key for w in wanted), *roots], frozenset(SHARED))
        bind(self.program, frozen, positive)
        self.merged = {w.key for w in wanted if self._merged(w)}
        names = [*self.program.trees]
        inline(self.program, frozen)
        functions = self.program.functions
        for node in functions.values():
            _Shortened(functions).visit(node)
        self.names = self._named(names) | SHARED

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
        return plain and not shadowed and wanted.key not in self.roots

    def _named(self, keys: Sequence[str]) -> dict[str, str]:
        names = {w.key: w.name for w in self.wanted if w.key in self.merged}
        names |= {key: key.partition(":")[2] for key in self.roots if key.startswith(f"{OWN}:")}
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
