"""A generated module: its functions, and the imports of what they use."""

from __future__ import annotations

import ast
import re
import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from ..physics.consequences import CONSEQUENCES
from ..physics.systems import Problem, System
from .function import LINE, Function, from_import
from .tables import KERNELS, STARTS

PACKAGE = "axicontact"
RUNTIME = Path(__file__).parents[1] / "runtime"
"""The hand-written NumPy, a package that is copied as it stands."""
PLACE = "_runtime"
"""Its name in the generated package."""
OUTSIDE = "expressions.py"
"""The one public module of the run time, which stands beside it."""
COMMON = (
    *("functions", "integrals", "interface", "inverse", "kernels", "rules", "special"),
    *("shapes.across", "shapes.arcs", "shapes.powers", "shapes.ring", "shapes.waves"),
    *(f"shapes.{own.compact.function}" for own in CONSEQUENCES.values()),
)
"""Files of the run time that any module may call."""
GRADED = tuple(f"graded.{file.stem}" for file in sorted((RUNTIME / "graded").glob("[a-z]*.py")))
LATE = (
    *("physics.stable", "physics.unknowns"),
    *("graded.displacement", "graded.inverse", "graded.pressure", "graded.slip"),
)
"""Imported by the functions of a graded half-space that call them: the import of a module brings along what its depth
and its force need."""
TOOLS, PLAIN = {"partial", "reduce"}, "Plain"
FUTURE = "from __future__ import annotations"
FAMILY = '''"""{title}."""

from __future__ import annotations

from importlib import import_module
from typing import Any

__all__ = [
{names}
]


def __getattr__(name: str) -> Any:
    if name in __all__:
        return import_module(f".{{name}}", __name__)
    message = f"module {{__name__!r}} has no {member} {{name!r}}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
'''


def runtime_sources() -> dict[str, str]:
    """The hand-written files by their path in the generated package."""
    texts = {path.relative_to(RUNTIME).as_posix(): path.read_text() for path in sorted(RUNTIME.rglob("*.py"))}
    public = re.sub(r"^from \.", f"from .{PLACE}.", texts.pop(OUTSIDE), flags=re.MULTILINE)
    return {OUTSIDE: public} | {f"{PLACE}/{path}": text for path, text in texts.items()}


def package_source(title: str, names: Sequence[str], member: str = "member") -> str:
    """The text of a package that imports each of its modules when it is first asked for."""
    return FAMILY.format(title=title, names="\n".join(f'    "{name}",' for name in names), member=member)


@dataclass
class Module:
    """A module: the public functions of a system for one profile, and the private ones below them."""

    system: System
    name: str
    title: str
    text: str
    public: Sequence[Function]
    private: Sequence[Function]

    @property
    def path(self) -> str:
        """Its place below catalogue/."""
        return Problem(self.system, self.name).module

    @property
    def parameters(self) -> dict[str, list[str]]:
        """What each private function takes."""
        return {function.name: function.parameters for function in self.private}

    def source(self) -> str:
        """The whole text."""
        functions = [*self.public, *self.private]
        used = frozenset[str]().union(*(function.uses for function in functions))
        tools = ", ".join(sorted(used & TOOLS))
        lines = [f'"""{self.title}.', "", *textwrap.wrap(self.text, 110), '"""', "", FUTURE, ""]
        lines += [f"from functools import {tools}"] if tools else []
        lines += ["from typing import TYPE_CHECKING", "", *(["import numpy as np", ""] if "np" in used else [])]
        lines += self._imports(used, late=False)
        lines += ["", "if TYPE_CHECKING:", "    from numpy.typing import ArrayLike", "", *self._interface()]
        bodies = [function.text(self._imports(function.uses, late=True)) for function in functions]
        return "\n".join([*lines, "", "", "\n\n".join(bodies)])

    def _interface(self) -> list[str]:
        """What the module is there for, for `import *` and for `dir`."""
        if not self.public:
            return []
        names = sorted(function.name for function in self.public)
        quoted = [f'"{name}"' for name in names]
        line = f"__all__ = [{', '.join(quoted)}]"
        lines = [line] if len(line) <= LINE else ["__all__ = [", *(f"    {name}," for name in quoted), "]"]
        lines += ["", "", "def __dir__() -> list[str]:", "    return __all__"]
        return [*lines, "", "", f"plain = {PLAIN}(__name__, __all__)"] if self._programmed else lines

    @property
    def _programmed(self) -> bool:
        """Whether its functions ask for their programs over plain numbers first."""
        return any("plain" in function.uses for function in self.public)

    def _imports(self, used: Iterable[str], *, late: bool) -> list[str]:
        """The imports of these names at the top of the module, or inside the function that uses them."""
        graded = self.system.medium.graded
        up = "." * self.path.count("/")
        known = names_of((*(GRADED if graded else ()), *self.system.physics.runtime, *COMMON))
        found: dict[str, list[str]] = {}
        for name in [*used, *([PLAIN] if self._programmed and not late else [])]:
            file = known.get(name)
            if file is not None and (graded and file in LATE) == late:
                found.setdefault(file, []).append(name)
        lines = [line for file in sorted(found) for line in from_import(f"{up}{PLACE}.{file}", found[file])]
        # of the normal contact a module on it needs all, a graded one of its own the shape of the indenter alone
        if "normal" in used and late == (self.system.base is None):
            lines.append(f"from {up if late else '..'}normal import {self.name} as normal")
        return lines


@cache
def names_of(files: tuple[str, ...]) -> dict[str, str]:
    """The names that files of the run time define, each with its file: of two of one name the first."""
    found: dict[str, str] = {}
    for file in files:
        for name in _defined(file):
            found.setdefault(name, file)
    return found


@cache
def _defined(file: str) -> list[str]:
    if file == "kernels":
        return [*KERNELS, *STARTS]
    tree = ast.parse((RUNTIME / f"{file.replace('.', '/')}.py").read_text())
    stored = [node for line in tree.body if isinstance(line, (ast.Assign, ast.AnnAssign)) for node in ast.walk(line)]
    values = [node.id for node in stored if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)]
    names = [*values, *(line.name for line in tree.body if isinstance(line, (ast.FunctionDef, ast.ClassDef)))]
    return [name for name in names if not name.startswith("_")]
