"""What the page on layers says, with functions drawn once in the place of springs, kernel and waves."""

from __future__ import annotations

from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..physics import FORCE
from ..physics import layer as stated
from ..rows import layer
from .claims import WORKING, Claim, Line
from .meaning import Node

WHOLE, SLOPE, SUNK = map(sp.Function, ("whole", "slope", "sunk"))
FUNCTIONS: dict[str, Any] = {
    "g": lambda t: mp.mpf("0.8") * t**2 + t,
    "q": lambda t: mp.mpf("1.3") - t**2 / 3 + t**3 / 7,
    "slope": lambda t: -2 * t / 3 + 3 * t**2 / 7,
    "whole": lambda a: mp.mpf("1.9") * a**3,
    "K": lambda t, s: mp.exp(-t) * (1 + s**2 / 5),
    "sunk": lambda u: 1 - mp.exp(-u) * (1 + u / 4),
}
"""Spring and kernel are smooth, and waves that are short for a layer feel nothing of it."""
VALUES = {
    nt.a: "1.7", nt.t: "0.6", nt.s: "0.45", nt.u: "0.9", nt.r: "0.35", nt.d: "1.15", nt.R: "2.3", nt.nu: "0.29",
    nt.E_star: "1.4", nt.F: "3.7", stated.thickness: "2.1", stated.m_0: "1.55", stated.m_2: "3.2",
}  # fmt: skip


def rules() -> list[Line]:
    """Every row of the page against what it states, in any text of its own."""
    with mp.workdps(WORKING):
        known = {symbol: mp.mpf(text) for symbol, text in VALUES.items()}
        names = {nt.describe(symbol).latex: value for symbol, value in known.items()}
        names |= {"nu": known[nt.nu], "E*": known[nt.E_star], "m_0": known[stated.m_0], "m_2": known[stated.m_2]}
        env = {**names, "g()": FUNCTIONS["g"], "q()": FUNCTIONS["q"], "q'()": FUNCTIONS["slope"]}
        env |= {"F_N()": FUNCTIONS["whole"], "F_N": known[nt.F]}
        env |= {"K": Node(lambda here: FUNCTIONS["K"](*(here[symbol.name] for symbol in (nt.t, nt.s))))}
        env |= {"L": Node(lambda here: FUNCTIONS["sunk"](here[nt.u.name]))}
        return [
            Claim(env, _value(expr, known), name.partition(" ")[0]).line(f"layer: {name}", layer.texts()[name])
            for name, expr in layer.statements().items()
        ]


def _value(expr: sp.Expr, known: dict[sp.Symbol, Any]) -> Any:
    """A statement with these functions and numbers."""
    own = expr.subs(layer.CHI, sp.sqrt(nt.R * nt.d) / stated.thickness)
    own = (
        own.replace(FORCE, WHOLE)
        .replace(sp.Derivative, lambda spring, _: SLOPE(*spring.args))
        .subs(stated.L, SUNK(nt.u))
    )
    return sp.lambdify([*known], own, [FUNCTIONS, "mpmath"])(*known.values())
