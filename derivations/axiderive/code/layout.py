"""How generated code is laid out: order of letters, lines, imports.

The order of the letters in code, the functions of the runtime, and which letters are fields.

Calls, definitions and imports laid out over lines as the formatter of the project lays them out.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence

import sympy as sp

from ..abel import masters
from ..stable import opaque

# material and load first, then lengths from the contact to the profile, intermediates and functions last
ORDER = (
    "E_star", "F", "P", "d", "n", "A", "h", "a", "r", "x", "L", "t", "u", "b", "R", "R1", "R2", "s", "wavelength",
    "theta", "r_zero",
)  # fmt: skip
FUNCTIONS = {
    sp.Abs: "np.abs",
    sp.tan: "np.tan", sp.sin: "np.sin", sp.cos: "np.cos", sp.asinh: "np.arcsinh", sp.sinh: "np.sinh",
    sp.cosh: "np.cosh", sp.tanh: "np.tanh", sp.exp: "np.exp", sp.log: "np.log", sp.atan: "np.arctan",
    sp.acos: "np.arccos", sp.asin: "np.arcsin", sp.acosh: "np.arccosh", sp.atanh: "np.arctanh",
    opaque.Log1p: "np.log1p", opaque.Expm1: "np.expm1", opaque.Arctan2: "np.arctan2",
    opaque.RootGap: "root_gap", opaque.ArctanGap: "arctan_gap", opaque.TanhGap: "tanh_gap",
    opaque.GammaRatio: "gamma_ratio",
    masters.Dawson: "dawson", opaque.ArcStrips: "arc_strips", opaque.PowerPressure: "power_pressure",
    opaque.PowerDisplacement: "power_displacement", opaque.PowerPunches: "power_punches",
    opaque.PowerStrips: "power_strips", opaque.SineRoot: "sine_root",
    opaque.DepthOverHeight: "depth_over_height",
}  # fmt: skip
VARYING = frozenset(("F", "P", "d", "a", "r", "x", "L", "t", "u", "c", "r_zero", "inner", "rho"))
"""Arguments of the functions and radii made from them: all else is one number where the parameters are numbers."""


LINE = 120


def call(head: str, parts: Sequence[str], tail: str = ")", indent: int = 4) -> list[str]:
    """`head(parts)tail` on one line, else its parts on a line of their own, else one part to a line.

    The lines come without the indentation of the block they stand in.
    """
    joined = ", ".join(parts)
    if indent + len(head) + 1 + len(joined) + len(tail) <= LINE:
        return [f"{head}({joined}{tail}"]
    if indent + 4 + len(joined) <= LINE:
        return [f"{head}(", f"    {joined}", tail]
    return [f"{head}(", *(f"    {part}," for part in parts), tail]


def from_import(source: str, names: Sequence[str]) -> list[str]:
    """An import, its names in the order constants, classes, functions."""
    ordered = sorted(set(names), key=_kind)
    line = f"from {source} import {', '.join(ordered)}"
    return [line] if len(line) <= LINE else [f"from {source} import (", *(f"    {name}," for name in ordered), ")"]


def _kind(name: str) -> tuple[int, str]:
    if name.isupper() and len(name) > 1:
        return 0, name
    return (1 if name[:1].isupper() else 2), name


def fit(line: str, indent: int = 4) -> list[str]:
    """A line, or its last bracket opened where it is too long for one."""
    if indent + len(line) <= LINE or ")" not in line:
        return [line]
    close = line.rindex(")")
    place = _opening(line, close)
    head, parts = line[:place], split(line[place + 1 : close])
    # a comma behind the only part of a bracket that calls nothing would make it a tuple
    if parts[-1].startswith("for ") or (len(parts) == 1 and not re.search(r"\w$", head)):
        inside = line[place + 1 : close]
        parts = [inside] if indent + 4 + len(inside) <= LINE else parts
        return [f"{head}(", *(f"    {part}" for part in parts), line[close:]]
    return call(head, parts, line[close:], indent)


def split(text: str) -> list[str]:
    """The parts between the commas outside all brackets and quotes; of what is generated the value, and the rest."""
    parts, depth, quoted = [""], 0, False
    for place, character in enumerate(text):
        quoted ^= character == '"'
        depth += (character in "([{") - (character in ")]}")
        if depth == 0 and text.startswith(" for ", place):
            return [text[:place], text[place + 1 :]]
        if character == "," and depth == 0 and not quoted:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts]


def _opening(line: str, close: int) -> int:
    depth = 0
    for place in range(close, -1, -1):
        depth += (line[place] == ")") - (line[place] == "(")
        if depth == 0:
            return place
    message = f"unbalanced brackets in {line!r}"
    raise ValueError(message)


def literal(text: str) -> list[str]:
    """A message as adjacent string literals that fit on their lines."""
    parts = [text] if len(text) <= 109 else textwrap.wrap(text, 100, drop_whitespace=False)
    return [f'    "{part}"' for part in parts[:-1]] + [f'    "{parts[-1]}",']
