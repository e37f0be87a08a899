"""Which names an expression may use: parameters of its own, letters of the notation, and those that are taken.

And what is wrong with an expression, with the place in its text.
"""

from __future__ import annotations

import builtins
import difflib
import keyword
import re

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


def nearest_function(name: str) -> str:
    """The message for an unknown function, with the known one most like it if there is one."""
    near = difflib.get_close_matches(name, FUNCTIONS, n=1, cutoff=0.5)
    hint = f"; did you mean {near[0]}?" if near else ""
    return f"{name[:40]} is no function of an expression{hint}"


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
    return text + (f"_{below}" if len(below) == 1 else rf"_{{\mathrm{{{below}}}}}" if below else "").replace("_{", "_{")
