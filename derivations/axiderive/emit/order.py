"""Order of print: which factor is scale, which term comes first."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from .. import notation as nt
from .factors import Factor

ORDER = (
    "kappa", "n", "j", "mu", "E_star", "E_inf", "E", "E_1", "G_star", "H", "H_x", "eta", "p_0", "p_mean", "P", "F",
    "F_x", "dgamma", "d", "A", "C", "h", "v", "time", "t_0", "L", "a", "a_c", "c", "r", "r_zero", "r_peak", "t",
    "x", "x_zero", "e", "b", "R", "R1", "R2", "s", "wavelength", "N", "retraction", "k", "u", "psi", "theta",
)  # fmt: skip
TRIGONOMETRIC = (sp.sin, sp.cos, sp.tan)
RAISED = (*TRIGONOMETRIC, sp.sinh, sp.cosh, sp.tanh)
"""Functions whose powers are printed behind the name: sinh^2 x."""


def is_one_group(text: str) -> bool:
    r"""Whether a single \frac{..}{..} or \sqrt{..} is the whole text."""
    wanted = 2 if text.startswith((r"\frac{", r"\tfrac{")) else 1 if text.startswith(r"\sqrt{") else 0
    depth = groups = 0
    for i, c in enumerate(text):
        depth += (c == "{") - (c == "}")
        groups += c == "}" and depth == 0
        if wanted and groups == wanted:
            return i == len(text) - 1
    return False


def is_scale(base: sp.Expr) -> bool:
    if isinstance(base, TRIGONOMETRIC):
        return bool(base.args[0].is_Symbol)
    if base.is_Add:
        return {s.name for s in base.free_symbols} <= {"n", "j", "k"}
    if isinstance(base, sp.Derivative):
        return isinstance(base.expr, AppliedUndef)
    return bool(
        base.is_Symbol or base is sp.pi or isinstance(base, (sp.Indexed, sp.gamma, AppliedUndef)) or base.is_Number
    )


def is_function(base: sp.Expr) -> bool:
    return not is_scale(base) and not base.is_Add


def has_fraction(base: sp.Expr) -> bool:
    return any(sp.fraction(term)[1] != 1 for term in base.args)


def _rank(symbol: sp.Symbol) -> int:
    return ORDER.index(symbol.name) if symbol.name in ORDER else len(ORDER)


# a formula is set several times over until it fits, and the text of an expression is slow to make
@lru_cache(maxsize=65536)
def factor_key(factor: Factor) -> tuple[int, int, str]:
    base = factor[0]
    if base.is_Number:
        return (0, 0, "")
    if base is sp.pi:
        return (1, 0, "")
    if base.is_Symbol:
        return (2, _rank(base), base.name)
    if isinstance(base, sp.Indexed):
        return (2, ORDER.index("A"), "")
    if base.is_Add and is_scale(base):  # (n+1) F, for F (n+1) would read as a function
        return (2, ORDER.index("j"), str(base))
    if isinstance(base, sp.gamma):  # a number: before the lengths, for tan theta Gamma(x) reads as tan(theta Gamma(x))
        return (2, ORDER.index("j"), f"~{base}")
    if isinstance(base, TRIGONOMETRIC):
        return (3, TRIGONOMETRIC.index(type(base)), str(base))
    kinds = (sp.Pow, sp.Add, sp.Function, sp.Sum, sp.Integral)
    return (4 + next((i for i, kind in enumerate(kinds) if isinstance(base, kind)), len(kinds)), 0, str(base))


@lru_cache(maxsize=65536)
def term_key(term: sp.Expr) -> tuple[Any, ...]:
    """Integrals last, plain numbers before them, then by falling powers in the order of the symbols."""
    powers = term.as_powers_dict()
    degrees = tuple(-float(powers.get(s, 0)) if powers.get(s, sp.S.Zero).is_number else -1.0 for s in _SYMBOLS)
    return (bool(term.atoms(sp.Integral)), term.is_number, degrees, str(term))


_SYMBOLS = tuple(nt.describe(name).symbol for name in ORDER if nt.known(name))


def samples(chain: tuple[sp.Expr, ...]) -> list[dict[sp.Symbol, sp.Rational]]:
    """Values that keep the order: evenly spread, far apart and close together."""
    if len(chain) < 2 or not all(x.is_Symbol for x in chain):
        return []
    steps = [[sp.Integer(i + 1), sp.Integer(10) ** i, 1 + sp.Rational(i, 100)] for i in range(len(chain))]
    return [dict(zip(chain, values, strict=True)) for values in zip(*steps, strict=True)]
