"""What a module holds and imports: nothing that its public functions do not reach."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from .layout import HELPERS_OF, LINE, from_import
from .private import Private, PrivateFunctions

RUNTIME = Path(__file__).parents[1] / "runtime"
"""The hand-written NumPy, a package that is copied as it stands."""
PLACE = "_runtime"
"""Its name in the generated package."""
OUTSIDE = "expressions.py"
"""The one public module of the run time, which stands beside it."""


@dataclass
class Public:
    """One public function as the template prints it."""

    signature: str
    summary: str
    doc: list[str]
    body: list[str]
    plain: bool = False
    """Whether it asks the function over plain numbers first."""


PLAIN = "Plain"
PEAK = ("PeakPressure", "peak_share")
CALLED = {
    "functions": HELPERS_OF["functions"],
    "integrals": ("difference_root",),
    "interface": ("require", "require_coefficients", "require_order", "require_reach"),
    "inverse": ("between", "inverse", "inverse_below"),
    "shapes.across": ("inverse_across", "inverse_beyond"),
    "shapes.arcs": ("arc_strips",),
    "shapes.powers": ("power_displacement", "power_pressure", "power_punches"),
    "shapes.ring": (
        "outside_zero_pressure", "ring_of_greatest_pressure", "ring_of_zero_pressure", "rise_to_greatest_pressure",
    ),
    "shapes.waves": ("inverse_over_waves",),
    "special": (*HELPERS_OF["special"], *PEAK),
}  # fmt: skip
"""What a module of normal contact may call of the run time, by its files."""
RATES = ("_slope", "_slope_beyond")


def runtime_sources() -> dict[str, str]:
    """The hand-written files by their path in the generated package."""
    texts = {path.relative_to(RUNTIME).as_posix(): path.read_text() for path in sorted(RUNTIME.rglob("*.py"))}
    public = re.sub(r"^from \.", f"from .{PLACE}.", texts.pop(OUTSIDE), flags=re.MULTILINE)
    return {OUTSIDE: public} | {f"{PLACE}/{path}": text for path, text in texts.items()}


@dataclass
class ModuleText:
    """One module as the template prints it."""

    title: str
    text: str
    imports: list[str] = field(default_factory=list)
    public: list[Public] = field(default_factory=list)
    private: list[dict[str, object]] = field(default_factory=list)

    @property
    def plain(self) -> bool:
        """Whether a function of it asks the functions over plain numbers."""
        return any(function.plain for function in self.public)

    @property
    def interface(self) -> list[str]:
        """The lines of `__all__` and `__dir__`, which name the public functions."""
        return interface([re.match(r"def (\w+)", function.signature)[1] for function in self.public])  # type: ignore[index]


def interface(functions: Sequence[str]) -> list[str]:
    """The lines that say what a module is there for: its public functions, for `import *` and for `dir`."""
    names = [f'"{name}"' for name in sorted(functions)]
    line = f"__all__ = [{', '.join(names)}]"
    listed = [line] if len(line) <= LINE else ["__all__ = [", *(f"    {name}," for name in names), "]"]
    return [*listed, "", "", "def __dir__() -> list[str]:", "    return __all__"]


def is_used(private: Private, module: ModuleText, functions: PrivateFunctions) -> bool:
    """Whether a public function calls it, directly or through others, or another physics its rate of growth."""
    if private.name in RATES:
        return True
    reached, pending = set(), _names("\n".join(line for function in module.public for line in function.body))
    while pending:
        name = pending.pop()
        if name not in reached:
            reached.add(name)
            pending |= set().union(
                *(_names("\n".join(p.lines)) for p in functions.functions.values() if p.name == name)
            )
    return private.name in reached


def _names(text: str) -> set[str]:
    return set(re.findall(r"\b_\w+", text))


def imports(module: ModuleText) -> list[str]:
    """The import lines of a module; of the runtime it imports what its code calls."""
    text = "\n".join([*(str(line) for function in module.private for line in function["lines"])])  # type: ignore[attr-defined]
    text += "\n".join(line for function in module.public for line in function.body)
    tools = [name for name in ("partial", "reduce") if f"{name}(" in text]
    blocks = [f"from functools import {', '.join(tools)}"] if tools else []
    blocks += ["from typing import TYPE_CHECKING", ""]
    if "np." in text:
        blocks.append("import numpy as np")
    blocks.append("")
    used = {file: [name for name in names if re.search(rf"\b{name}\(", text)] for file, names in CALLED.items()}
    used["interface"] += ["Array", "Result", "elementwise", *([PLAIN] if module.plain else [])]
    used["rules"] = [name for name in _rule_names() if re.search(rf"\b{name}\(", text)]
    used["kernels"] = re.findall(r"\bOUTSIDE_\d+", text)
    for file in sorted(file for file, names in used.items() if names):
        blocks += from_import(f"..{PLACE}.{file}", used[file])
    return [*blocks, "", "if TYPE_CHECKING:", "    from numpy.typing import ArrayLike"]


@cache
def _rule_names() -> tuple[str, ...]:
    text = (RUNTIME / "rules.py").read_text()
    return tuple(re.findall(r"^def (\w+_integral\w*)\(", text, re.MULTILINE))
