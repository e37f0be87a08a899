"""What a module holds and imports: nothing that its public functions do not reach."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from .layout import HELPERS_OF, LINE
from .private import Private, PrivateFunctions

RUNTIME = Path(__file__).parents[1] / "runtime"


@dataclass
class Public:
    """One public function as the template prints it."""

    signature: str
    summary: str
    doc: list[str]
    body: list[str]
    decorator: str = ""


WITH_MATH = "with_math"
POWERS = ("power_displacement", "power_pressure", "power_punches")
PEAK = ("PeakPressure", "peak_share")
RING = ("outside_zero_pressure", "ring_of_zero_pressure")
RATES = ("_slope", "_slope_beyond")


@dataclass
class ModuleText:
    """One module as the template prints it."""

    title: str
    text: str
    imports: list[str] = field(default_factory=list)
    public: list[Public] = field(default_factory=list)
    private: list[dict[str, object]] = field(default_factory=list)

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
    across = [name for name in ("inverse_across", "inverse_beyond") if f"{name}(" in text]
    if across:
        blocks.append(f"from .._across import {', '.join(across)}")
    if "arc_strips(" in text:
        blocks.append("from .._arcs import arc_strips")
    domain = [
        name for name in ("require", "require_coefficients", "require_order", "require_reach") if f"{name}(" in text
    ]
    if domain:
        blocks.append(f"from .._domain import {', '.join(domain)}")
    blocks.append("from .._elementwise import Array, Result, elementwise")
    blocks += _helpers("_functions", text)
    if "difference_root(" in text:
        blocks.append("from .._integrals import difference_root")
    roots = [name for name in ("inverse", "inverse_below") if f"{name}(" in text]
    if roots:
        blocks.append(f"from .._inverse import {', '.join(roots)}")
    starts = ["from .._starts import between"] if "between(" in text else []
    waves = ["from .._waves import inverse_over_waves"] if "inverse_over_waves(" in text else []
    kernels = sorted(set(re.findall(r"\bOUTSIDE_\d+", text)))
    if kernels:
        blocks.append(f"from .._kernels import {', '.join(kernels)}")
    if any(function.decorator for function in module.public):
        blocks.append(f"from .._numbers import {WITH_MATH}")
    peak = [name for name in PEAK if re.search(rf"\b{name}\(", text)]
    if peak:
        blocks.append(f"from .._peak import {', '.join(peak)}")
    powers = [name for name in POWERS if f"{name}(" in text]
    if powers:
        blocks.append(f"from .._powers import {', '.join(powers)}")
    ring = [name for name in RING if f"{name}(" in text]
    if ring:
        blocks.append(f"from .._ring import {', '.join(ring)}")
    rules = sorted({name for name in _rule_names() if f"{name}(" in text})
    if rules:
        line = f"from .._rules import {', '.join(rules)}"
        split = ["from .._rules import (", *(f"    {rule}," for rule in rules), ")"]
        blocks += [line] if len(line) <= 120 else split
    return [
        *blocks,
        *_helpers("_special", text),
        *starts,
        *waves,
        "",
        "if TYPE_CHECKING:",
        "    from numpy.typing import ArrayLike",
    ]


def _helpers(source: str, text: str) -> list[str]:
    names = [name for name in HELPERS_OF[source] if f"{name}(" in text]
    return [f"from ..{source} import {', '.join(names)}"] if names else []


@cache
def _rule_names() -> tuple[str, ...]:
    text = (RUNTIME / "_rules.py").read_text()
    return tuple(re.findall(r"^def (\w+_integral\w*)\(", text, re.MULTILINE))
