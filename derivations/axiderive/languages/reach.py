"""The functions that a program needs, with the constants and modules these name: what another language is given.

The programs of the package are plain source over single numbers, and all that they call is source too; a name leads to
the statement that binds it.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from ..code.module import PACKAGE
from ..code.programs import FOLDER
from ..code.programs.bodies import BODIES, COUNTERPARTS
from .public import FORMULAS, Domain, Public, domains, evaluated

Name = tuple[str, str]
"""A module below the package, dotted, and what it calls the thing."""
PLAIN = "_runtime.plain"
"""What stands for NumPy in programs over single numbers; another language has its own."""


PRODUCTS = ("_runtime.graded.single", "_pairs")
"""What has the nodes of rules for a power as a weight, from tables of arrays; another language has its own."""


KEPT = frozenset(("cache", "Kept"))
"""Decorators of what is kept for the parameters of the last calls."""
ARRAYS = {
    "_runtime.physics.layer": "a contact with a layer is solved over arrays",
    "_runtime.graded.waves": "waves on a graded half-space are integrated along complex paths",
}
"""Modules without a form over single numbers, and why."""


class NoProgramError(ValueError):
    """A function is not evaluated by a program over single numbers."""


@dataclass(frozen=True)
class Module:
    """One file of the package, read."""

    name: str
    text: str

    @cached_property
    def tree(self) -> ast.Module:
        """Its text, read."""
        return ast.parse(self.text)

    @cached_property
    def bound(self) -> dict[str, ast.stmt]:
        """The functions, classes and constants of the module by name."""
        found: dict[str, ast.stmt] = {}
        for statement in self.tree.body:
            if isinstance(statement, ast.FunctionDef | ast.ClassDef):
                found[statement.name] = statement
            elif isinstance(statement, ast.Assign):
                target, value = statement.targets[0], statement.value
                if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
                    pairs = zip(target.elts, value.elts, strict=True)
                    found |= {one.id: ast.Assign([one], own) for one, own in pairs if isinstance(one, ast.Name)}
                elif isinstance(target, ast.Name):
                    found[target.id] = statement
            elif isinstance(statement, ast.AnnAssign) and isinstance(statement.target, ast.Name) and statement.value:
                found[statement.target.id] = statement
        return found

    @cached_property
    def imported(self) -> dict[str, Name]:
        """Where the names come from that it imports: a module and a name in it, or all of a module of Python."""
        package = self.name.split(".")[:-1]
        found: dict[str, Name] = {}
        for node in ast.walk(self.tree):
            if isinstance(node, ast.ImportFrom):
                base = [*package[: len(package) - node.level + 1]] if node.level else []
                module = ".".join([*base, *filter(None, [node.module])])
                found |= {alias.asname or alias.name: (module, alias.name) for alias in node.names}
            elif isinstance(node, ast.Import):
                found |= {alias.asname or alias.name: (alias.name, "") for alias in node.names}
        return found


@dataclass
class Package:
    """The modules of the package by dotted name, read when they are asked for."""

    texts: Mapping[str, str]
    """Their sources by path below the catalogue."""
    domains: Mapping[str, Domain] = field(default_factory=dict)
    """Of parameters that the tables of the run time do not know."""
    read: dict[str, Module] = field(default_factory=dict)

    def module(self, name: str) -> Module | None:
        """The module of a dotted name below the package; None for what is none."""
        if name not in self.read:
            path = f"{PACKAGE}/{name.replace('.', '/')}"
            text = self.texts.get(f"{path}.py", self.texts.get(f"{path}/__init__.py"))
            if text is None:
                return None
            self.read[name] = Module(name, text)
        return self.read[name]

    def resolved(self, module: str, name: str) -> Name | None:
        """Where a name of a module is bound: in itself or in another; (module, "") for a whole module.

        None for a name of Python itself.
        """
        own = self.module(module)
        if own is None:
            return module, name
        if name in own.bound:
            return module, name
        if name not in own.imported:
            return None
        home, there = own.imported[name]
        for single in (COUNTERPARTS.get(home, ""), f"{BODIES}.{home}"):
            # over single numbers, where a formula was written for arrays
            if single != module and there in (found.bound if (found := self.module(single)) else ()):
                return self.resolved(single, there)
        if there and self.module(f"{home}.{there}"):
            return f"{home}.{there}", ""
        return self.resolved(home, there) if self.module(home) else (home, there)

    def bound(self, module: Module, name: str) -> ast.stmt:
        """What a module binds to a name; a public function as it is over single numbers.

        Raises
        ------
        NoProgramError
            If the module has no form over single numbers.
        """
        if module.name in ARRAYS:
            raise NoProgramError(ARRAYS[module.name])
        node = module.bound[name]
        if not isinstance(node, ast.FunctionDef) or "__all__" not in module.bound:
            return node
        return Public(module.name, self.resolved, self._function, self._domains).function(node)

    def program(self, module: str, function: str) -> tuple[Module, ast.FunctionDef]:
        """A public function and its module.

        Raises
        ------
        NoProgramError
            If there is none of that name.
        """
        home = self.module(module)
        if home is None or not isinstance(home.bound.get(function), ast.FunctionDef):
            message = f"{module} has no function {function}"
            raise NoProgramError(message)
        node = self.bound(home, function)
        assert isinstance(node, ast.FunctionDef)
        return home, node

    def arguments(self, module: str, function: str) -> list[str]:
        """The names of the arguments of a public function, in their order."""
        own = self.program(module, function)[1].args
        return [one.arg for one in (*own.args, *own.kwonlyargs)]

    def formula(self, place: str, name: str) -> tuple[Module, ast.FunctionDef]:
        """A formula and its module: its body over single numbers, and before that its program where one is asked for.

        `place` is the module that states it, behind PROGRAMS or FORMULAS.
        """
        kind, _, home = place.partition(":")
        module, body = self._body(home, name)
        programs = self.module(f"{FOLDER}.{home}")
        program = programs.bound.get(name.removeprefix("_")) if programs else None
        if kind == FORMULAS[:-1] or programs is None or not isinstance(program, ast.FunctionDef):
            return module, body
        both = evaluated(program, body, home)
        return (programs, both) if both else (module, body)

    def _body(self, home: str, name: str) -> tuple[Module, ast.FunctionDef]:
        for place in (f"{BODIES}.", ""):
            module = self.module(f"{place}{home}")
            node = module.bound.get(name) if module else None
            if module and isinstance(node, ast.FunctionDef):
                return module, node
        message = f"{home} has no formula {name}"
        raise NoProgramError(message)

    def _function(self, module: str, name: str) -> ast.stmt | None:
        home = self.module(module)
        return home.bound.get(name) if home else None

    @cached_property
    def _domains(self) -> dict[str, Domain]:
        tables = [self._function(f"_runtime.{home}", name) for home, name in
                  (("intervals", "INSIDE"), ("symbols", "SYMBOLS"))]  # fmt: skip
        first, second = (table.value for table in tables if isinstance(table, ast.Assign))
        return {**domains(first, second), **self.domains}
