"""Proved bounds of the logarithmic slope of depth and force over the unknown of their inverse.

Let q(r) = r f''/f'.  All means have positive weights, as f' >= 0.

The radius itself: g(a) = a int_0^1 f'(a s)/sqrt(1 - s^2) ds and F = 2 E* a^2 int_0^1 s^2 f'(a s)/sqrt(1 - s^2) ds, so
a g'/g is a mean of 1 + q, and a F'/F one of 2 + q.

Beyond a flat face, r^2 = b^2 (1 + tau^2) and a^2 = b^2 (1 + t^2): with tau = t s both are integrals with the weight
s/sqrt(1 - s^2), g of t sqrt(1 + t^2) f'/sqrt(1 + tau^2) and F of t f' sqrt(1 + tau^2).  With T = 1 - b^2/r^2 at tau and
T <= T(a) <= 1 the slope of g is a mean of 1 + T(a) - T (1 - q), that of F one of 1 + T (1 + q).

Below the end R of a circle or an ellipse, a = R tanh t: there g is proportional to t tanh t, its slope is
1 + 2 t/sinh 2t.  That of F is larger, as F < 2 E* a g.  And F is the integral of tanh t (tanh t + t/cosh^2 t), which
over t^2 falls as tanh t/t and 1/cosh t do: its slope is at most 3.
"""

from __future__ import annotations

import math

import sympy as sp

from ..notation import r
from ..profiles.profile import Profile

Range = tuple[sp.Expr, sp.Expr]
SHARE = sp.Symbol("x", positive=True)
CIRCLE = {"ad": (1, 2), "aF": (1, 3)}


def proved(profile: Profile, suffix: str) -> tuple[int, int] | None:
    """Whole numbers between which the slope of d ("ad") or F ("aF") lies; None where this proves no such range."""
    if len(profile.pieces) != 1 + profile.truncated:
        return None
    power = log_slope(profile.pieces[-1].expr)
    if not profile.truncated and len(profile.chain) == 2 and profile.largest is None:
        end = profile.chain[-1]
        circle = sp.cancel(power - end**2 / (end**2 - r**2)) == 0
        return CIRCLE[suffix] if circle else None
    found = _beyond(profile, power, suffix) if profile.truncated else _whole(power, suffix)
    if found is None or found[0] <= 0:
        return None
    return math.floor(found[0]), math.ceil(found[1])


def log_slope(shape: sp.Expr) -> sp.Expr:
    """q(r) = r f''/f', factor by factor."""
    total = sp.S.Zero
    for base, exponent in sp.factor(sp.diff(shape, r)).as_powers_dict().items():
        total += exponent * r * sp.diff(base, r) / base + r * sp.diff(exponent, r) * sp.log(base)
    return sp.cancel(total)


def _whole(power: sp.Expr, suffix: str) -> Range | None:
    """Over all radii, r = L x/(1 - x) with the one length L of q."""
    lengths = power.free_symbols - {r}
    if len(lengths) > 1:
        return None
    reach = sp.Mul(*lengths) * SHARE / (1 - SHARE)
    found = _range(power.subs(r, reach))
    least = 1 if suffix == "ad" else 2
    return None if found is None else (least + found[0], least + found[1])


def _beyond(profile: Profile, power: sp.Expr, suffix: str) -> Range | None:
    """Over all radii from the flat face on, r = b/x."""
    grown, power = 1 - SHARE**2, power.subs(r, profile.breaks[0] / SHARE)
    if suffix == "aF":
        return _range(1 + grown * (1 + power))
    least, most = _range(1 + grown * power), _range(2 - grown * (1 - power))
    return None if least is None or most is None else (least[0], most[1])


def _range(expr: sp.Expr) -> Range | None:
    """Least and largest value over 0 <= x <= 1, if the expression is a rational function of x alone without a pole."""
    expr = sp.cancel(expr)
    if expr.free_symbols - {SHARE} or not expr.is_rational_function(SHARE):
        return None
    _, below = sp.fraction(expr)
    turning, _ = sp.fraction(sp.cancel(sp.diff(expr, SHARE)))
    pole, turn = (sp.Poly(part, SHARE) for part in (below, turning))
    # exact roots need whole coefficients
    if not (pole.domain.is_ZZ and turn.domain.is_ZZ) or (pole.degree() > 0 and pole.count_roots(0, 1)):
        return None
    places = [sp.S.Zero, sp.S.One]
    if turn.degree() > 0:
        places += [x for x, _ in turn.real_roots(multiple=False) if 0 < x < 1]
    values = [expr.subs(SHARE, x) for x in places]
    # a root in print may lie on either side of a whole number
    if any(not value.is_Rational and abs(value - round(value)) < 1e-9 for value in values):
        return None
    return min(values), max(values)
