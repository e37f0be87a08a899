"""The functions of a package as expressions that call one another, from the graph of each.

While a body is traced every function of the package that takes and gives arrays alone is one operation, `call`,
if it has a graph of its own.  Rules, roots and special functions have stand-ins here, with a fixed number of steps.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import reduce, wraps
from types import FunctionType, ModuleType
from typing import Any

import numpy as np

from ..module import PACKAGE, PLACE
from .expressions import STEPS, expression
from .graph import Graph, Node, Traced, needed, trace

ARRAYS = frozenset(("Array", "Array | float", "float | Array", "tuple[float, ...]"))
"""Annotations of arguments that a call passes on."""
EXPRESSIONS = "_programs.expressions"
SHORTEST = 3
"""Operations up to which a function stands where it is called."""
GRIDS = ("decades", "radii_below", "radii_to", "radii_beyond", "radii_around")
"""Grids of radii that separate the least loads of a contact, as many for any lengths."""
SLACK = 1e-6
"""The least slope of a curve of which none is known."""


class _Term(Traced):
    """The coefficient of a term that is left out where it is zero."""

    def __bool__(self) -> bool:
        return True


class Shared:
    """The expressions of a package, from its modules by their dotted names below it."""

    def __init__(self, modules: Mapping[str, ModuleType]) -> None:
        self._modules = modules
        self._paths = {module.__name__: path for path, module in modules.items()}
        self._graphs: list[Graph] = []
        self._found: dict[tuple[str, str], Node | None] = {}
        self._arguments: dict[tuple[str, str], list[str]] = {}
        self._calling: dict[Any, Any] = {}
        self._coefficients: dict[tuple[str, str], Node | None] = {}
        self._texts: dict[str, dict[str, str]] = {}
        self._imports: dict[str, dict[tuple[str, str], str]] = {}

    def add(self, public: Mapping[str, Mapping[str, FunctionType]]) -> None:
        """Write the formulas of public functions by the modules and names of these, as far as they have a graph."""
        with self._calls():
            for path, formulas in public.items():
                for name, formula in formulas.items():
                    key = self._key(formula)
                    if self._graph(key, formula) is not None and self._write(key) and key != (path, f"_{name}"):
                        self._imports.setdefault(path, {})[f"{EXPRESSIONS}.{key[0]}", key[1]] = name

    def sources(self) -> dict[str, str]:
        """The modules by dotted name below the package."""
        return {f"{EXPRESSIONS}.{path}": self._source(path) for path in sorted(self._imports) if self._imports[path] or any(self._texts.get(path, {}).values())}

    def _key(self, function: Any) -> tuple[str, str]:
        own = inspect.unwrap(function)
        return self._paths[own.__module__], own.__name__

    def _graph(self, key: tuple[str, str], function: Any) -> Node | None:
        """That of a function, if it has one."""
        if key not in self._found:
            graph = Graph(roots=True)
            self._graphs.append(graph)
            names = list(inspect.signature(function).parameters)
            self._arguments[key] = names
            self._found[key] = trace(function, names, (), graph)
            self._coefficients[key] = graph.coefficients
            self._graphs.pop()
        return self._found[key]

    @contextmanager
    def _calls(self) -> Iterator[None]:
        """While this lasts the functions of the package are operations."""
        before = {path: dict(vars(module)) for path, module in self._modules.items()}
        for module in self._modules.values():
            own = {name: self._operation(value) for name, value in vars(module).items() if not name.startswith("__")}
            if "sum" not in own:
                own |= {"sum": _total, "enumerate": _numbered, "reduce": _reduced, "len": _count}
            vars(module).update({name: value for name, value in own.items() if value is not None})
        vars(self._modules["_runtime.graded.waves"])["FAR"] = np.inf
        try:
            yield
        finally:
            for path, module in self._modules.items():
                vars(module).clear()
                vars(module).update(before[path])

    def _operation(self, value: Any) -> Any:
        """What stands for a function of the package; None for anything else."""
        function = getattr(value, "function", value) if type(value).__name__ == "Kept" else value
        if not isinstance(function, FunctionType) or function.__module__ not in self._paths:
            return None
        if function not in self._calling:
            key = self._key(function)
            standing = STANDING.get((key[0].removeprefix(f"{PLACE}."), key[1]))
            body = wraps(function)(lambda *given, **named: standing(self._graphs[-1], *given, **named))
            self._calling[function] = self._caller(key, body if standing else function)
        return self._calling[function]

    def _caller(self, key: tuple[str, str], function: FunctionType) -> Callable[..., Any]:
        own = inspect.unwrap(function)
        signature = inspect.signature(function)
        shared = own.__annotations__.get("return") == "Array" and all(
            own.__annotations__.get(name) in ARRAYS and one.kind is one.POSITIONAL_OR_KEYWORD
            for name, one in signature.parameters.items()
        )

        @wraps(function)
        def called(*given: Any, **named: Any) -> Any:
            if not shared or not self._graphs:
                return function(*given, **named)
            bound = signature.bind(*given, **named)
            bound.apply_defaults()
            values = bound.arguments
            plain = all(isinstance(x, (Traced, int, float)) and not isinstance(x, bool) for x in values.values())
            if not plain or not any(isinstance(x, Traced) for x in values.values()):
                return function(*given, **named)
            graph = self._graphs[-1]
            of = Traced(graph, graph.number(0.0)).of
            nodes = {name: of(x) for name, x in values.items()}
            found = None if any(x.logical for x in nodes.values()) else self._graph(key, function)
            if found is None or sum(bool(x.operands) for x in needed(found)) <= SHORTEST:
                return function(*given, **named)
            home = f"{EXPRESSIONS}.{key[0]}", key[1]
            if (own := self._coefficients[key]) is not None:
                graph.coefficients = nodes[own.value]
            return Traced(graph, graph.other("call", [nodes[name] for name in self._arguments[key]], home))

        return called

    def _write(self, key: tuple[str, str]) -> bool:
        """Write a function and those it calls; False if one of them is too long."""
        path, name = key
        texts, imports = self._texts.setdefault(path, {}), self._imports.setdefault(path, {})
        if name not in texts:
            result, arguments = self._found[key], self._arguments[key]
            calls = [node.value for node in needed(result) if node.name == "call" and node.value[0] != STEPS]
            if not all([self._write((home.removeprefix(f"{EXPRESSIONS}."), own)) for home, own in calls]):
                texts[name] = ""
                return False

            def called(home: str, own: str) -> str:
                if home == f"{EXPRESSIONS}.{path}":
                    return own.removeprefix("_")
                folders = "_".join(home.removeprefix(f"{EXPRESSIONS}.").split(".")[:-1])
                alias = own.removeprefix("_") if "_runtime" in home else f"{folders}_{own.removeprefix('_')}"
                return imports.setdefault((home, own), alias)

            coefficients = self._coefficients[key]
            arrays = [own for own in arguments if coefficients is None or own != coefficients.value]
            texts[name] = expression(name.removeprefix("_"), arguments, arrays, result, called) or ""
        return bool(texts[name])

    def _source(self, path: str) -> str:
        level, lines, named = "." * (path.count(".") + 3), list[str](), list[str]()
        for (home, name), alias in sorted(self._imports[path].items()):
            own = name.removeprefix("_")
            if home != f"{EXPRESSIONS}.{path}":
                lines.append(f"from {level}{home} import {own}" + (f" as {alias}" if alias != own else ""))
            else:
                named.append(f"{alias} = {own}")
        head = f'"""Formulas of {PACKAGE}.{path} over an array library `xp`."""'
        head += "\n\n" * bool(lines) + "\n".join(lines)
        return "\n\n\n".join([head, *filter(None, self._texts.get(path, {}).values()), *named]) + "\n"


def _depends(node: Node, graph: Graph) -> bool:
    return bool({graph.variable("j"), graph.variable("A_j")} & {*needed(node)})


def _numbered(given: Any, start: int = 0) -> Any:
    """A pair of the number and the coefficient that stand for all."""
    if isinstance(given, Traced):
        graph = given.graph
        graph.coefficients = given.node
        return [(Traced(graph, graph.variable("j")), _Term(graph, graph.variable("A_j")))]
    items = list(given)
    if len(items) == 1 and isinstance(items[0], Traced) and _depends(items[0].node, items[0].graph):
        return [(Traced(items[0].graph, items[0].graph.variable("j")), items[0])]
    return enumerate(items, start)


def _over_terms(kind: str, items: list[Any]) -> Any:
    """What is made of all terms if this is the one that stands for them."""
    if len(items) != 1 or not isinstance(items[0], Traced) or not _depends(items[0].node, items[0].graph):
        return None
    graph, term = items[0].graph, items[0].node
    if kind == "total":
        zero = graph.number(0.0)
        term = graph.choice(graph.operation("greater", graph.variable("A_j"), zero), term, zero)
    given = graph.coefficients, graph.variable("j"), graph.variable("A_j"), term
    return Traced(graph, graph.other(kind, given))


def _total(given: Any) -> Any:
    items = list(given)
    found = _over_terms("total", items)
    return sum(items) if found is None else found


def _reduced(function: Any, given: Any) -> Any:
    items = list(given)
    found = _over_terms("least", items)
    return reduce(function, items) if found is None else found


def _count(given: Any) -> Any:
    return Traced(given.graph, given.graph.other("count", [given.node])) if isinstance(given, Traced) else len(given)


def _traced(graph: Graph, x: Any) -> Traced:
    return x if isinstance(x, Traced) else Traced(graph, Traced(graph, graph.number(0.0)).of(x))


def _calling(home: str, name: str, kind: str = "call") -> Callable[..., Traced]:
    """What calls a function of the run time."""
    return lambda graph, *given: Traced(graph, graph.other(kind, [_traced(graph, x).node for x in given], (home, name)))


def _strip(graph: Graph, integrand: Any, stop: Any, width: Any = 1.0, waves: Any = ()) -> Traced:
    return _traced(graph, stop).integral(integrand, width, "waves" if waves else "")


def _panels(graph: Graph, integrand: Any, stop: Any, width: Any, count: int) -> Traced:
    return _traced(graph, stop).integral(integrand, width, "waves")


def _weighted(graph: Graph, smooth: Any, stop: Any, power: Any, count: int = 0, above: Any = None) -> Traced:
    return _traced(graph, stop).weighted(smooth, 1.0 + power if above is None else above)


def _gamma_quotient(graph: Graph, x: Any, y: Any) -> Any:
    gamma = _calling(STEPS, "gamma")
    return gamma(graph, x) / gamma(graph, y)


def _over_waves(graph: Graph, value: Traced, waves: Traced, power: int) -> Traced:
    struve = [_calling(f"{EXPRESSIONS}._runtime.special", f"struve_h{order}") for order in (0, 1)]
    plain = np.sqrt(value) if power == 1 else np.cbrt(1.5 * value)
    raised = 1.0 + 2.0 / np.pi * waves / (1.0 + plain * plain)

    def curve(z: Traced) -> tuple[Traced, Traced]:
        zero, one = (own(graph, z) for own in struve)
        slope = 2.0 * z + waves * (zero + z * (2.0 / np.pi - one))
        if power == 1:
            y = z * z + waves * z * zero
            return y, z * slope / y
        y = 2.0 / 3.0 * z * (z * z) + waves * (z * z * zero - z * one)
        return y, z * z * slope / y

    start = plain / (np.sqrt(raised) if power == 1 else np.cbrt(raised))
    return start.root(curve, value, np.inf, (SLACK, np.inf))


def _bell(graph: Graph, a: Traced, s: Traced, k: Traced, of: Callable[[Traced], Traced]) -> Traced:
    square = (a / s) ** 2
    return _weighted(graph, lambda x: of((1.0 - x) * (1.0 + x) * square), _traced(graph, 1.0), k)


def _gaussian_reach(graph: Graph, s: Traced, k: Traced) -> Traced:
    """The rate vanishes where the mean of the fall is one, with the weight of the depth."""

    def curve(t: Traced) -> tuple[Traced, Traced]:
        depth, first, second = (
            _bell(graph, t, _traced(graph, 1.0), k, lambda fall, n=n: fall**n * np.exp(-fall)) for n in (0.0, 1.0, 2.0)
        )
        return first / depth, 2.0 * (1.0 + first / depth - second / first)

    return s * _traced(graph, 1.5).root(curve, 1.0, np.inf, (SLACK, np.inf))


def _across(
    graph: Graph, curve: Any, value: Traced, b: Any, tip: Any, end: Any = None, powers: Any = None
) -> Traced:
    """In x = a/b up to the break and 1 + sqrt(a**2/b**2 - 1) beyond: no slope is infinite there but for k < 0."""
    b = _traced(graph, b)
    base = curve(b, b * 0.0)[0]

    def radius(x: Traced) -> tuple[Traced, Traced, Traced]:
        t = np.where(x < 1.0, 0.0, x - 1.0)
        stretched = np.sqrt(1.0 + t * t)
        return b * np.where(x < 1.0, x, stretched), b * t, np.where(x < 1.0, 1.0, x * t / (1.0 + t * t))

    def own(x: Traced) -> tuple[Traced, Traced]:
        a, root, share = radius(x)
        y, rate = curve(a, root)
        return y, rate / y * share

    start = (value / base) ** (1.0 / tip)
    return radius(start.root(own, value, np.inf, (SLACK, np.inf)))[0]


def _radius_across(
    graph: Graph, load: Any, rate: Any, value: Traced, b: Any, needs: Any, tip: Any, least: Any = None, end: Any = None
) -> Traced:
    return _across(graph, lambda a, root: (load(a, root, *needs), a * rate(a, root, *needs)), value, b, tip)


def _stable_radius(
    graph: Graph, value: Traced, found: Any, load: Any, slope_of: Any, pulled: Any, inner: Any, *unknowns: Any, **corner: Any
) -> Traced:
    variable = graph.variable()
    a = Traced(graph, variable)
    curve = load(a).node, slope_of(a).node
    return Traced(graph, graph.other("stable", (value.node, found.radii.node, variable, *curve)))


def _radii(kind: str) -> Callable[..., Traced]:
    """Those of a grid, for a length of one or of their own."""
    return lambda graph, *length: Traced(graph, graph.other("radii", (), kind)) * (length[0] if length else 1.0)


STANDING: dict[tuple[str, str], Any] = {
    **{("physics.branches", kind): _radii(kind) for kind in GRIDS},
    ("physics.branches", "branches"): lambda graph, steepness, sampled, level: sampled,
    ("physics.stable", "stable_radius"): _stable_radius,
    ("integrals", "integral_in_strip"): _strip,
    ("integrals", "integral_by_panels"): _panels,
    ("functions", "gamma"): _calling(STEPS, "gamma"),
    ("functions", "gamma_quotient"): _gamma_quotient,
    ("functions", "depth_over_height"): _calling("_runtime.functions", "depth_over_height", "plain"),
    ("shapes.waves", "inverse_over_waves"): _over_waves,
    ("shapes.across", "inverse_across"): _across,
    ("physics.relaxation", "fading"): _calling(STEPS, "fading"),
    ("physics.branches", "exponent_of"): lambda graph, x: 0,
    ("physics.branches", "stress_at"): lambda graph, unit, H, k: (0, H),
    ("physics.unknowns", "root_of"): lambda graph, x, first, last: (x, 1.0),
    ("physics.unknowns", "power_of"): lambda graph, t, first, last: t,
    ("graded.rules", "weighted"): _weighted,
    ("graded.growth", "_gamma"): _calling(STEPS, "gamma"),
    ("graded.growth", "_rising"): _calling(STEPS, "rising"),
    ("graded.growth", "_bell"): _bell,
    ("graded.inverse", "gaussian_reach"): _gaussian_reach,
    ("graded.inverse", "radius_across"): _radius_across,
    ("graded.displacement", "_to_axis"): lambda graph, q: _traced(graph, np.pi / 3.0),
    ("graded.waves", "_far"): lambda graph, *given: 0.0,
}
"""In the place of functions of the run time that look at their data: rules, special functions, units of lengths."""
