"""Bodies that iterate or integrate, over plain numbers: the same with `math` under NumPy's names for `np`.

What a body calls of the package is taken along, as a flat function where it has a graph; constants and classes stay
where they are.  A body that needs nodes along an axis, or anything else that only arrays have, has no such twin.
"""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from dis import get_instructions
from functools import cache
from importlib import import_module
from inspect import unwrap
from types import CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

from .graph import Lengths, Node, trace
from .plain import Lines

OF_MATH = frozenset(name for name in dir(math) if not name.startswith("_"))
WITHOUT_ERRORS = frozenset(("sqrt", "log", "log1p"))
"""Functions of `math` that are not a number outside their domain, under the same names."""
NUMBERS = frozenset(("Array", "Array | float", "float"))
"""Annotations of arguments that are numbers."""
RESULTS = frozenset(("Array", "tuple[Array, Array]"))
"""Annotations of results that are one number or two."""
NEEDS_ARRAYS = frozenset(("gauss_legendre",))
"""Names that a body may not refer to: nodes along an axis."""
COUNTERPARTS = {
    "_runtime.integrals": "_runtime.plain",
    "_runtime.functions": "_runtime.plain",
    "_runtime.physics.branches": "_runtime.physics.single",
    "_runtime.physics.cohesive": "_runtime.plain",
    "_runtime.physics.relaxation": "_runtime.physics.single",
    "_runtime.graded.rules": "_runtime.graded.single",
    "_runtime.graded.waves": "_runtime.graded.single",
}
"""Modules of which another one has functions of the same name for plain numbers."""
RULES = ("_runtime.integrals", "_runtime.graded.rules")
"""Those of which these are rules of integration."""
BODIES = "_programs.bodies"
LONGEST = 100
"""Digits of constants that are written again."""
CALLED = r"(?<![\w.])(?:(\w+)(?=\()|(inf|nan)\b)"
"""Names of a flat function that are functions or numbers of `math`."""
HEAD = '"""Bodies of {title} over plain numbers: the same with `math` for NumPy."""\n\n'


@dataclass
class Twin:
    """What is taken along of one module."""

    functions: dict[str, FunctionType] = field(default_factory=dict)
    imports: dict[str, set[str]] = field(default_factory=dict)
    """Names by the module they are imported from."""
    modules: dict[str, str] = field(default_factory=dict)
    """Modules of the package by the name they go by."""
    others: set[str] = field(default_factory=set)
    """Modules of other packages."""
    constants: dict[str, str] = field(default_factory=dict)
    """Short numbers by name: to import their module would take longer than most calls."""
    rules: dict[Lengths, str] = field(default_factory=dict)
    """Names of rules of integration by the lengths of their intervals."""


class Twins:
    """The twins of a package's bodies; `texts` holds the sources of its modules by dotted name below the package."""

    def __init__(self, package: str, texts: Mapping[str, str]) -> None:
        self.package, self.texts = package, texts
        self.found: dict[str, Twin] = {}
        self.math = import_module(f"{package}._runtime.plain").MATH
        self._needy: dict[FunctionType, bool] = {}
        self._graphs: dict[FunctionType, Node | None] = {}
        self._integrating: dict[FunctionType, bool] = {}

    def add(self, function: FunctionType) -> bool:
        """Take a function along with all it calls; False, and nothing is taken, if it needs arrays."""
        if self.needs_arrays(function):
            return False
        pending = [function]
        while pending:
            own = pending.pop()
            twin = self.found.setdefault(self._module(own), Twin())
            if own.__name__ not in twin.functions:
                twin.functions[own.__name__] = own
                pending += self._taken(own, twin) if self._graph(own) is None else ()
        return True

    def _graph(self, function: FunctionType) -> Node | None:
        """The result of a function of numbers alone, if it has a graph that always holds."""
        if function not in self._graphs:
            *given, result = [*function.__annotations__.items()] or [("return", "")]
            flat = result[1] in RESULTS and NUMBERS.issuperset(kind for _, kind in given)
            found = trace(function, dict(given), ()) if flat and not self._decorators(function) else None
            self._graphs[function] = None if found is None or found.name == "unless" else found
        return self._graphs[function]

    def needs_arrays(self, function: FunctionType) -> bool:
        """Whether a body, or one that it calls, needs nodes along an axis or what only arrays have."""
        seen = set[FunctionType]()
        if not self._needs_arrays(function, seen):
            self._needy |= dict.fromkeys(seen, False)  # no earlier: some may have been left out to close a circle
        return self._needy[function]

    def _module(self, function: Any) -> str:
        """The dotted name of the module of a function, below the package."""
        return str(function.__module__).removeprefix(f"{self.package}.")

    def _taken(self, function: FunctionType, twin: Twin) -> Iterator[FunctionType]:
        """What else has to be taken along for a function; what it imports is noted in the twin."""
        space, own = function.__globals__, self._module(function)
        yield from filter(None, map(self._body, self._late(function).values()))
        for name in sorted(_globals(function.__code__) | self._decorators(function)):
            value: Any = space.get(name)
            if name not in space or value is np:
                continue
            inner = self._body(value)
            if counterpart := self._counterpart(value):
                twin.imports.setdefault(counterpart, set()).add(name)
            elif inner is not None:
                yield inner
                if self._module(inner) != own or inner.__name__ != name:
                    taken = name if inner.__name__ == name else f"{inner.__name__} as {name}"
                    twin.imports.setdefault(f"{BODIES}.{self._module(inner)}", set()).add(taken)
            elif self._is_own(value, ModuleType):
                twin.modules[name] = value.__name__.removeprefix(f"{self.package}.")
                yield from filter(None, [self._body(getattr(value, a)) for a in sorted(_attributes_of(function, name))])
            elif isinstance(value, ModuleType):
                twin.others.add(value.__name__)
            elif (text := _literal(value)) and len(text) <= LONGEST:
                twin.constants[name] = text
            else:
                twin.imports.setdefault(self._defining(value, own), set()).add(name)

    def _defining(self, value: Any, own: str) -> str:
        """The module of the package that a class or kept results are defined in, `own` for what does not say it."""
        home = str(getattr(getattr(value, "function", value), "__module__", ""))
        return home.removeprefix(f"{self.package}.") if home.startswith(f"{self.package}.") else own

    def _body(self, value: Any) -> FunctionType | None:
        """The function of a module of the package behind a name, without its decorators; None for anything else."""
        inner = unwrap(value) if isinstance(value, FunctionType) else value
        own = self._is_own(inner, FunctionType) and inner.__closure__ is None and not self._counterpart(inner)
        return inner if own else None

    def _late(self, function: FunctionType) -> dict[str, Any]:
        """What a body imports itself, by name."""
        found: dict[str, Any] = {}
        for node in _imports(self._text(function)):
            module = import_module(f"{self.package}.{_resolved(self._module(function), node)}")
            found |= {one.name: getattr(module, one.name) for one in node.names}
        return found

    def _flat(self, function: FunctionType, result: Node, rules: dict[Lengths, str]) -> str:
        """The text of a twin that has a graph."""
        arguments = [name for name in function.__annotations__ if name != "return"]
        lines = "\n".join(f"    {line}" for line in Lines(result, None, rules).text())
        return ast.unparse(ast.parse(f"def {function.__name__}({', '.join(arguments)}):\n{lines}\n"))

    def _written(self, function: FunctionType, rules: dict[Lengths, str]) -> str:
        """The text of a twin."""
        if (result := self._graph(function)) is not None:
            return self._flat(function, result, rules)
        own, late = self._module(function), self._late(function)

        def home(path: str, name: str) -> str:
            body = f"{BODIES}.{path}" if self._body(late[name]) else path
            return self._counterpart(late[name]) or body

        return ast.unparse(_Single(own, home).visit(ast.parse(self._text(function))))

    def _counterpart(self, value: Any) -> str:
        """The module that has a function of this name for plain numbers, or none."""
        module = COUNTERPARTS.get(self._module(value), "") if isinstance(value, FunctionType) else ""
        return module if module and hasattr(import_module(f"{self.package}.{module}"), value.__name__) else ""

    def sources(self) -> dict[str, str]:
        """The texts of all twins by dotted name below the package."""
        return {f"{BODIES}.{path}": self._source(path, twin) for path, twin in sorted(self.found.items())}

    def _source(self, path: str, twin: Twin) -> str:
        level = "." * (path.count(".") + 3)
        order = {name: place for place, name in enumerate(_bodies(self.texts[path]))}
        functions = sorted(twin.functions.values(), key=lambda one: order[one.__name__])
        lines = ["from __future__ import annotations", "", *(f"import {name}" for name in sorted(twin.others)), ""]
        for name, module in sorted(twin.modules.items()):
            folder, _, last = module.rpartition(".")
            lines.append(f"from {level}{BODIES}.{folder} import {last}" + (f" as {name}" if name != last else ""))
        lines += [
            f"from {level}{module} import {', '.join(sorted(names))}" for module, names in sorted(twin.imports.items())
        ]
        texts = [self._written(function, twin.rules) for function in functions]
        rules = [f"{name} = rule({lengths!r})" for lengths, name in twin.rules.items()]
        constants = [f"{name} = {value}" for name, value in sorted(twin.constants.items())]
        flat = [text for one, text in zip(functions, texts, strict=True) if self._graph(one) is not None]
        called = {name for pair in re.findall(CALLED, "\n".join(constants + rules + flat)) for name in pair} & OF_MATH
        plain = sorted(called & WITHOUT_ERRORS) + ["rule"] * bool(rules)
        plain += ["MATH as np"] * any("np." in text for text in texts)
        lines += [f"from {level}_runtime.plain import {', '.join(plain)}"] if plain else []
        of_math = sorted(called - WITHOUT_ERRORS)
        lines[2:2] = [f"from math import {', '.join(of_math)}"] if of_math else []
        lines += ["", *constants, *rules] if constants or rules else []
        head = HEAD.format(title=f"axicontact.{path}")
        return head + "\n".join(lines) + "".join(f"\n\n\n{text}" for text in texts) + "\n"

    def _decorators(self, function: FunctionType) -> frozenset[str]:
        known = self._module(function) in self.texts
        return _decorators(self._text(function)) if known else frozenset()

    def _text(self, function: FunctionType) -> str:
        return _bodies(self.texts[self._module(function)])[function.__name__]

    def _needs_arrays(self, function: FunctionType, seen: set[FunctionType]) -> bool:
        if function not in self._needy:
            seen.add(function)
            found = self._looks_for_arrays(function) or any(
                self._needs_arrays(other, seen) for other in self._called(function) if other not in seen
            )
            if not found:
                return False
            self._needy[function] = True
        return self._needy[function]

    def _looks_for_arrays(self, function: FunctionType) -> bool:
        code = function.__code__
        of_arrays = any(self._of_arrays(*attribute) for attribute in _attributes(code))
        return of_arrays or bool(_names(code) & NEEDS_ARRAYS) or self._is_nested(function)

    def _is_nested(self, function: FunctionType) -> bool:
        """Whether it integrates over integrals: for those a call over all nodes is quicker than a loop."""
        tree, space = ast.parse(self._text(function)), function.__globals__ | self._late(function)
        inner = {node.name: node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}
        for call in [
            node for node in ast.walk(tree) if isinstance(node, ast.Call) and self._integrates(node.func, space)
        ]:
            handed = [own for own in call.args if own is call.args[0] or not isinstance(own, ast.Call)]
            if any(self._integrates(inner.get(ast.unparse(own), own), space) for own in handed):
                return True
        return False

    def _integrates(self, tree: ast.AST, space: Mapping[str, Any]) -> bool:
        """Whether a name in an expression stands for a function that calls a rule."""
        names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
        return any(self._reaches(space[name]) for name in sorted(names & space.keys()))

    def _reaches(self, value: Any) -> bool:
        """Whether a function is a rule or calls one."""
        if not isinstance(value, FunctionType):
            return False
        if value not in self._integrating:
            self._integrating[value] = False  # while those it calls are asked
            rule = self._module(value) in RULES and bool(self._counterpart(value))
            body = None if rule else self._body(value)
            found = rule or (body is not None and any(self._reaches(own) for own in self._mentioned(body)))
            self._integrating[value] = found
        return self._integrating[value]

    def _mentioned(self, function: FunctionType) -> list[Any]:
        """What the names in a body stand for, of its module, of modules it knows and of those it imports."""
        names, late = _globals(function.__code__) | self._decorators(function), self._late(function)
        space = function.__globals__ | late
        found = {name: space[name] for name in sorted(names | late.keys()) if name in space}
        # an attribute of a module is not the function of that name beside the body
        modules = [(own, _attributes_of(function, n)) for n, own in found.items() if self._is_own(own, ModuleType)]
        members = [vars(own)[name] for own, named in modules for name in sorted(named) if name in vars(own)]
        return [*found.values(), *members]

    def _called(self, function: FunctionType) -> list[FunctionType]:
        return [body for other in self._mentioned(function) if (body := self._body(other)) is not None]

    def _of_arrays(self, owner: str, name: str) -> bool:
        """Whether plain numbers have nothing of that name; `sum` is one of NumPy, and of Python without `np` before."""
        if owner == "np":
            return not hasattr(self.math, name)
        return (
            owner != "math"
            and hasattr(np.ndarray, name)
            and not any(hasattr(kind, name) for kind in (float, list, tuple))
        )

    def _is_own(self, value: Any, kind: type) -> bool:
        name = getattr(value, "__module__" if kind is FunctionType else "__name__", None)
        return isinstance(value, kind) and str(name).startswith(f"{self.package}.")


class _Single(ast.NodeTransformer):
    """What a body becomes: a choice is evaluated in one branch alone, and what it imports itself has its own `home`.

    Annotations go: the first call would import what they name.
    """

    def __init__(self, module: str, home: Callable[[str, str], str]) -> None:
        self.module, self.home = module, home

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Python's choice for NumPy's."""
        self.generic_visit(node)
        return ast.IfExp(*node.args) if ast.unparse(node.func) == "np.where" else node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        """Without the kind of its result."""
        self.generic_visit(node)
        node.returns = None
        return node

    def visit_arg(self, node: ast.arg) -> ast.AST:
        """The name alone."""
        return ast.arg(node.arg)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.AST:
        """The value alone."""
        self.generic_visit(node)
        assert node.value is not None
        return ast.Assign([node.target], node.value, lineno=node.lineno)

    def visit_ImportFrom(self, node: ast.ImportFrom) -> list[ast.stmt]:
        """One import for each home."""
        homes = dict[str, list[ast.alias]]()
        for one in node.names:
            homes.setdefault(self.home(_resolved(self.module, node), one.name), []).append(one)
        return [ast.ImportFrom(home, names, self.module.count(".") + 3) for home, names in homes.items()]


def _literal(value: Any) -> str:
    """A number, a word or several as they are written; empty for anything else."""
    if isinstance(value, dict):
        both = [(_literal(key), _literal(own)) for key, own in value.items()]
        return f"{{{', '.join(f'{key}: {own}' for key, own in both)}}}" if all(map(all, both)) else ""
    if isinstance(value, tuple):
        inner = [_literal(own) for own in value]
        return f"({', '.join(inner)},)" if all(inner) else ""
    return repr(float(value) if isinstance(value, float) else value) if isinstance(value, (int, float, str)) else ""


def _names(code: CodeType) -> set[str]:
    inner = (_names(constant) for constant in code.co_consts if isinstance(constant, CodeType))
    return set(code.co_names).union(*inner)


def _globals(code: CodeType) -> set[str]:
    """The global names that are looked up."""
    inner = (_globals(constant) for constant in code.co_consts if isinstance(constant, CodeType))
    own = {step.argval for step in get_instructions(code) if step.opname in ("LOAD_GLOBAL", "LOAD_NAME")}
    return own.union(*inner)


def _attributes(code: CodeType) -> Iterator[tuple[str, str]]:
    """What attributes are looked up, each behind the global name it is one of, or behind none."""
    owner = ""
    for step in get_instructions(code):
        if step.opname in ("LOAD_ATTR", "LOAD_METHOD"):
            yield owner, step.argval
        owner = step.argval if step.opname == "LOAD_GLOBAL" else ""
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _attributes(constant)


def _attributes_of(function: FunctionType, name: str) -> set[str]:
    return {attribute for owner, attribute in _attributes(function.__code__) if owner == name}


@cache
def _bodies(text: str) -> dict[str, str]:
    """The functions of a module by name, as they are written."""
    lines = text.splitlines()
    found = {}
    for node in ast.parse(text).body:
        if isinstance(node, ast.FunctionDef):
            first = min([node.lineno, *(decorator.lineno for decorator in node.decorator_list)])
            found[node.name] = "\n".join(lines[first - 1 : node.end_lineno])
    return found


@cache
def _imports(text: str) -> list[ast.ImportFrom]:
    """The imports inside the function of a text."""
    return [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.ImportFrom)]


def _resolved(path: str, node: ast.ImportFrom) -> str:
    """The module below the package that a relative import in the module `path` stands for."""
    return ".".join([*path.split(".")[: -node.level], node.module or ""])


@cache
def _decorators(text: str) -> frozenset[str]:
    """The names that the decorators of a function use."""
    (function,) = ast.parse(text).body
    assert isinstance(function, ast.FunctionDef)
    return frozenset(part.id for one in function.decorator_list for part in ast.walk(one) if isinstance(part, ast.Name))
