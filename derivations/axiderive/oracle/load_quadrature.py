"""The displacement under a prescribed pressure p_0 (1 - r**2/a**2)**s, (11.104) and (11.105) by quadrature.

With q**2 = r**2 - x**2 (11.104) is w1D(x) = 2 p_0/E* (a**2 - x**2)**(s + 1/2)/a**(2 s) int_0^1 (1 - y**2)**s dy.
"""

from __future__ import annotations

from collections.abc import Mapping

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.profile import Profile
from .evaluate import case_at, evaluate
from .evidence import Evidence, judge, residual
from .integrals import GUARD
from .rules import integrate
from .sampling import points as draw
from .shape import Number, Values, number

EXPONENTS = tuple(sp.Rational(x) for x in ("-9/10", "-3/5", "-1/4", "3/10", "1", "27/10"))
LOST = 10


def check(
    load: Profile, entries: Mapping[str, Entry], suffix: str, *, digits: int = 50, points: int = 6, seed: int = 0
) -> Evidence:
    """Evidence for an entry of a prescribed pressure, at `points` points of every case."""
    entry = entries[suffix]
    drawn = [point for case in entry.cases for point in draw(load, case.chain, points, seed, (nt.E_star,))]
    rows: list[tuple[Values, Number]] = []
    with mp.workdps(digits + GUARD):
        for i, point in enumerate(drawn):
            values = point.values
            if nt.sigma in values:
                values[nt.sigma] = EXPONENTS[i % len(EXPONENTS)]
            s = number(sp.sympify(load.exponent).xreplace(values))  # type: ignore[attr-defined]
            got = evaluate(case_at(entry, values).expr, values, digits)
            rows.append((values, residual(got, displacement(values, s, digits))))
    return judge(
        entry.key,
        "mpmath quadrature of (11.104) and (11.105)",
        rows,
        seed=seed,
        extremes=sum(point.extreme for point in drawn),
        digits=digits,
        required=digits - LOST,
    )


def displacement(values: Values, s: Number, digits: int) -> Number:
    """w(r) inside and outside the loaded circle."""
    a, r = number(values[nt.a]), number(values[nt.r])
    least = min(float(s), -0.5)
    scale = integrate(lambda y: (y * (2 - y)) ** s, mp.mpf(0), mp.mpf(1), (0j, 2 + 0j), digits, least)
    factor = 4 * scale * number(values[nt.p_0]) / (mp.pi * number(values[nt.E_star])) * a ** (-2 * s)
    if r < a:  # x = r sin(v): what is left has its singular points at sin(v) = a/r
        cosh = complex(mp.acosh(a / r))
        away = (mp.pi / 2 + 1j * cosh, mp.pi / 2 - 1j * cosh, -mp.pi / 2 + 1j * cosh, -mp.pi / 2 - 1j * cosh)
        rest = (a - r) * (a + r)

        def inside(v: Number) -> Number:
            return (rest + (r * mp.cos(v)) ** 2) ** (s + mp.mpf(1) / 2)

        return factor * integrate(inside, mp.mpf(0), mp.pi / 2, tuple(complex(z) for z in away), digits)
    # x = a cos(y): the edge of the circle at y = 0
    height = complex(mp.asinh(mp.sqrt((r - a) * (r + a)) / a))
    rest = (r - a) * (r + a)

    def outside(y: Number) -> Number:
        sine = mp.sin(y)
        return (a * sine) ** (2 * s + 1) * a * sine / mp.sqrt(rest + (a * sine) ** 2)

    points = (0j, complex(mp.pi), 1j * height, -1j * height)
    return factor * integrate(outside, mp.mpf(0), mp.pi / 2, points, digits)
