"""Which names an expression may use, what is wrong with one, and what to write in place of what is not read."""

from __future__ import annotations

import ast
import builtins
import difflib
import keyword
import re
from collections.abc import Iterable

from .. import notation as nt
from ..exits import USAGE, CommandError


class ExpressionError(CommandError):
    """The value, the rule and the next step; `position` counts characters of the expression from 0."""

    code = USAGE

    def __init__(self, message: str, text: str = "", position: int | None = None, length: int = 1) -> None:
        self.plain, self.position = message, position
        shown = message
        if position is not None:
            line = "".join(c if c.isprintable() else " " for c in text)
            start = max(0, position - 60)
            shown += f"\n  {line[start : start + 100]}\n  {' ' * (position - start)}{'^' * max(1, min(length, 40))}"
        super().__init__(shown)


SHAPE = re.compile(r"[A-Za-z][A-Za-z0-9]{0,9}(_[A-Za-z0-9]{1,6})?")
RESULTS = frozenset((
    "a", "d", "F", "p", "w", "f", "g", "p_mean", "stiffness", "r_zero", "a_c", "retraction", "H_x", "F_x", "P",
    "x_zero", "slope", "tilt", "width", "u_0", "tau",
))  # fmt: skip
"""Fields and results of the generated functions."""
MATERIAL = frozenset((
    "E_star", "G_star", "E", "E_inf", "E_1", "eta", "dgamma", "mu", "H", "k", "nu", "v", "alpha", "relaxation",
    "t_0", "p_0",
))  # fmt: skip
INTERNAL = frozenset((
    "t", "u", "x", "z", "psi", "root", "angle", "tip", "beyond", "inner", "within", "growth", "inside", "outside",
    "value", "kappa", "total", "plus", "minus", "terms", "pressed", "largest", "excess", "rho", "face", "edge", "j",
    "C", "e", "i", "np", "pi", "integral", "elementwise", "require", "inverse", "curve", "depth", "force",
    "pressure", "displacement", "profile", "mean_pressure", "own", "least", "plain", "found", "load", "control",
    "radius", "radii", "balance", "partial", "logarithm", "result", "square", "step", "scale", "span", "stop",
    "share", "moved",
))  # fmt: skip
"""Names of the generated code and of integration variables."""
NO_REALS = {"nan": "no number", "oo": "infinity", "inf": "infinity", "infinity": "infinity",
            "zoo": "infinity", "i": "the imaginary unit"}  # fmt: skip
"""What is read as something else than a length, in lower case."""
FUNCTIONS = ("Max", "Piecewise", "sqrt", "exp", "log", "sin", "cos", "tan", "sinh", "cosh", "tanh", "asinh", "atan")


def refusal(name: str) -> str:
    """Why a name cannot be a parameter, with the next step; an empty text if it can."""
    if not SHAPE.fullmatch(name):
        return (
            f"{name[:40]!r} is no name of a parameter; use a letter, then at most 9 letters or digits, as b2 or h_tip"
        )
    meaning = NO_REALS.get(name.lower())
    if meaning and name != "i":
        return f"{name} stands for {meaning}, but f(r) is real and finite; write a number, or a parameter as {name}1"
    if name in FUNCTIONS:
        return f"{name} is a function; write {name}(...) or give the parameter another name"
    if name in RESULTS:
        return f"{name} is a result or an argument of the generated functions; give the parameter another name"
    if name in MATERIAL:
        return f"{name} belongs to the material or the load; give the parameter another name, as {name}1"
    if name in INTERNAL or keyword.iskeyword(name) or hasattr(builtins, name):
        return f"{name} is used inside the generated functions; give the parameter another name, as {name}1"
    return ""


GREEK = frozenset((
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu", "xi",
    "rho", "sigma", "tau", "phi", "chi", "psi", "omega",
))  # fmt: skip


def latex(name: str) -> str:
    """The letters of a parameter in print."""
    if nt.known(name):
        return nt.describe(name).latex
    match = re.fullmatch(r"([A-Za-z]+?)_?(\d+|(?<=_)\w+)?", name)
    stem, below = (match[1], match[2] or "") if match else (name, "")
    text = rf"\{stem}" if stem in GREEK else stem if len(stem) == 1 else rf"\mathrm{{{stem}}}"
    return text + (f"_{below}" if len(below) == 1 else rf"_{{\mathrm{{{below}}}}}" if below else "")


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


def unknown(name: str) -> str:
    """About a function that there is not: what is written instead, or the known one most like it."""
    what = f"{name[:40]} is no function of an expression"
    if name in INSTEAD:
        return f"{what}; {INSTEAD[name]}"
    near = difflib.get_close_matches(name, FUNCTIONS, n=1, cutoff=0.5)
    return f"{what}{f'; did you mean {near[0]}?' if near else ''}; there are {', '.join(FUNCTIONS)}"


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
