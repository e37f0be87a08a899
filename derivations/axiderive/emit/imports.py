"""What a module holds and imports: nothing that its public functions do not reach."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from .private import Private, PrivateFunctions
from .vocabulary import HELPERS

RUNTIME = Path(__file__).with_name("runtime")


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
    helpers = [name for name in HELPERS if f"{name}(" in text]
    if helpers:
        blocks.append(f"from .._functions import {', '.join(helpers)}")
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
    return [*blocks, *starts, *waves, "", "if TYPE_CHECKING:", "    from numpy.typing import ArrayLike"]


@cache
def _rule_names() -> tuple[str, ...]:
    text = (RUNTIME / "_rules.py").read_text()
    return tuple(re.findall(r"^def (\w+_integral\w*)\(", text, re.MULTILINE))
