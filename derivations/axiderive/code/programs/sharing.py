"""The functions of a package as expressions that call one another, from the graph of each.

While a body is traced every function of the package that takes and gives arrays alone is one operation, `call`,
if it has a graph of its own.  So special functions, rules of one profile and curves are written once.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import wraps
from types import FunctionType, ModuleType
from typing import Any, TypeAlias

from ..module import PACKAGE, PLACE
from .expressions import EXPRESSIONS, expression
from .graph import Graph, Node, Traced, needed, trace
from .standing import BUILTINS, STANDING

ARRAYS = frozenset(("Array", "Array | float", "float | Array", "tuple[float, ...]"))
"""Annotations of arguments that a call passes on."""
SHORTEST = 3
"""Operations up to which a function stands where it is called."""
Key: TypeAlias = tuple[str, str]
"""The module of an expression and the name of its function."""


@dataclass
class _Home:
    """A module of expressions: texts by name, the names of others that it calls, and of its own under another one."""

    texts: dict[str, str] = field(default_factory=dict)
    imports: dict[Key, str] = field(default_factory=dict)


class Shared:
    """The expressions of a package, from its modules by their dotted names below it."""

    def __init__(self, modules: Mapping[str, ModuleType]) -> None:
        self._modules = modules
        self._paths = {module.__name__: path for path, module in modules.items()}
        self._graphs: list[Graph] = []
        self._found: dict[Key, tuple[Node, list[str], Node | None] | None] = {}
        self._standing: dict[FunctionType, Callable[..., Any]] = {}
        self._homes: dict[str, _Home] = {}

    def add(self, public: Mapping[str, Mapping[str, FunctionType]]) -> None:
        """Write the formulas of public functions by the modules and names of these, as far as they have a graph."""
        with self._calls():
            for path, formulas in public.items():
                own = f"{EXPRESSIONS}.{path}"
                for name, formula in formulas.items():
                    key = self._key(formula)
                    if self._graph(key, formula) is not None:
                        self._write(key)
                        if key != (own, f"_{name}"):
                            self._home(own).imports[key] = name

    def sources(self) -> dict[str, str]:
        """The modules by dotted name below the package."""
        return {path: _source(path, self._homes[path]) for path in sorted(self._homes)}

    def _home(self, path: str) -> _Home:
        return self._homes.setdefault(path, _Home())

    def _key(self, function: FunctionType) -> Key:
        own = inspect.unwrap(function)
        return f"{EXPRESSIONS}.{self._paths[own.__module__]}", own.__name__

    def _graph(self, key: Key, function: Callable[..., Any]) -> tuple[Node, list[str], Node | None] | None:
        """The result of a function, its arguments and which of them holds coefficients; None without a graph."""
        if key not in self._found:
            self._graphs.append(Graph(roots=True))
            arguments = list(inspect.signature(function).parameters)
            result = trace(function, arguments, (), self._graphs[-1])
            graph = self._graphs.pop()
            self._found[key] = None if result is None else (result, arguments, graph.coefficients)
        return self._found[key]

    @contextmanager
    def _calls(self) -> Iterator[None]:
        """While this lasts the functions of the package are operations."""
        before = {path: dict(vars(module)) for path, module in self._modules.items()}
        for path, module in self._modules.items():
            own = {name: self._stands_for(value) for name, value in before[path].items() if not name.startswith("__")}
            vars(module).update(BUILTINS | {name: value for name, value in own.items() if value is not None})
        for (path, name), value in STANDING.items():
            home = self._modules.get(f"{PLACE}.{path}")  # none with part of the package
            if home is not None and not callable(value):
                setattr(home, name, value)
        try:
            yield
        finally:
            for path, module in self._modules.items():
                vars(module).clear()
                vars(module).update(before[path])

    def _stands_for(self, value: Any) -> Callable[..., Any] | None:
        """What stands for a function of the package; None for anything else."""
        # results that are kept are those of a function
        function = getattr(value, "function", value)
        if not isinstance(function, FunctionType) or function.__module__ not in self._paths:
            return None
        if function not in self._standing:
            path = self._paths[inspect.unwrap(function).__module__].removeprefix(f"{PLACE}.")
            standing = STANDING.get((path, function.__name__))
            body = function if standing is None else wraps(function)(self._bound(standing))
            self._standing[function] = self._caller(self._key(function), body)
        return self._standing[function]

    def _bound(self, standing: Callable[..., Any]) -> Callable[..., Any]:
        return lambda *given, **named: standing(self._graphs[-1], *given, **named)

    def _caller(self, key: Key, function: Callable[..., Any]) -> Callable[..., Any]:
        """A function that is a call where all it takes are arrays."""
        signature, said = inspect.signature(function), inspect.unwrap(function).__annotations__
        parameters = signature.parameters.values()
        arrays = all(one.kind is one.POSITIONAL_OR_KEYWORD and said.get(one.name) in ARRAYS for one in parameters)
        if not arrays or said.get("return") != "Array":
            return function

        @wraps(function)
        def called(*given: Any, **named: Any) -> Any:
            bound = signature.bind(*given, **named)
            bound.apply_defaults()
            kinds, graph = {type(x) for x in bound.arguments.values()} - {int, float}, self._graphs[-1]
            if not kinds or not all(issubclass(kind, Traced) for kind in kinds):
                return function(*given, **named)
            nodes = {name: graph.of(x) for name, x in bound.arguments.items()}
            found = None if any(x.logical for x in nodes.values()) else self._graph(key, function)
            if found is None or sum(bool(x.operands) for x in needed(found[0])) <= SHORTEST:
                return function(*given, **named)
            if found[2] is not None:
                graph.coefficients = nodes[found[2].value]
            return Traced(graph, graph.other("call", list(nodes.values()), key))

        return called

    def _write(self, key: Key) -> None:
        """Write a function and those it calls."""
        (path, name), found = key, self._found.get(key)
        if found is None or name in self._home(path).texts:
            return
        (result, arguments, coefficients), home = found, self._home(path)
        for node in needed(result):
            if node.name == "call":
                self._write(node.value)

        def called(other: str, own: str) -> str:
            if other == path:
                return own.removeprefix("_")
            folders = [] if f".{PLACE}." in f".{other}" else other.removeprefix(f"{EXPRESSIONS}.").split(".")[:-1]
            return home.imports.setdefault((other, own), "_".join([*folders, own.removeprefix("_")]))

        arrays = [own for own in arguments if coefficients is None or own != coefficients.value]
        home.texts[name] = expression(name.removeprefix("_"), arguments, arrays, result, called)


def _source(path: str, home: _Home) -> str:
    level, lines, named = "." * path.count("."), list[str](), list[str]()
    for (other, name), alias in sorted(home.imports.items()):
        own = name.removeprefix("_")
        if other == path:
            named.append(f"{alias} = {own}")
        else:
            lines.append(f"from {level}.{other} import {own}" + (f" as {alias}" if alias != own else ""))
    head = f'"""Formulas of {PACKAGE}.{path.removeprefix(f"{EXPRESSIONS}.")} over an array library `xp`."""'
    return "\n\n\n".join([head + "\n\n" * bool(lines) + "\n".join(lines), *home.texts.values(), *named]) + "\n"
