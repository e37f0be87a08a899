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

Name = tuple[str, str]
"""A module below the package, dotted, and what it calls the thing."""
PLAIN = "_runtime.plain"
"""What stands for NumPy in programs over single numbers; another language has its own."""


class NoProgramError(ValueError):
    """A function is not evaluated by a program over single numbers."""


@dataclass(frozen=True)
class Module:
    """One file of the package, read."""

    name: str
    text: str

    @cached_property
    def bound(self) -> dict[str, ast.stmt]:
        """The functions, classes and constants of the module by name."""
        found: dict[str, ast.stmt] = {}
        for statement in ast.parse(self.text).body:
            if isinstance(statement, ast.FunctionDef | ast.ClassDef):
                found[statement.name] = statement
            elif isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
                found[statement.targets[0].id] = statement
            elif isinstance(statement, ast.AnnAssign) and isinstance(statement.target, ast.Name) and statement.value:
                found[statement.target.id] = statement
        return found

    @cached_property
    def imported(self) -> dict[str, Name]:
        """Where the names come from that it imports: a module and a name in it, or all of a module of Python."""
        package = self.name.split(".")[:-1]
        found: dict[str, Name] = {}
        for node in ast.walk(ast.parse(self.text)):
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

    def program(self, module: str, function: str) -> tuple[Module, ast.FunctionDef]:
        """The program of a public function and its module, without what asks whether its arguments are in its range.

        Raises
        ------
        NoProgramError
            If the function is evaluated over arrays only, or by another function.
        """
        programs = self.module(f"{FOLDER}.{module}")
        found = programs.bound.get(function) if programs else None
        if programs is None or not isinstance(found, ast.FunctionDef):
            message = f"{module}.{function} has no program over single numbers"
            raise NoProgramError(message)
        guarded = next(node for node in ast.walk(found) if isinstance(node, ast.Try))
        body = _unasked(guarded.body)
        if (own := self.body(module, f"_{function}")) is not None:
            # what a program leaves to the arrays is left to its body
            body = [_Otherwise(own).visit(statement) for statement in body]
        return programs, ast.FunctionDef(function, found.args, body, [], None, None)

    def body(self, module: str, name: str) -> ast.FunctionDef | None:
        """The body of a function of a module that its program rests on, over single numbers where there is one."""
        found = (self.module(f"{place}{module}") for place in (f"{BODIES}.", ""))
        own = (home.bound.get(name) for home in found if home)
        return next((one for one in own if isinstance(one, ast.FunctionDef)), None)


def _unasked(body: list[ast.stmt]) -> list[ast.stmt]:
    """Statements that return a value at once, where they ask whether it is in its range."""
    found: list[ast.stmt] = []
    for statement in body:
        match statement:
            case ast.If(_, [ast.Return(ast.Name("value") as value)], []):
                return [*found, ast.Return(value)]
            case ast.If(test, inner, other):
                found.append(ast.If(test, _unasked(inner), _unasked(other)))
            case _:
                found.append(statement)
    return found


class _Otherwise(ast.NodeTransformer):
    """Calls a body where a program gives nothing."""

    def __init__(self, body: ast.FunctionDef) -> None:
        names: list[ast.expr] = [ast.Name(one.arg, ast.Load()) for one in body.args.args]
        self.call = ast.Call(ast.Attribute(ast.Name("bodies", ast.Load()), body.name, ast.Load()), names, [])

    def visit_Return(self, node: ast.Return) -> ast.Return:
        """The statement, with the call for None."""
        nothing = isinstance(node.value, ast.Constant) and node.value.value is None
        return ast.Return(self.call) if nothing else node
