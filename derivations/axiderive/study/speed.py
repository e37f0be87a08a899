"""What a call costs: the emitted functions beside the printed formula in `math` and NumPy, and beside a mere copy."""

from __future__ import annotations

import math
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from importlib import import_module
from itertools import chain
from types import ModuleType
from typing import Any

import numpy as np
import sympy as sp

from ..build.pool import Jobs, run
from ..code.programs.graph import Lengths, trace
from ..code.programs.plain import LARGE, SMALL, TRUSTED, Lines
from ..entry import FOUR, Entry
from .error import arguments
from .naive import naive
from .report import Record, paired, rounded, table, versions
from .subject import NAMES, PARAMETERS, RADIUS, Subject, subject

POINTS = 24
SIZES = (10_000, 1_000_000)
LARGEST = 10_000_000
"""Points of the array that is copied: far more than the caches hold."""
ROUNDS = 7
IMPORTS = ("axicontact.normal.cone", "axicontact.normal.sphere", "axicontact.graded.normal.power_law")
SCRIPT = """
import sys, time
start = time.process_time()
import numpy
between = time.process_time()
import {module}
print((time.process_time() - between) / (between - start))
"""
NOTE = (
    "Medians over interleaved repeats in one run of ratios of processor times, two digits. scalar: a call with plain "
    "numbers over that of a function with the same signature that returns the printed formula in `math`; steps: over "
    "that of one that takes the steps of the call itself in `math`, without checks; arrays: over the printed formula "
    "by sympy.lambdify for NumPy; copy: over np.copyto of as many numbers; fresh: a copy into a new array over "
    "np.copyto; imports: over the import of NumPy, in a process of its own. Functions whose printed formula `math` can "
    "evaluate."
)


KNOWN = NAMES


def measure(names: Sequence[str] = KNOWN, *, quick: bool = False, jobs: Jobs = 1) -> Record:
    """The record of the study."""
    rounds, sizes, largest = (1, (100, 200), 1000) if quick else (ROUNDS, SIZES, LARGEST)
    found = run(_rows, [(name, rounds, sizes, largest) for name in names], jobs, ordered=True)
    return {
        "study": "speed",
        "note": NOTE,
        "settings": {"rounds": rounds, "sizes": list(sizes), "largest": largest, "versions": versions()},
        "rows": list(chain.from_iterable(found)),
        "fresh": rounded(_copy(np.copy, np.ones(largest), rounds)),
        "imports": [{"module": module, "ratio": rounded(_import(module, rounds))} for module in IMPORTS],
    }


def _rows(name: str, rounds: int, sizes: Sequence[int], largest: int) -> list[Record]:
    return list(_timed(subject(name), rounds, sizes, largest))


def _timed(subject: Subject, rounds: int, sizes: Sequence[int], largest: int) -> Iterator[Record]:
    module = import_module(f"{subject.problem.system.package}.{subject.problem.name}")
    for suffix in FOUR:
        entry = subject.entries[suffix]
        field = entry.quantity.arguments[0]
        values = {symbol: PARAMETERS.get(symbol, RADIUS) for symbol in (*entry.parameters, *entry.quantity.arguments)}
        points = arguments(subject, suffix, POINTS) if suffix in "pw" else np.linspace(0.75, 1.25, POINTS) * RADIUS
        middle = float(points[POINTS // 2])
        bare = in_math(entry, values | {field: middle})
        if bare is None:
            continue
        own, plain = called(getattr(module, entry.quantity.function), entry, values), naive(entry, subject.entries)
        naively = partial(_naively, plain, values, field)
        yield {
            "key": entry.key,
            "scalar": rounded(ratio(own, called(bare, entry, values), middle, rounds)),
            "steps": rounded(ratio(own, called(in_steps(entry, module), entry, values), middle, rounds)),
            "arrays": [rounded(ratio(own, naively, np.resize(points, size), rounds)) for size in sizes],
            "copy": rounded(_copy(own, np.resize(points, largest), rounds)),
        }


def _naively(plain: Callable[..., Any], values: dict[sp.Symbol, float], field: sp.Symbol, x: Any) -> Any:
    return plain({**values, field: x})


def called(function: Callable[..., Any], entry: Entry, values: dict[sp.Symbol, float]) -> Callable[[Any], Any]:
    """The function of its first argument; a call costs the same whatever the function does."""
    _, *others = entry.quantity.arguments
    rest = [values[symbol] for symbol in others]
    keywords = {str(symbol): values[symbol] for symbol in entry.parameters if symbol not in entry.quantity.arguments}
    return lambda x: function(x, *rest, **keywords)


def in_math(entry: Entry, point: dict[sp.Symbol, float]) -> Callable[..., float] | None:
    """The region of the printed formula at a point as a function with the signature of the emitted one.

    None where the formula has a function that `math` lacks.
    """
    expr = next(own for pairs, own in entry.regions() if all(low.subs(point) < high.subs(point) for low, high in pairs))
    try:
        text = sp.pycode(expr, fully_qualified_modules=True)
    except NotImplementedError:
        return None
    if "Not supported" in text:
        return None
    return _bare(entry, [f"return {text}"], {"math": math})


def in_steps(entry: Entry, module: ModuleType) -> Callable[..., float]:
    """The evaluation form of an emitted function in `math`, as its program takes it, with nothing around it.

    Raises
    ------
    LookupError
        If the form cannot be written for plain numbers.
    """
    private = getattr(module, f"_{entry.quantity.function}")
    names = private.__code__.co_varnames[: private.__code__.co_argcount]
    result, rules = trace(private, names, ()), dict[Lengths, str]()
    if result is not None:
        text = Lines(result, dict.fromkeys(names, (SMALL, LARGE)), rules).text()
        return _bare(entry, [line.replace(TRUSTED[0], "if True:") for line in text], _space(rules))
    programs = import_module("axicontact._runtime.interface").programs
    twin = getattr(programs(module.__name__, "bodies."), private.__name__, None)
    if twin is None:
        message = f"{entry.key} has no form for plain numbers; leave it out of the study of calls"
        raise LookupError(message)
    return _bare(entry, [f"return twin({', '.join(names)})"], {"twin": twin})


def _space(rules: Mapping[Lengths, str]) -> dict[str, Any]:
    """The names that the lines of a formula use."""
    rule = import_module("axicontact._runtime.plain").rule
    known = {name: value for name, value in vars(math).items() if not name.startswith("_")}
    return known | {name: rule(lengths) for lengths, name in rules.items()}


def _bare(entry: Entry, lines: Sequence[str], names: dict[str, Any]) -> Callable[..., float]:
    """These lines of the catalogue as a function with the signature of the emitted one."""
    fields = [str(symbol) for symbol in entry.quantity.arguments]
    keywords = [str(symbol) for symbol in entry.parameters if str(symbol) not in fields]
    head = f"def bare({', '.join([*fields, '*', *keywords])}):"
    exec("\n    ".join([head, *lines]), names)
    bare: Callable[..., float] = names["bare"]
    return bare


def ratio(own: Callable[[Any], Any], other: Callable[[Any], Any], x: Any, rounds: int) -> float:
    """Time of one function over that of the other, both at x."""
    return paired(partial(own, x), partial(other, x), rounds)


def _copy(own: Callable[[Any], Any], x: Any, rounds: int) -> float:
    out = np.empty_like(x)
    return ratio(own, lambda values: np.copyto(out, values), x, rounds)


def _import(module: str, rounds: int) -> float:
    """What the module adds to the import of NumPy, both compiled by a run before."""
    script = [sys.executable, "-c", SCRIPT.format(module=module)]
    with tempfile.TemporaryDirectory(prefix="axicontact-bytecode-") as folder:
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
        environment["PYTHONPYCACHEPREFIX"] = folder
        runs = [
            subprocess.run(script, env=environment, check=True, capture_output=True).stdout for _ in range(rounds + 1)
        ]
    return statistics.median(map(float, runs[1:]))


def text(record: Record) -> str:
    """One line for each function, one for each import."""
    sizes = [f"naive, {size} points" for size in record["settings"]["sizes"]]
    head = ("key", "scalar/math", "own steps", *sizes, f"np.copyto, {record['settings']['largest']} points")
    rows = [(row["key"], row["scalar"], row["steps"], *row["arrays"], row["copy"]) for row in record["rows"]]
    imports = [f"import {row['module']}: {row['ratio']} of the import of NumPy more" for row in record["imports"]]
    fresh = f"a copy into a new array: {record['fresh']} of np.copyto"
    return "\n".join([table(head, rows), fresh, *imports])
