"""The contact that carries the load of an example."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..figures.values import Numbers, Values
from ..oracle.definitions import least
from ..oracle.shape import coefficient, number
from ..profiles.profile import Profile
from .cases import Case
from .shown import DIGITS


def parameters(profile: Profile, case: Case) -> Values:
    """The parameters by symbol; those of a polynomial by their index, A_1 to A_N."""
    if nt.coefficients in profile.parameters:
        found: Values = {coefficient(int(name[2:])): sp.Rational(text) for name, text in case.parameters.items()}
        return found | {nt.N: sp.Integer(len(found))}
    return {nt.describe(name).symbol: sp.Rational(text) for name, text in case.parameters.items()}


def loaded(
    profile: Profile, entries: Mapping[str, Entry], values: Values, case: Case, make: Callable[..., Numbers]
) -> Numbers:
    """The contact that carries the load."""
    load = sp.Rational(case.load)
    if profile.complete:
        if "dF" not in entries:
            return make(profile, entries, values | {nt.P: load}, DIGITS)
        known = values | {nt.F: load}
        return make(profile, entries, known | {nt.d: make(profile, entries, known, DIGITS)("dF")}, DIGITS)
    return make(profile, entries, values | {nt.a: radius_of(profile, entries, values, case, make)}, DIGITS)


def radius_of(
    profile: Profile, entries: Mapping[str, Entry], values: Values, case: Case, make: Callable[..., Numbers]
) -> Any:
    """The contact radius by bisection of its logarithm; the force grows with it."""
    lowest = number(values[profile.breaks[0]]) if profile.truncated else mp.mpf(10) ** -12
    highest = number(values[profile.chain[-1]]) if nt.a in profile.chain else mp.mpf(1)
    with mp.workdps(DIGITS):
        lo, hi = mp.log(lowest * (1 + mp.mpf(10) ** -12)), mp.log(highest * (1 - mp.mpf(10) ** -12))
        for _ in range(60):
            middle = (lo + hi) / 2
            force = make(profile, entries, values | {nt.a: mp.exp(middle)}, DIGITS)("F")
            lo, hi = (middle, hi) if force < case.load else (lo, middle)
        return mp.exp((lo + hi) / 2)


GRID = 24
"""Places of a pressure between two breaks."""


def infinite(profile: Profile, values: Values) -> str:
    """Where the pressure is infinite: at the edge of a face, at a kink of the profile, at a pointed tip, or nowhere."""
    if profile.complete:
        return "a"
    place = nt.x if any(piece.expr.has(nt.x) for piece in profile.pieces) else nt.r
    slopes = [sp.diff(piece.expr.doit() if piece.expr.has(sp.Sum) else piece.expr, place) for piece in profile.pieces]
    if nt.coefficients in profile.parameters:
        return "0" if values[coefficient(1)] > 0 else ""
    if sp.limit(slopes[0].xreplace({s: v for s, v in values.items() if s != place}), place, 0) != 0:
        return "0"
    for b, (inner, outer) in zip(profile.breaks, pairwise(slopes), strict=True):
        if sp.simplify((outer - inner).subs(place, b)) != 0:
            return nt.describe(b).latex
    return ""


def largest(pressure: Callable[[Any], Any], ends: Sequence[Any]) -> Any:
    """The largest of a pressure that is finite between ascending ends."""
    places = [lo + (hi - lo) * (2 * i + 1) / (2 * GRID) for lo, hi in pairwise(ends) for i in range(GRID)]
    places.insert(0, ends[0] + (ends[-1] - ends[0]) * mp.mpf(10) ** -9)
    found = [pressure(place) for place in places]
    best = max(range(len(places)), key=lambda i: found[i])
    lo, hi = places[max(best - 1, 0)], places[min(best + 1, len(places) - 1)]
    return max(found[best], -least(lambda place: -pressure(place), lo, hi))


def pull_off(numbers: Numbers, case: Case) -> Any:
    """The least of F_N(a) - sqrt(8 pi E* dgamma a^3) in the logarithm of the radius."""
    modulus = number(case.material.modulus)

    def force(logarithm: Any) -> Any:
        radius = mp.exp(logarithm)
        return numbers.at(a=radius)("F") - mp.sqrt(8 * mp.pi * modulus * case.material.separation * radius**3)

    with mp.workdps(DIGITS):
        end = mp.log(numbers["a"])
        return least(force, end - 14, end)
