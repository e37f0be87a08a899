"""Emitted modules run from their texts, and their errors in units of the last place beside exact values.

With what their functions rest on, and what `lambdify` makes of the printed formula, which they are measured beside.
"""

from __future__ import annotations

import ast
import math
import re
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from importlib import abc, import_module, machinery
from pathlib import PurePosixPath
from types import ModuleType
from typing import Any

import numpy as np
import sympy as sp
from flint import arb, ctx

from .. import notation as nt
from ..abel.masters import C0
from ..entry import Case, Entry
from ..letters import name_of
from .reference import LARGEST, SMALLEST, Domain, Floats, UnknownError, floats, is_inverse, of_contact, reference


@dataclass(frozen=True)
class Sample:
    """One call of an emitted function and the exact value."""

    arguments: tuple[float, ...]
    keywords: dict[str, Any]
    exact: arb
    values: Floats
    """All numbers by symbol; for an inverse with the radius near the exact one."""


def samples(entries: Mapping[str, Entry], suffix: str, domain: Domain, count: int, seed: int = 17) -> Iterator[Sample]:
    """Calls whose exact value is a normal number, or zero everywhere."""
    entry = entries[suffix]
    # the ring under an arc leaves the axis at a share of its end that no order of lengths says
    unordered = suffix == "k" or entry.quantity.symbol == nt.r_peak and entry.profile.chain
    like = entry.quantity.inverts if is_inverse(entry) else "d" if unordered and "d" in entries else suffix
    for values in floats(entries[like], domain, count, seed, entry.parameters):
        try:
            completed(entries, values)
            arguments, exact = reference(dict(entries), suffix, values)
        except UnknownError:
            continue
        if SMALLEST < abs(float(exact)) < LARGEST or exact == 0:
            yield Sample(*_call(entry, arguments), exact, arguments)


def value(function: Callable[..., float], point: Sample) -> float:
    """The result of a call as a float; NaN where a number overflows."""
    try:
        return float(function(*point.arguments, **point.keywords))
    except OverflowError:
        return math.nan


def completed(entries: Mapping[str, Entry], values: Floats) -> None:
    """Raise depth, force and load above the threshold of complete contact, a depth by its own size over the contact."""
    for entry in entries.values():
        symbol = entry.quantity.symbol
        if entry.quantity.threshold and symbol in values:
            least = float(of_contact(entries, entry.suffix, values))
            if not SMALLEST < least < LARGEST:
                message = f"{entry.suffix} = {least} is no normal number"
                raise UnknownError(message)
            values[symbol] = least * max(1.0 + 1e-12, values[symbol] / values[nt.a] if symbol == nt.d else 2.0)


def count_for(entry: Entry, count: int) -> int:
    """Fewer where the reference itself is an integral: a tenth."""
    return count // 10 if any(case.expr.has(sp.Integral, C0) for case in entry.cases) else count


def _call(entry: Entry, values: Floats) -> tuple[tuple[float, ...], dict[str, Any]]:
    fields = entry.arguments
    keywords = {name_of(s): values[s] for s in entry.parameters if s not in fields}
    return tuple(values[symbol] for symbol in fields), keywords


def function_of(entry: Entry, module: Any = None) -> Callable[..., float]:
    """The emitted function of normal contact, or that of another module; of several results the one of the entry."""
    module = module or import_module(f"axicontact.normal.{entry.profile.name}")
    function, member = getattr(module, entry.quantity.function), entry.quantity.member
    return (lambda *fields, **keywords: getattr(function(*fields, **keywords), member)) if member else function


def ulps(got: float, exact: arb) -> float:
    """Distance from the exact value in units of the last place of the exact value."""
    if not math.isfinite(got):
        return math.inf
    with ctx.workprec(256):
        return float(abs(arb(got) - exact) / float(np.spacing(abs(float(exact)))))


PACKAGE = "axicontact"
RULES = ("integral", "panels")
STRIPS = frozenset(("depth_beyond", "load_beyond", "slope_beyond"))
"""Rules of the plane problem; private functions of other modules end on the same words."""
ITERATIONS = frozenset(("inverse", "inverse_across", "inverse_below", "inverse_beyond", "inverse_over_waves"))
KERNELS = frozenset(
    (
        "arc_strips", "arctan_gap", "beside", "dawson", "gamma_ratio", "nth_root", "outside_zero_pressure",
        "peak_share", "power", "power_displacement", "power_pressure", "power_punches", "power_strips", "root_gap",
        "struve_h0", "struve_h1", "tanh_gap", "uniform",
    )
)  # fmt: skip
ARRAYS = frozenset(("outside_zero_pressure", "power", "power_displacement", "power_pressure", "power_strips"))
"""Kernels that are rules themselves."""


class Texts(abc.MetaPathFinder, abc.InspectLoader):
    """Finds and loads the modules of one package among texts by path."""

    def __init__(self, name: str, texts: Mapping[str, str]) -> None:
        self.name, self.texts = name, texts

    def find_spec(
        self, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> machinery.ModuleSpec | None:
        """The specification of a module that is among the texts, else None."""
        if fullname.partition(".")[0] != self.name or self._path(fullname) is None:
            return None
        return machinery.ModuleSpec(fullname, self, is_package=self.is_package(fullname))

    def is_package(self, fullname: str) -> bool:
        """Whether the text of a name is that of a package."""
        return str(self._path(fullname)).endswith("__init__.py")

    def get_source(self, fullname: str) -> str:
        """The text of a module; KeyError if there is none."""
        return self.texts[str(self._path(fullname))]

    def _path(self, fullname: str) -> str | None:
        stem = "/".join((PACKAGE, *fullname.split(".")[1:]))
        return next((path for path in (f"{stem}/__init__.py", f"{stem}.py") if path in self.texts), None)


@contextmanager
def imported(texts: Mapping[str, str]) -> Iterator[str]:
    """The name under which the modules of a package can be imported from their texts, while this lasts."""
    name = f"_emitted_{sha256(repr(sorted(texts.items())).encode()).hexdigest()[:16]}"
    finder = Texts(name, texts)
    sys.meta_path.insert(0, finder)
    try:
        yield name
    finally:
        sys.meta_path.remove(finder)
        for known in [known for known in sys.modules if known.partition(".")[0] == name]:
            del sys.modules[known]


@contextmanager
def loaded(texts: Mapping[str, str], module: str) -> Iterator[Any]:
    """The module at a path, with the rest of its package, under a name of its own."""
    with imported(texts) as name:
        yield import_module(".".join((name, *PurePosixPath(module).with_suffix("").parts[1:])))


def form(source: str, function: str) -> tuple[str, list[int]]:
    """How a function of a module is evaluated, and the node counts its rules state.

    `rule` with nodes, `root` by iteration, `kernel` (a fitted or special function) or `closed`;
    a rule without stated nodes takes what the length of its interval asks for.
    """
    bodies = {node.name: node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)}
    names, nodes, pending, seen = set[str](), set[int](), [function], set[str]()
    while pending:
        body = bodies[pending.pop()]
        seen.add(body.name)
        names |= {node.id for node in ast.walk(body) if isinstance(node, ast.Name)}
        nodes |= _stated(body)
        pending += [name for name in names & set(bodies) if name not in seen and name not in pending]
    kernels = names & KERNELS
    if any(map(is_rule, names)) or kernels & ARRAYS:
        kind = "rule"
    else:
        kind = "kernel" if kernels else "closed"
    return ("root" if names & ITERATIONS else kind), sorted(nodes)


def is_rule(name: str) -> bool:
    """Whether a function of the runtime sums an integrand."""
    return name in STRIPS or any(word in name for word in RULES)


def _stated(body: ast.FunctionDef) -> set[int]:
    calls = (node for node in ast.walk(body) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name))
    rules = (call for call in calls if is_rule(call.func.id))  # type: ignore[attr-defined]
    last = (call.args[-1] for call in rules if call.args)
    return {arg.value for arg in last if isinstance(arg, ast.Constant) and isinstance(arg.value, int)}


def closure(sources: Mapping[str, str], *modules: str) -> dict[str, str]:
    """The texts of modules, of all they import from the package, of their programs, and of the packages around them.

    A package stands for its name alone, with an empty text, unless it is imported to ask it for one of its modules.
    """
    found: dict[str, str] = {}
    pending = list(modules)
    while pending:
        path = pending.pop()
        found[path] = sources[path]
        others = [*_imported(sources, path), *_programs(sources, path)]
        pending += [other for other in others if other not in found and other not in pending]
    packages = {f"{parent}/__init__.py" for path in found for parent in PurePosixPath(path).parents if parent.name}
    return dict(sorted({**dict.fromkeys(packages, ""), **found}.items()))


def _programs(sources: Mapping[str, str], path: str) -> Iterator[str]:
    """What is evaluated for a module, which is imported with the first call."""
    program = path.replace("/", "/_programs/", 1)
    if program in sources and "/_programs/" not in path:
        yield program


def _imported(sources: Mapping[str, str], path: str) -> Iterator[str]:
    imports, asked = _imports(sources[path])
    for level, module, names in imports:
        folder = PurePosixPath(path).parents[level - 1]
        base = folder.joinpath(*module.split(".")) if module else folder
        for target in (base, *(base / name for name in names)):
            if f"{target}.py" in sources:
                yield f"{target}.py"
        for name in names:
            if f"{base}/{name}/__init__.py" in sources:
                yield f"{base}/{name}/__init__.py"
                modules = (f"{base}/{name}/{attribute}.py" for owner, attribute in asked if name == owner)
                yield from sorted(module for module in modules if module in sources)


_IMPORT = re.compile(r"^ *from (\.+)([\w.]*) import (?:\(([^)]*)\)|(.*))$", re.MULTILINE)


@cache
def _imports(text: str) -> tuple[list[tuple[int, str, list[str]]], set[tuple[str, str]]]:
    """The relative imports as a formatter leaves them, and what may be attributes; to parse all modules took 8 s."""
    found = [(len(dots), module, (several or one).split(",")) for dots, module, several, one in _IMPORT.findall(text)]
    imports = [(level, module, [name.split()[0] for name in names if name.strip()]) for level, module, names in found]
    return imports, set(re.findall(r"\b(\w+)\.(\w+)", text))


ELEMENTARY = (
    sp.exp, sp.log, sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan, sp.sinh, sp.cosh, sp.tanh, sp.asinh, sp.acosh,
    sp.atanh,
)  # fmt: skip


def naive(entry: Entry) -> Callable[[Floats], float] | None:
    """The value at a point by the formula of its region; None where there is none, or NumPy lacks a function of it."""
    if entry.status != "closed" or entry.composed is not None:
        return None
    short = dict(entry.profile.abbreviations)
    exprs = [case.expr.subs(short) for case in entry.cases]
    if any(expr.has(sp.Integral, sp.Sum) or not expr.atoms(sp.Function) <= _elementary(expr) for expr in exprs):
        return None
    symbols = sorted(set[Any]().union(*(expr.free_symbols for expr in exprs)), key=str)
    functions = [sp.lambdify(symbols, expr, "numpy") for expr in exprs]

    def value(values: Floats) -> float:
        known = {str(symbol): number for symbol, number in values.items()}
        chosen = next((i for i, case in enumerate(entry.cases) if _holds(case, short, known)), None)
        if chosen is None:
            return float("nan")
        with np.errstate(all="ignore"):
            return float(functions[chosen](*(np.float64(known[str(symbol)]) for symbol in symbols)))

    return value


def _elementary(expr: sp.Expr) -> set[sp.Expr]:
    return {call for call in expr.atoms(sp.Function) if isinstance(call, ELEMENTARY)}


def _holds(case: Case, short: dict[sp.Symbol, sp.Expr], known: dict[str, float]) -> bool:
    lengths = [sp.sympify(x).subs(short) for x in case.chain]
    sizes = [float(x.subs({symbol: known[str(symbol)] for symbol in x.free_symbols})) for x in lengths]
    return all(low < high for low, high in zip(sizes, sizes[1:], strict=False))
