"""What runs on a user's machine, written by the build as plain source: `axicontact/_programs`.

A module of programs stands beside every module whose functions are evaluated: flat functions of `math` for plain
numbers (`plain`), NumPy's functions block by block (`blocks`), and the same as expressions of any array library
(`expressions`, where functions call one another: `sharing`, with stand-ins of what looks at its data: `standing`).
All three are written from one graph (`graph`); what iterates keeps its text (`bodies`).
"""

from __future__ import annotations

import ast
import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from types import FunctionType, ModuleType

from ...stable.measure import imported
from ..module import PACKAGE, PLACE
from .blocks import Blocks
from .bodies import CALLED, OF_MATH, Twins
from .graph import Lengths, Node, needed, trace
from .plain import LARGE, ORDINARY, SMALL, TRUSTED, Lines, function, is_sum, settled
from .sharing import Shared

FOLDER = "_programs"
WORDS = frozenset(("control", "A"))
"""Arguments that are no numbers: what is held at pull-off, and the coefficients of a polynomial."""
EVALUATING = ("elementwise", "even", "odd")
"""Functions of the run time whose first argument is a formula, and whose further ones are its arguments."""
REACH, REQUIRE = "require_reach", "require"
"""What asks that its first argument is not below the second, and that parameters are inside their domains."""


@dataclass(frozen=True)
class Call:
    """A formula as a public function calls it."""

    formula: FunctionType
    fields: tuple[str, ...]
    keywords: tuple[str, ...]
    orders: tuple[tuple[str, str], ...]
    """Arguments of which the public function asks that the first is not above the second."""
    unused: tuple[str, ...]
    """Arguments of the public function that the formula does not need, but whose ranges are asked for."""
    signed: tuple[str, ...]
    """Loads of either sign: neither fields, which are NaN where they are negative, nor parameters that are required."""
    negative: tuple[str, ...]
    """Those that the public function takes by place, beside parameters that are checked together and positive."""
    words: tuple[str, ...]
    """Arguments that are no numbers."""

    def order(self) -> tuple[object, ...]:
        """By name, and the same in every run."""
        return self.formula.__name__, self.fields, self.keywords, self.orders, self.unused, self.signed, self.words


def program_sources(texts: Mapping[str, str]) -> dict[str, str]:
    """The programs for the modules of a package, as `{path: text}` for `{path: text}`.

    The package is imported under a name of its own, and every formula that a public function evaluates is run once with
    objects that record what is done to them.
    """
    files: dict[str, str] = {}
    with imported(texts) as package:
        sources = {_dotted(path): text for path, text in texts.items() if path.endswith(".py")}
        inside = import_module(f"{package}.{PLACE}.intervals").INSIDE
        twins = Twins(package, sources)
        calls: dict[str, set[Call]] = {}
        public: list[str] = []
        for path in sorted(sources):
            if path and not path.startswith((PLACE, FOLDER)):
                public.append(path)
                for call in _calls(import_module(f"{package}.{path}"), sources[path]):
                    calls.setdefault(call.formula.__module__.removeprefix(f"{package}."), set()).add(call)
        for path, found in sorted(calls.items()):
            module = _Module(path, found, inside, twins)
            if text := module.text():
                files[_path(f"{FOLDER}.{path}")] = text
        shared = Shared({path: import_module(f"{package}.{path}") for path in sources if path})
        shared.add({path: _single(import_module(f"{package}.{path}"), sources[path]) for path in public})
        files |= {_path(path): text for path, text in (twins.sources() | shared.sources()).items()}
    files |= {f"{folder}/__init__.py": "" for path in [*files] for folder in _folders(path)}
    return dict(sorted((files | {f"{PACKAGE}/{FOLDER}/__init__.py": README}).items()))


README = '''"""What is evaluated for plain numbers, blocks of arrays and other array libraries, written by the build.

For `_pressure` of `axicontact/normal/cone.py` there are in `normal/cone.py` of this folder `pressure` for plain
numbers, `prepare_...` and `block_...` for arrays, and below `expressions` the same for any array library.  What
iterates stands below `bodies`, with `math` in the place of NumPy.
"""
'''


def _dotted(path: str) -> str:
    parts = path.removesuffix(".py").split("/")[1:]
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _path(dotted: str) -> str:
    return f"{PACKAGE}/{dotted.replace('.', '/')}.py"


def _folders(path: str) -> Iterator[str]:
    parts = path.split("/")
    for count in range(2, len(parts)):
        yield "/".join(parts[:count])


def _calls(module: ModuleType, text: str) -> Iterator[Call]:
    """The formulas that the functions of a module evaluate."""
    for own, calls in _functions(text):
        reaching = [call.args for name, call in calls if name == REACH]
        orders = tuple((ast.unparse(least), ast.unparse(radius)) for radius, least, *_ in reaching)
        required = {k.arg for name, call in calls if name == REQUIRE for k in call.keywords}
        for name, call in calls:
            if name not in EVALUATING:
                continue
            named, words = _bound(call.args[0])
            formula = _named(module, named)
            if formula is not None and WORDS.issuperset(words):
                keywords = tuple(str(k.arg) for k in call.keywords if k.arg != "unused")
                apart = [part for k in call.keywords if k.arg == "unused" for part in ast.walk(k.value)]
                unused = tuple(part.id for part in apart if isinstance(part, ast.Name))
                fields = _arguments(formula)[: len(call.args) - 1]
                signed = () if fields else tuple(name for name in keywords if name not in required)
                placed = own.args.args if own.args.kwonlyargs else []
                negative = tuple(one.arg for one in placed if one.arg in signed)
                yield Call(formula, fields, keywords, orders, unused, signed, negative, words)


@lru_cache(maxsize=1024)
def _functions(text: str) -> list[tuple[ast.FunctionDef, list[tuple[str, ast.Call]]]]:
    """The functions of a module with all calls in them, by the names that are called."""
    found = []
    for own in (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)):
        calls = [node for node in ast.walk(own) if isinstance(node, ast.Call)]
        found.append((own, [(call.func.id, call) for call in calls if isinstance(call.func, ast.Name)]))
    return found


def _single(module: ModuleType, text: str) -> dict[str, FunctionType]:
    """The formulas of the functions of a module that evaluate one, by the names of these."""
    found: dict[str, FunctionType] = {}
    for public, calls in _functions(text):
        evaluated = [call for name, call in calls if name in EVALUATING]
        if public.name.startswith("_"):
            continue
        if len(evaluated) == 1:
            formula = _named(module, _bound(evaluated[0].args[0])[0])
        elif isinstance(own := public.body[-2:][0], ast.ImportFrom):
            # what another contact has too
            home = import_module(f"{'.' * own.level}{own.module}.{own.names[0].name}", module.__package__)
            formula = getattr(home, f"_{public.name}", None)
        else:
            continue
        found |= {public.name: formula} if formula else {}
    return found


def _arguments(formula: FunctionType) -> tuple[str, ...]:
    return formula.__code__.co_varnames[: formula.__code__.co_argcount]


def _named(module: ModuleType, node: ast.expr) -> FunctionType | None:
    """The function that a name, or an attribute of a module, stands for."""
    if isinstance(node, ast.Name):
        found = getattr(module, node.id, None)
    elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
        found = getattr(getattr(module, node.value.id), node.attr)
    else:
        return None
    return found if isinstance(found, FunctionType) and found.__closure__ is None else None


def _bound(node: ast.expr) -> tuple[ast.expr, tuple[str, ...]]:
    """A formula, and the names of its arguments that a `partial` binds."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "partial":
        return node.args[0], tuple(str(keyword.arg) for keyword in node.keywords)
    return node, ()


class _Module:
    """The programs of one module."""

    def __init__(
        self, path: str, calls: Collection[Call], inside: Mapping[str, tuple[float, float]], twins: Twins
    ) -> None:
        self.path, self.inside, self.twins = path, inside, twins
        self.calls: dict[str, list[Call]] = {}
        for call in sorted(calls, key=Call.order):
            self.calls.setdefault(call.formula.__name__, []).append(call)
        self.rules: dict[Lengths, str] = {}
        self.constants: dict[str, str] = {}
        self.records: list[str] = []
        self.texts: list[str] = []
        self.bodies: set[str] = set()

    def text(self) -> str:
        """The module, empty if nothing can be written."""
        for name, calls in self.calls.items():
            arguments = _arguments(calls[0].formula)
            words = calls[0].words
            result = None if words else trace(calls[0].formula, arguments, ())
            self._plain(name, calls, arguments, result)
            if result is not None and not any(map(is_sum, needed(result))):
                for fields, keywords in dict.fromkeys((call.fields, call.keywords) for call in calls):
                    self._blocks(name, fields, (*fields, *keywords), result)
        if not self.texts:
            return ""
        records = [f"BLOCKS = {{\n{chr(10).join(self.records)}\n}}"] if self.records else []
        return "\n\n\n".join([self._head(), *(text.rstrip("\n") for text in self.texts), *records]) + "\n"

    def _plain(self, name: str, calls: list[Call], arguments: tuple[str, ...], result: Node | None) -> None:
        unused = dict.fromkeys(name for call in calls for name in call.unused)
        words = calls[0].words
        ranges = {own: self._range(own) for own in (*arguments, *unused) if own not in words}
        if result is not None:
            ranges |= dict.fromkeys((name for call in calls for name in call.negative), (-LARGE, LARGE))
            lines = Lines(result, ranges, self.rules).text()
        elif self.twins.add(calls[0].formula):
            self.bodies.add(name)
            signed = [name for call in calls for name in call.signed]
            ranges |= dict.fromkeys(signed, (-LARGE, LARGE))
            sure = settled(ranges, vanishing=bool(words or signed))
            lines = [f"value = bodies.{name}({', '.join(arguments)})", *TRUSTED, *sure]
        else:
            return
        orders = dict.fromkeys(order for call in calls for order in call.orders if ranges.keys() >= {*order})
        relations = [f"{low} <= {high}" for low, high in orders]
        self.texts.append(function(name.removeprefix("_"), ranges, relations, lines, tuple(unused), words))

    def _range(self, name: str) -> tuple[float, float]:
        low, high = self.inside.get(name, (SMALL, LARGE))
        return max(SMALL, low), min(LARGE, high)

    def _blocks(self, name: str, fields: tuple[str, ...], names: tuple[str, ...], result: Node) -> None:
        """The programs for the first field, all fields and all arguments as arrays."""
        records = []
        for arrays in dict.fromkeys((fields[:1], fields, names)):
            if arrays:
                writer = Blocks(result, names, arrays, fields, self.constants)
                own = "_".join([name.removeprefix("_"), *(["all"] if arrays == names else arrays)])
                own += "_signed" * (not fields)
                self.texts.append(writer.written(own))
                records.append(f"        {arrays!r}: {writer.record(own)},")
        if records:
            self.records += [f"    {(name, len(fields), *names)!r}: {{", *records, "    },"]

    def _head(self) -> str:
        level = "." * (self.path.count(".") + 2)
        values = [f"{name} = np.array({value})" for value, name in self.constants.items()]
        values += [f"{name} = rule({lengths!r})" for lengths, name in self.rules.items()]
        text = "\n".join([*values, *self.texts])
        math_names = sorted({name for pair in re.findall(CALLED, text) for name in pair} & OF_MATH)
        lines = [f'"""Programs of {PACKAGE}.{self.path}."""', "", "from __future__ import annotations", ""]
        lines += [f"from math import {', '.join(math_names)}", ""] if math_names else []
        lines += ["import numpy as np", ""] if self.records else []
        used = [name for name, asked in (("largest", self.records), (ORDINARY, f"{ORDINARY}(" in text)) if asked]
        lines += [f"from {level}{PLACE}.interface import {', '.join(used)}"] if used else []
        lines += [f"from {level}{PLACE}.plain import rule"] if self.rules else []
        if self.bodies:
            folder, _, name = f"bodies.{self.path}".rpartition(".")
            lines.append(f"from {level}{FOLDER}.{folder} import {name} as bodies")
        return "\n".join([*lines, *([""] + values if values else [])])
