"""Closed inverses a(d) and a(F), where the forward formula allows one.

Four shapes are recognised: a monomial in a; a multiple of S = sqrt(a^2 - b^2);
alpha a^2 + beta a S, a quadratic for a^2; and a depressed cubic in S with positive
coefficients, which has one real root in sinh form.  The right root is chosen by
the certificate's witness, never by trying.  With adhesion the forward formula is
alpha y^2 - beta y in a power y of a for the paraboloid's force and the cone's depth.
"""

from __future__ import annotations

import sympy as sp

from ..entry import Case
from ..notation import a

_S = sp.Symbol("S", positive=True)


def closed_inverse(cases: tuple[Case, ...], value: sp.Symbol) -> tuple[Case, ...] | None:
    """Cases of a as a function of `value`, in the order of the forward cases, or None."""
    out = []
    for case in cases:
        inverse = _invert(case.expr, value)
        if inverse is None:
            return None
        out.append(Case(_chain(case, value, len(cases)), inverse))
    return tuple(out)


def _chain(case: Case, value: sp.Symbol, total: int) -> tuple[sp.Expr, ...]:
    """The regime in terms of the value: a < b becomes value < formula at a = b."""
    if total == 1:
        return ()
    i = case.chain.index(a)
    if i + 1 < len(case.chain):
        return (value, case.expr.subs(a, case.chain[i + 1]))
    return (case.expr.subs(a, case.chain[i - 1]), value)


def _invert(expr: sp.Expr, value: sp.Symbol) -> sp.Expr | None:
    if expr.has(sp.Sum):
        return None
    factor, power = expr.as_independent(a, as_Add=False)
    base, exponent = power.as_base_exp()
    if base == a and not exponent.has(a):
        return (value / factor) ** (1 / exponent)
    roots = [e for e in expr.atoms(sp.Pow) if e.exp == sp.S.Half and e.has(a)]
    if len(roots) != 1 or any(fn.has(a) for fn in expr.atoms(sp.Function)):
        return None
    square = sp.expand(a**2 - roots[0].base)
    if square.has(a):
        return None
    b = sp.sqrt(square)
    polynomial = sp.Poly(sp.expand(expr.subs(roots[0], _S)), a, _S)
    terms = dict(polynomial.terms())
    if set(terms) <= {(2, 0), (1, 1)}:
        return _quadratic(terms.get((2, 0), sp.S.Zero), terms[1, 1], b, value)
    if any(power % 2 for power, _ in terms):
        return None
    in_S = sp.Poly(sp.expand(polynomial.as_expr().subs(a, sp.sqrt(_S**2 + b**2))), _S)
    if in_S.monoms() == [(1,)]:
        return sp.sqrt(b**2 + sp.factor(value / in_S.LC()) ** 2)
    if {m for (m,) in in_S.monoms()} == {1, 3}:
        return _cubic(in_S.coeff_monomial(_S**3), in_S.coeff_monomial(_S), b, value)
    return None


def stable_inverse(forward: sp.Expr, value: sp.Symbol) -> sp.Expr | None:
    """The larger root a of alpha y^2 - beta y = value with y = a^e, or None if the formula has another shape.

    The larger root is the branch on which the value grows with a.
    """
    terms = [term.as_independent(a, as_Add=False) for term in sp.Add.make_args(sp.expand_mul(forward))]
    powers = {sp.expand(power.as_base_exp()[1]): factor for factor, power in terms if power.as_base_exp()[0] == a}
    if len(terms) != 2 or len(powers) != 2:
        return None
    exponent = next((e for e in powers if sp.expand(2 * e) in powers), None)
    if exponent is None:
        return None
    alpha, beta = powers[sp.expand(2 * exponent)], -powers[exponent]
    half = sp.factor(beta / (2 * alpha))
    return (half + sp.sqrt(half**2 + sp.factor(value / alpha))) ** sp.cancel(1 / exponent)


def _quadratic(alpha: sp.Expr, beta: sp.Expr, b: sp.Expr, value: sp.Symbol) -> sp.Expr:
    """alpha a^2 + beta a S = value: squared, (alpha^2 - beta^2) a^4 + (beta^2 b^2 - 2 alpha value) a^2 + value^2 = 0.

    The root with alpha a^2 < value is 2 value^2 / (2 alpha value - beta^2 b^2 + beta W); written this way
    it neither cancels nor needs the sign of alpha - beta.
    """
    W = sp.sqrt(sp.factor(beta**2 * b**4 - 4 * alpha * value * b**2 + 4 * value**2))
    if alpha == 0:  # conjugate: W^2 - (beta b^2)^2 = 4 value^2
        return sp.sqrt((beta * b**2 + W) / (2 * beta))
    return value * sp.sqrt(2) / sp.sqrt(2 * alpha * value - beta**2 * b**2 + beta * W)


def _cubic(third: sp.Expr, first: sp.Expr, b: sp.Expr, value: sp.Symbol) -> sp.Expr:
    """third S^3 + first S = value through sinh(3 y) = 4 sinh(y)^3 + 3 sinh(y)."""
    scale = 2 * sp.sqrt(sp.cancel(first / (3 * third)))
    S = scale * sp.sinh(sp.asinh(sp.cancel(4 * value / (third * scale**3))) / 3)
    return sp.sqrt(b**2 + S**2)
