"""What to write in place of what is often written in an expression and is not read."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable

from .names import FUNCTIONS

STEPS = "write Max(0, r - b) for what begins at a break b, or Piecewise((f, r <= b), (h, True)) for cases"
INSTEAD = {
    **dict.fromkeys(["abs", "Abs", "fabs"], "f is needed for r >= 0 only, where abs(r) is r; " + STEPS),
    **dict.fromkeys(["Heaviside", "heaviside", "sign", "where", "step", "min", "Min", "If", "piecewise"], STEPS),
    **dict.fromkeys(["max", "maximum"], "write Max(0, r - b)"),
    **dict.fromkeys(["arctan", "atan2"], "write atan(...)"),
    **dict.fromkeys(["arcsinh", "arsinh"], "write asinh(...)"),
    "ln": "write log(...), which is the natural logarithm",
    "log10": "write log(...)/log(10)",
    "pow": "write r**n",
    "cbrt": "write r**(1/3)",
    "radians": "an angle is a parameter with a unit; write tan(theta)",
}
"""By the name of a function that there is not."""
UNITS = frozenset(["mm", "cm", "um", "nm", "deg", "mrad", "rad", "Pa", "kPa", "MPa", "GPa", "mN", "kN"])
DISTANCES = ("x", "rho", "s", "radius", "t", "y", "z")
"""Names that stand for r elsewhere."""
PRODUCT = re.compile(r"(?<![\w.])((?:\d+\.?\d*|\.\d+))\s*([A-Za-z]\w*|\()")
SPACED = re.compile(r"([A-Za-z0-9_.)]+)\s+([A-Za-z0-9_.]+)")


def function(name: str, nearest: str) -> str:
    """About a function that there is not."""
    known = f"; there are {', '.join(FUNCTIONS)}"
    return f"{name[:40]} is no function of an expression; {INSTEAD[name]}" if name in INSTEAD else nearest + known


def unit(name: str) -> str:
    """About the name of a unit; empty for other names."""
    if name not in UNITS:
        return ""
    return f"{name} is a unit, and f has none; name the number, as R or theta, and give its value and unit in a scene"


def without_r(text: str, names: Iterable[str]) -> str:
    """About an expression in which r does not occur."""
    found = sorted(set(names) - {*FUNCTIONS, "pi"})
    other = next((name for name in DISTANCES if name in found), "")
    read = f": {', '.join(found)} would be {'a parameter' if len(found) == 1 else 'parameters'}" if found else ""
    step = f"write r for {other}" if other else "write the height of the indenter over its tip, as r**2/(2*R)"
    return f"{text[:40]!r} does not depend on r, the distance from the axis{read}; {step}"


def kinked(part: str) -> str:
    """About an absolute value, which the root of a square is."""
    return f"f has {part[:60]}, whose slope jumps where that is 0; write its parts with Max or Piecewise"


def syntax(text: str, reason: str) -> str:
    """About a text that is no expression of Python."""
    if re.match(r"\s*\w+\s*(\([^()]*\))?\s*=(?!=)", text):
        return "an equation is not read; write what stands right of its ="
    for match in PRODUCT.finditer(text):
        if match[2] in UNITS:
            return unit(match[2])
        if not re.fullmatch(r"[eE]\d*", match[2]):
            return f"{match[1]}{match[2]} is no product; write {match[1]}*{match[2]}"
    spaced = SPACED.search(text)
    if spaced and spaced[2] in UNITS:
        return unit(spaced[2])
    return f"not an expression: {reason}; write it as in Python, r**2/(2*R) + c*r**4"


def misplaced(node: ast.expr, segment: str) -> str:
    """About a part that has no place in an expression."""
    what = f"{segment!r} ({type(node).__name__}) has no place here"
    match node:
        case ast.Tuple() if re.search(r"\d,\d", segment):
            return f"{what}; decimals have a point, as 0.5"
        case ast.IfExp() | ast.Compare() | ast.BoolOp():
            return f"{what}; {STEPS}"
        case ast.Call(func=ast.Attribute(attr=name)) if name in FUNCTIONS:
            return f"{what}; write {name}(...) alone"
    return f"{what}; use names, numbers, + - * / ** and functions"
