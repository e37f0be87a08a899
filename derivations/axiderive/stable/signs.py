"""Whether an expression can lose digits by cancellation.

All symbols are positive.  A sum whose terms have one sign loses nothing; a
difference of two inputs, or of their squares as (x - y)(x + y), is exact up to
one rounding.  Everything else cancels somewhere and must be written otherwise.
"""

from __future__ import annotations

import sympy as sp

from ..abel import masters
from . import opaque

Facts = frozenset[tuple[sp.Expr, sp.Expr]]

POSITIVE = (
    sp.acos, sp.asin, sp.atan, sp.acosh, sp.asinh, sp.atanh, sp.sinh, sp.cosh, sp.tan, sp.sin, sp.cos, sp.gamma, sp.exp,
    masters.Dawson,
    opaque.Root, opaque.Arctan2, opaque.Arcosh, opaque.Log1p, opaque.ArctanGap, opaque.RootGap, opaque.TanhGap,
    opaque.GammaRatio, opaque.DepthOverHeight,
    opaque.ArcStrips, opaque.PowerPressure, opaque.PowerDisplacement, opaque.PowerPunches, opaque.PowerStrips,
)  # fmt: skip


def sign(expr: sp.Expr, facts: Facts) -> int:
    """+1 or -1 where the sign follows from the signs of the terms and the facts low < high, else 0."""
    if expr.is_Number or expr.is_NumberSymbol:
        return int(sp.sign(expr))
    if expr.is_Symbol or isinstance(expr, (sp.Indexed, *POSITIVE)):
        return 1
    if isinstance(expr, opaque.Expm1):
        return sign(expr.args[0], facts)
    if expr.is_Pow:
        inner = sign(expr.base, facts)
        return 1 if inner == 1 or (expr.exp.is_Integer and expr.exp % 2 == 0) else inner
    if isinstance(expr, sp.Sum):
        return sign(expr.function, facts)
    if expr.is_Mul:
        out = 1
        for factor in expr.args:
            out *= sign(factor, facts)
        return out
    if expr.is_Add:
        signs = {sign(term, facts) for term in expr.args}
        if len(signs) == 1:
            return signs.pop()
        return _difference_sign(expr, facts)
    return 0


def cancels(expr: sp.Expr, facts: Facts) -> bool:
    """Whether some sum inside is neither of one sign nor an exact difference."""
    return any(
        node.is_Add and sign(node, facts) == 0 and difference(node) is None for node in sp.preorder_traversal(expr)
    )


def difference(expr: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """(x, y) if the sum is x - y or x**2 - y**2 with monomials x and y."""
    if len(expr.args) != 2:
        return None
    plus = [term for term in expr.args if not term.could_extract_minus_sign()]
    minus = [-term for term in expr.args if term.could_extract_minus_sign()]
    if len(plus) != 1 or len(minus) != 1:
        return None
    (x,), (y,) = plus, minus
    roots = sp.sqrt(x), sp.sqrt(y)
    if all(_is_input(root) for root in roots):
        return roots
    return (x, y) if _is_input(x) and _is_input(y) else None


def squares(expr: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """(x, y) if the sum is x**2 - y**2."""
    found = difference(expr) if expr.is_Add else None
    return found if found and sp.expand(found[0] ** 2 - found[1] ** 2 - expr) == 0 else None


def _is_input(expr: sp.Expr) -> bool:
    """A monomial of symbols with whole exponents."""
    factors = sp.Mul.make_args(expr)
    return all(f.is_Rational or _is_symbol(f.as_base_exp()[0]) and f.as_base_exp()[1].is_Integer for f in factors)


def _is_symbol(expr: sp.Expr) -> bool:
    return bool(expr.is_Symbol) and not isinstance(expr, opaque.Named)


def _difference_sign(expr: sp.Expr, facts: Facts) -> int:
    found = difference(expr)
    if found is None:
        return 0
    (cx, x), (cy, y) = (term.as_coeff_Mul() for term in found)
    if (y, x) in facts and cx >= cy:
        return 1
    if (x, y) in facts and cx <= cy:
        return -1
    return 0


def facts_of(chain: tuple[sp.Expr, ...], *more: tuple[sp.Expr, sp.Expr]) -> Facts:
    """Every comparison a chain of ascending lengths implies, and some more."""
    pairs = {(low, high) for i, low in enumerate(chain) for high in chain[i + 1 :]}
    return frozenset(pairs | set(more))
