"""How large an expression may be: numbers of bounded size, and as many terms as can be multiplied out in no time."""

from __future__ import annotations

import math

import sympy as sp

LARGEST_EXPONENT, LARGEST_ROOT = 24, 12
MOST_DIGITS, MOST_TERMS = 60, 400


def excess(expr: sp.Expr) -> str:
    """What of an expression is too large, with the next step; an empty text if nothing is."""
    if expr.has(sp.nan, sp.zoo, sp.oo, -sp.oo, sp.I):
        return "is no real number; change it"
    if any(max(abs(number.p), number.q) > 10**MOST_DIGITS for number in expr.atoms(sp.Rational)):
        return f"holds a number of more than {MOST_DIGITS} digits; scale it into a parameter"
    for power in (p for p in expr.atoms(sp.Pow) if p.exp.is_Rational and not p.is_number):
        if abs(power.exp) > LARGEST_EXPONENT or power.exp.q > LARGEST_ROOT**2:
            allowed = f"use exponents up to {LARGEST_EXPONENT} in {LARGEST_ROOT}ths"
            return f"holds {sp.sstr(power)[:40]}, whose exponent is too large or too fine; {allowed}"
    if expr.is_number and not finite(expr):
        return "is out of the range of numbers; scale it"
    if terms(expr) > MOST_TERMS:
        return f"has more than {MOST_TERMS} terms when multiplied out; lower its power"
    return ""


def finite(number: sp.Expr) -> bool:
    """Whether a number is in the range of doubles."""
    value = number.evalf(15)
    try:
        size = abs(complex(value))
    except OverflowError:
        return False
    return math.isfinite(size) and (size > 0.0 or value == 0)


def terms(expr: sp.Expr) -> int:
    """How many terms `expand` makes of it."""
    if expr.is_Add:
        return sum(terms(arg) for arg in expr.args)
    if expr.is_Mul:
        return math.prod(terms(arg) for arg in expr.args)
    if expr.is_Pow and expr.exp.is_Integer:
        count, power = terms(expr.base), abs(int(expr.exp))
        return math.comb(count + power - 1, power) if count > 1 else 1
    return max([1, *(terms(arg) for arg in expr.args)])
