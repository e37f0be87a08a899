"""Bounds of the logarithmic slope of the load, from the exact formula: what makes Newton's bracket sure."""

from __future__ import annotations

import math
from functools import cache

import mpmath as mp
import sympy as sp

from ...entry import Entry
from ...notation import E_star, a
from ..example import NUMERIC

DECADES = range(-24, 25)


@cache
def exponents(entry: Entry) -> tuple[str, str]:
    """Whole numbers between which d ln P/d ln t lies; a = t, and a = b sqrt(1 + t^2) over a flat face of half-width b.

    The parameters of the sketch stand for all: P is a length scale times a function of a/b.
    """
    values = {symbol: sp.Rational(str(value)) for symbol, value in entry.profile.sketch.values} | {E_star: sp.S.One}
    (b,) = entry.profile.breaks
    t = sp.Dummy("t", positive=True)
    half_width = b * sp.sqrt(1 + t**2) if entry.profile.truncated else t * b
    slopes = []
    with mp.workdps(60):
        for case in entry.cases:
            load = case.expr.subs(a, half_width)
            slope = sp.lambdify(t, (t * sp.diff(load, t) / load).subs(values), NUMERIC)
            for k in DECADES:
                point = mp.mpf(10) ** (mp.mpf(k) / 4)
                if entry.profile.truncated or (point < 1 if case.below(a, b) else point > 1):
                    slopes.append(mp.re(slope(point)))
    return f"{math.floor(min(slopes) + mp.mpf('1e-6'))}.0", f"{math.ceil(max(slopes) - mp.mpf('1e-6'))}.0"
