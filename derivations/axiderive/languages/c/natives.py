"""What Python and NumPy have and C too, by name, and the names that mean something else in C."""

from __future__ import annotations

import math
import re
from collections.abc import Callable

from .values import Native

SAME = ("exp", "expm1", "sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "asinh", "hypot", "cbrt", "atan2")
BOUNDED = ("sqrt", "log", "log1p", "acos", "asin", "atanh", "acosh", "pow")


def _least(x: float, y: float) -> float:
    return x if x < y or x != x else y


def _greatest(x: float, y: float) -> float:
    return x if x > y or x != x else y


def _or_none(function: Callable[..., float]) -> Callable[..., float]:
    """A function of `math` that gives what C gives where Python has an error."""

    def called(*given: float) -> float:
        try:
            return function(*given)
        except ValueError:
            return math.nan

    return called


NATIVES: dict[str, Native] = {
    **{name: Native(name, getattr(math, name)) for name in SAME},
    **{name: Native(name, _or_none(getattr(math, name))) for name in BOUNDED},
    "arctan": Native("atan", math.atan),
    "arctan2": Native("atan2", math.atan2),
    "arctanh": Native("atanh", _or_none(math.atanh)),
    "arcsinh": Native("asinh", math.asinh),
    "power": Native("pow", math.pow),
    "exp2": Native("exp2", lambda x: 2.0**x),
    "gamma": Native("tgamma", math.gamma),
    "lgamma": Native("lgamma", math.lgamma),
    "abs": Native("fabs", abs),
    "minimum": Native("minimum", _least),
    "maximum": Native("maximum", _greatest),
    "copysign": Native("copysign", math.copysign),
    "halfway": Native("halfway"),
    "nextafter": Native("nextafter", math.nextafter),
}
"""Functions by Python's and NumPy's names."""
CONSTANTS = {"pi": math.pi, "e": math.e, "inf": math.inf, "nan": math.nan}
LIKE = ("asarray", "float64", "vectorize")
FULL = {"ones_like": 1.0, "zeros_like": 0.0, "zeros": 0.0, "ndim": 0}
TRUTHS = ("any", "all", "count_nonzero")
NODES = "NODES_{}"
"""The name of the nodes of a rule by their number."""
PRODUCTS = (16, 32, 64)
"""How many nodes a rule has for what has a power as a weight, where the program finds that."""
WORDS = frozenset((
    *("auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum", "extern"),
    *("float", "for", "goto", "if", "inline", "int", "long", "register", "restrict", "return", "short", "signed"),
    *("sizeof", "static", "struct", "switch", "typedef", "union", "unsigned", "void", "volatile", "while", "main"),
    *("minimum", "maximum", "lower", "higher", "pairs", "sum", "gamma", "j0", "j1", "jn", "y0", "y1", "yn"),
    *(own.name for own in NATIVES.values()),
))  # fmt: skip
"""Names that mean something else in C."""


def word(name: str) -> str:
    """A name that means nothing else in C."""
    return f"{name}_" if name in WORDS or re.fullmatch(r"x\d+", name) else name
