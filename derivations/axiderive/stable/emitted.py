"""Emitted modules straight from their texts, without files, and what their functions rest on."""

from __future__ import annotations

import ast
import sys
from collections.abc import Mapping
from contextlib import contextmanager
from hashlib import sha256
from importlib import abc, import_module, machinery
from pathlib import PurePosixPath
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

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
        if fullname.partition(".")[0] != self.name or self._path(fullname) is None:
            return None
        return machinery.ModuleSpec(fullname, self, is_package=self.is_package(fullname))

    def is_package(self, fullname: str) -> bool:
        return str(self._path(fullname)).endswith("__init__.py")

    def get_source(self, fullname: str) -> str:
        return self.texts[str(self._path(fullname))]

    def _path(self, fullname: str) -> str | None:
        stem = "/".join((PACKAGE, *fullname.split(".")[1:]))
        return next((path for path in (f"{stem}/__init__.py", f"{stem}.py") if path in self.texts), None)


@contextmanager
def loaded(texts: Mapping[str, str], module: str) -> Iterator[Any]:
    """The module at a path, with the rest of its package, under a name of its own."""
    name = f"_emitted_{sha256(repr(sorted(texts.items())).encode()).hexdigest()[:16]}"
    finder = Texts(name, texts)
    sys.meta_path.insert(0, finder)
    try:
        yield import_module(".".join((name, *PurePosixPath(module).with_suffix("").parts[1:])))
    finally:
        sys.meta_path.remove(finder)
        for known in [known for known in sys.modules if known.partition(".")[0] == name]:
            del sys.modules[known]


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
